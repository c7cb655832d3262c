// SPDX-License-Identifier: Apache-2.0
//
// A ray as it goes on to the next column: two additions (thesis 2.3). Combinational.

module rc2_ray_step (
    input  rc2_pkg::ray_t                ray_i,
    input  logic [  rc2_pkg::CoordW-1:0] z_i,        // at which it leaves the column
    input  logic                          along_y_i,  // through its side in y
    output rc2_pkg::ray_t                ray_o
);
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned DecisionW = rc2_pkg::DecisionW;

  rc2_pkg::start_t start;
  logic signed [DecisionW-1:0] wide_x, wide_y, size_x, size_y;
  assign start = ray_i.start;
  assign wide_x = DecisionW'($signed(start.dx));
  assign wide_y = DecisionW'($signed(start.dy));
  assign size_x = start.dx[DirW-1] ? -wide_x : wide_x;
  assign size_y = start.dy[DirW-1] ? -wide_y : wide_y;
  always_comb begin
    ray_o = ray_i;
    ray_o.along_y = along_y_i;
    ray_o.z = z_i;
    ray_o.decision = along_y_i ? ray_i.decision - $unsigned(size_x <<< PlaceFracW)
                               : ray_i.decision + $unsigned(size_y <<< PlaceFracW);
    if (along_y_i) ray_o.exit_y = ray_i.exit_y + ray_i.slope_y;
    else ray_o.exit_x = ray_i.exit_x + ray_i.slope_x;
  end
endmodule
