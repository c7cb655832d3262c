// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_z_lanes: both lanes passing, stopped and dropped, and fronts that
// join, their own and those from all sides.

module z_lanes_points (
    input logic                                clk_i,
    input logic                                rst_ni,
    input rc2_pkg::pace_t                      pace_i,
    input logic                                reached_o,
    input logic                                stopped_o,
    input logic                                dropped_o,
    input logic         [rc2_pkg::MatrixW-1:0] own,
    input logic         [rc2_pkg::MatrixW-1:0] x_o,
    input logic         [rc2_pkg::MatrixW-1:0] y_o,
    input logic         [rc2_pkg::MatrixW-1:0] xy_o,
    input logic         [rc2_pkg::MatrixW-1:0] x_i,
    input logic         [rc2_pkg::MatrixW-1:0] y_i,
    input logic         [rc2_pkg::MatrixW-1:0] xy_i,
    input logic         [rc2_pkg::MatrixW-1:0] next,
    input logic         [rc2_pkg::CoordW-1:0] z_o
);
  logic gets;
  assign gets = rst_ni && pace_i.on && next != 0;
  for (genvar lane = 0; lane < 2; lane++) begin : g_lane  // 0 upwards, 1 downwards
    logic here;
    assign here = rst_ni && (pace_i.first == (lane == 0));
    always_ff @(posedge clk_i) begin
      passes : cover (here && reached_o && !stopped_o);
      is_stopped : cover (here && stopped_o);
      leaves_the_cube : cover (here && reached_o && !stopped_o && pace_i.last);
    end
    if (rc2_pkg::SKIPS) begin : g_skips
      always_ff @(posedge clk_i) dropped : cover (here && dropped_o);
    end
  end
  for (genvar z = 0; z < rc2_pkg::N; z++) begin : g_layer
    always_ff @(posedge clk_i) reached : cover (rst_ni && reached_o && z_o == z);
  end
  // {diagonally, along y, along x, stays}: what a front is split into and what it is joined of.
  for (genvar parts = 1; parts < 16; parts++) begin : g_parts
    always_ff @(posedge clk_i) begin
      split : cover (rst_ni && {xy_o != 0, y_o != 0, x_o != 0, own != 0} == parts);
      joined : cover (gets && {xy_i != 0, y_i != 0, x_i != 0, own != 0} == parts);
    end
  end
endmodule

bind rc2_z_lanes z_lanes_points u_points (.*);
