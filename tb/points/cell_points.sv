// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_cell: z fronts from all eight neighbours.

module cell_points (
    input logic                        clk_i,
    input logic                        rst_ni,
    input logic                        east,
    input logic                        west,
    input logic                        north,
    input logic                        south,
    input logic [rc2_pkg::MatrixW-1:0] from_x,
    input logic [rc2_pkg::MatrixW-1:0] from_y,
    input logic [rc2_pkg::MatrixW-1:0] from_xy
);
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      z_from_e : cover (west && from_x != 0);
      z_from_ne : cover (west && south && from_xy != 0);
      z_from_n : cover (south && from_y != 0);
      z_from_nw : cover (east && south && from_xy != 0);
      z_from_w : cover (east && from_x != 0);
      z_from_sw : cover (east && north && from_xy != 0);
      z_from_s : cover (north && from_y != 0);
      z_from_se : cover (west && north && from_xy != 0);
    end
  end
endmodule

bind rc2_cell cell_points u_points (.*);
