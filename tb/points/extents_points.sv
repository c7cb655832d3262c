// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_extents: all places of a cell seen from the light, with and without
// anything in the quadrants away from it; voxels above and below the light, near and far from it; and
// what it comes to know.

module extents_points (
    input logic                      clk_i,
    input logic                      rst_ni,
    input logic                      fill_i,
    input logic [rc2_pkg::CoordW-1:0] fill_z_i,
    input logic                      own_q,
    input logic [rc2_pkg::CoordW-1:0] min_q,
    input logic [rc2_pkg::CoordW-1:0] max_q,
    input logic                      start_i,
    input logic                      active_i,
    input logic                      east_i,
    input logic                      west_i,
    input logic                      north_i,
    input logic                      south_i,
    input logic                      wide_i,
    input logic                      tall_i,
    input logic                      anything,
    input logic                      low_taken_q,
    input logic                      below,
    input logic                      outer,
    input logic                      joins,
    input logic                      source,
    input logic                      half_q,
    input logic [2:0]                at_q,
    input logic                      none_q,
    input logic                      tilt_below,
    input logic                      tilt_outer,
    input logic [rc2_pkg::TiltSizeW-1:0] tilt_size,
    input logic [rc2_pkg::CoordW-1:0] min_o,
    input logic [rc2_pkg::CoordW-1:0] max_o
);
  for (genvar x = 0; x < 3; x++) begin : g_x  // 0: west of the light
    for (genvar y = 0; y < 3; y++) begin : g_y  // 0: south of it
      logic here;
      assign here = rst_ni && (x == 0 ? west_i : x == 2 ? east_i : !west_i && !east_i) &&
                    (y == 0 ? south_i : y == 2 ? north_i : !south_i && !north_i);
      always_ff @(posedge clk_i) begin
        something : cover (here && active_i && anything);
        nothing : cover (here && active_i && !anything);
      end
      if (x != 1 && y != 1) begin : g_corner
        always_ff @(posedge clk_i) begin
          joins_wide : cover (here && joins && wide_i);
          joins_tall : cover (here && joins && tall_i);
          joins_diagonal : cover (here && joins && !wide_i && !tall_i);
        end
      end else if (x != y) begin : g_axis
        always_ff @(posedge clk_i) joins_on_axis : cover (here && joins);
      end else begin : g_source
        always_ff @(posedge clk_i) begin
          joins_east : cover (here && joins && source && !half_q);
          joins_west : cover (here && joins && source && half_q);
        end
      end
    end
  end
  for (genvar down = 0; down < 2; down++) begin : g_below
    for (genvar away = 0; away < 2; away++) begin : g_outer
      always_ff @(posedge clk_i) begin
        if (rst_ni) begin
          voxel : cover (own_q && (start_i || low_taken_q) && below == (down == 1) && outer == (away == 1));
          layer : cover (active_i && at_q[0] && !at_q[2] && tilt_below == (down == 1) && tilt_outer == (away == 1));
        end
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      first_voxel : cover (fill_i && !own_q);
      lower_voxel : cover (fill_i && own_q && fill_z_i < min_q);
      higher_voxel : cover (fill_i && own_q && fill_z_i > max_q);
      voxel_between : cover (fill_i && own_q && fill_z_i >= min_q && fill_z_i <= max_q);
      any_tilt : cover (active_i && at_q[0] && !at_q[2] && tilt_outer && tilt_size == '1);
      knows_nothing_more : cover (at_q[2] && none_q && anything);
      knows_from_below : cover (at_q[2] && min_o != 0);
      knows_from_above : cover (at_q[2] && 32'(max_o) != rc2_pkg::N - 1);
          end
  end
endmodule

bind rc2_extents extents_points u_points (.*);
