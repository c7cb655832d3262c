// SPDX-License-Identifier: Apache-2.0
//
// Where a target's ray is: its offset after k steps is v*k/L rounded to the nearest integer, ties
// downwards (thesis 4.3.1), given k/L (pace_t.slope). Right for every L up to LMAX. Combinational.

module rc2_place (
    input  logic signed [rc2_pkg::TargetW-1:0] target_i,
    input  logic        [ rc2_pkg::SlopeW-1:0] slope_i,
    output logic signed [   rc2_pkg::OffW-1:0] offset_o
);
  localparam int unsigned SlopeF = rc2_pkg::SlopeF;
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned ProdW = DistanceW + rc2_pkg::SlopeW;
  localparam logic [ProdW-1:0] Half = ProdW'(1) << (SlopeF - 1);

  logic negative;
  logic [DistanceW-1:0] size;
  logic [ProdW-1:0] product, nearest;
  assign negative = target_i[rc2_pkg::TargetW-1];
  assign size = negative ? DistanceW'(-target_i) : DistanceW'(target_i);
  // The slope is at most two units too small. Upwards that is what turns a tie down; downwards a
  // tie must not be missed.
  assign product = ProdW'(size) * ProdW'(slope_i) + (negative ? ProdW'({size, 1'b0}) : '0);
  assign nearest = (product + (negative ? Half : Half - 1'b1)) >> SlopeF;
  assign offset_o = negative ? -$signed(rc2_pkg::OffW'(nearest)) : $signed(rc2_pkg::OffW'(nearest));
endmodule
