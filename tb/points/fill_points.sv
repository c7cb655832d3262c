// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_fill: claims of every kind against every kind of owner. Armour comes
// before guards (sw/facet/layers.h), so it meets none.

module fill_points (
    input logic                         clk_i,
    input logic                         rst_ni,
    input logic                         valid_i,
    input logic                         ready_o,
    input logic                         seeks,
    input logic                         writing_q,
    input logic                         write_o,
    input logic                         guard_o,
    input logic [  rc2_pkg::LayerW-1:0] written_layer_q,
    input logic [  rc2_pkg::CoordW-1:0] written_z_q,
    input logic [       rc2_pkg::N-1:0] occupied_i,
    input logic [       rc2_pkg::N-1:0] guard_i,
    input rc2_pkg::claim_t              written_q,
    input rc2_pkg::claim_t              read_owner_i,
    input rc2_pkg::plane_t              written_plane_q
);
  logic armour, guard, occupied;
  assign armour = rst_ni && writing_q && written_layer_q == rc2_pkg::LayerArmour;
  assign guard = rst_ni && writing_q && written_layer_q == rc2_pkg::LayerGuard;
  assign occupied = occupied_i[written_z_q];
  for (genvar surface = 0; surface < 3; surface++) begin : g_surface
    always_ff @(posedge clk_i) begin
      owns : cover (write_o && written_plane_q.surface == surface);
      guards : cover (guard_o && written_plane_q.surface == surface);
    end
  end
  for (genvar bits = 0; bits < 4; bits++) begin : g_claim  // {behind, not in the core}
    always_ff @(posedge clk_i) made : cover (armour && {written_q.behind, written_q.not_core} == bits);
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      free_voxel : cover (armour && !occupied);
      better_than_the_owner : cover (armour && occupied && write_o);
      owner_is_better : cover (armour && occupied && !write_o);
      owner_has_the_better_core : cover (armour && occupied && !write_o && !read_owner_i.not_core && written_q.not_core);
      owner_is_nearer : cover (armour && occupied && !write_o && read_owner_i.not_core == written_q.not_core &&
                               read_owner_i.distance < written_q.distance);
      owner_has_the_lower_number : cover (armour && occupied && !write_o && read_owner_i.not_core == written_q.not_core &&
                                          read_owner_i.distance == written_q.distance);
      guard_of_an_occupied_voxel : cover (guard && occupied);
      first_guard : cover (guard && !occupied && !guard_i[written_z_q]);
      better_guard : cover (guard && guard_o && guard_i[written_z_q]);
      guard_is_better : cover (guard && !occupied && !guard_o);
      seeks_a_gap : cover (valid_i && ready_o && seeks);
      needs_no_gap : cover (valid_i && ready_o && !seeks);
      dexel_waits : cover (valid_i && !ready_o);
    end
  end
endmodule

bind rc2_fill fill_points u_points (.*);
