// SPDX-License-Identifier: Apache-2.0
//
// The way of a message to another cell, one axis after the other: x first. Combinational.

module rc2_ray_way (
    input  logic [rc2_pkg::CoordW-1:0] x_i,
    input  logic [rc2_pkg::CoordW-1:0] y_i,
    input  logic [rc2_pkg::CoordW-1:0] to_x_i,
    input  logic [rc2_pkg::CoordW-1:0] to_y_i,
    input  logic                       valid_i,
    output logic [                4:0] way_o  // a bit for east, west, north, south, here; or none
);
  logic same_x;
  assign same_x = (to_x_i == x_i);
  assign way_o[0] = valid_i && (to_x_i > x_i);
  assign way_o[1] = valid_i && (to_x_i < x_i);
  assign way_o[2] = valid_i && same_x && (to_y_i > y_i);
  assign way_o[3] = valid_i && same_x && (to_y_i < y_i);
  assign way_o[4] = valid_i && same_x && (to_y_i == y_i);
endmodule
