// SPDX-License-Identifier: Apache-2.0
//
// Which targets are where (thesis 4.3.1, Y_med = (2w+1)*L / 2k): the last target whose ray is at
// offset w or below after k steps, ties downwards, given odd = 2w+1 and L/2k (rc2_ratio). Right for
// -k <= w < k. Combinational.

module rc2_border (
    input  logic signed [rc2_pkg::CoordW + 2-1:0] odd_i,
    input  logic        [rc2_pkg::RatioW-1:0] ratio_i,
    output logic signed [rc2_pkg::StopW-1:0] last_o
);
  localparam int unsigned OddW = rc2_pkg::CoordW + 2;
  localparam int unsigned BorderW = rc2_pkg::StopW;
  localparam int unsigned RatioF = rc2_pkg::RatioF;
  localparam int unsigned SizeW = rc2_pkg::CoordW + 1;
  localparam int unsigned ProdW = SizeW + rc2_pkg::RatioW;

  logic negative, exact;
  logic [OddW-1:0] size;
  logic [ProdW-1:0] product;
  logic [BorderW-1:0] quotient;
  assign negative = odd_i[OddW-1];
  assign size = negative ? $unsigned(-odd_i) : $unsigned(odd_i);
  assign product = ProdW'(size[SizeW-1:0]) * ProdW'(ratio_i);
  assign quotient = BorderW'(product[ProdW-1:RatioF]);
  // What the ratio is too large shows in the lowest bits only.
  assign exact = (product[RatioF-1-:rc2_pkg::CoordW+1] == 0);
  assign last_o = negative ? ~quotient + BorderW'(exact) : quotient;
endmodule
