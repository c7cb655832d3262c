// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_extents: all nine places of a cell seen from the light, with and
// without anything to meet.

module extents_points (
    input logic                      clk_i,
    input logic                      rst_ni,
    input logic                      fill_i,
    input logic [rc2_pkg::CoordW-1:0] fill_z_i,
    input logic [rc2_pkg::CoordW-1:0] min_q,
    input logic [rc2_pkg::CoordW-1:0] max_q,
    input logic                      east_i,
    input logic                      west_i,
    input logic                      north_i,
    input logic                      south_i,
    input logic [rc2_pkg::CoordW-1:0] away_min,
    input logic [rc2_pkg::CoordW-1:0] away_max
);
  for (genvar x = 0; x < 3; x++) begin : g_x  // 0: west of the light
    for (genvar y = 0; y < 3; y++) begin : g_y  // 0: south of it
      logic here;
      assign here = rst_ni && (x == 0 ? west_i : x == 2 ? east_i : !west_i && !east_i) &&
                    (y == 0 ? south_i : y == 2 ? north_i : !south_i && !north_i);
      always_ff @(posedge clk_i) begin
        something : cover (here && away_min <= away_max);
        nothing : cover (here && away_min > away_max);
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      first_voxel : cover (fill_i && min_q > max_q);
      lower_voxel : cover (fill_i && min_q <= max_q && fill_z_i < min_q);
      higher_voxel : cover (fill_i && min_q <= max_q && fill_z_i > max_q);
      voxel_between : cover (fill_i && fill_z_i >= min_q && fill_z_i <= max_q);
    end
  end
endmodule

bind rc2_extents extents_points u_points (.*);
