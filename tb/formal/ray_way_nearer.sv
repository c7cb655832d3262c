// SPDX-License-Identifier: Apache-2.0
//
// rc2_ray_way: a message goes one way, or is there; each step brings it nearer to where it is going by one
// cell, and it does not turn to y before it is in its column.

module ray_way_nearer (
    input logic [rc2_pkg::CoordW-1:0] x_i,
    input logic [rc2_pkg::CoordW-1:0] y_i,
    input logic [rc2_pkg::CoordW-1:0] to_x_i,
    input logic [rc2_pkg::CoordW-1:0] to_y_i,
    input logic                       valid_i
);
  localparam int unsigned W = rc2_pkg::CoordW + 2;
  logic [4:0] way;
  rc2_ray_way u_way (
      .x_i    (x_i),
      .y_i    (y_i),
      .to_x_i (to_x_i),
      .to_y_i (to_y_i),
      .valid_i(valid_i),
      .way_o  (way)
  );

  logic signed [W-1:0] x, y, next_x, next_y, to_x, to_y;
  assign x = $signed(W'(x_i));
  assign y = $signed(W'(y_i));
  assign to_x = $signed(W'(to_x_i));
  assign to_y = $signed(W'(to_y_i));
  assign next_x = way[0] ? x + 1 : way[1] ? x - 1 : x;
  assign next_y = way[2] ? y + 1 : way[3] ? y - 1 : y;
  logic signed [W-1:0] far_x, far_y, then_x, then_y;
  assign far_x = (to_x < x) ? x - to_x : to_x - x;
  assign far_y = (to_y < y) ? y - to_y : to_y - y;
  assign then_x = (to_x < next_x) ? next_x - to_x : to_x - next_x;
  assign then_y = (to_y < next_y) ? next_y - to_y : to_y - next_y;
  always_comb begin
    assert ((way & (way - 1'b1)) == 0);
    assert ((way != 0) == valid_i);
    assert (way[4] == (valid_i && far_x == 0 && far_y == 0));
    if (way[3:0] != 0) assert (then_x + then_y + 1 == far_x + far_y);
    if (way[3:2] != 0) assert (far_x == 0);
  end
endmodule
