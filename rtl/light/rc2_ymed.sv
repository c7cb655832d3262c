// SPDX-License-Identifier: Apache-2.0
//
// Where a beam splits (thesis 4.3.1.2): Y_med = (2w+1)*L / (2*(k+1)), rounded down and up.
// A cell at step k and offset w >= 0 keeps the targets up to floor(Y_med) and sends the others one
// cell outward; at offset -w it keeps those from 1 - ceil(Y_med) on, so that both sides round the
// digital ray's ties down. Combinational; no divider.
//
// The quotient is exact: the reciprocal m = ceil(2^S / 2(k+1)) with 2^S >= p_max * 2N turns
// p = (2w+1)*L into p/2(k+1) + e with 0 <= e < 1/2N, too little to reach the next integer; and the
// fraction stays below p_max exactly when the quotient is an integer.

module rc2_ymed (
    input  logic [   rc2_pkg::CoordW-1:0] offset_i,    // w = 0 .. N-1
    input  logic [   rc2_pkg::CountW-1:0] step_i,      // k+1 = 1 .. N
    input  logic [rc2_pkg::DistanceW-1:0] distance_i,  // L = 1 .. LMAX
    output logic [rc2_pkg::DistanceW-1:0] floor_o,     // meaningful while w <= k
    output logic [rc2_pkg::DistanceW-1:0] ceil_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned ProdW = $clog2((2 * N - 1) * rc2_pkg::LMAX + 1);  // p
  localparam int unsigned FracW = ProdW + $clog2(2 * N);                    // S
  localparam int unsigned FullW = ProdW + FracW;

  logic [FracW-1:0] reciprocal;
  logic [ProdW-1:0] product;
  logic [FullW-1:0] scaled;
  logic exact;

  rc2_half #(
      .Most (N),
      .FracW(FracW)
  ) u_half (
      .k_i   (step_i),
      .half_o(reciprocal)
  );
  assign product = ProdW'({offset_i, 1'b1}) * ProdW'(distance_i);
  assign scaled = FullW'(product) * FullW'(reciprocal);
  assign exact = (scaled[FracW-1:ProdW] == 0);
  assign floor_o = scaled[FracW+rc2_pkg::DistanceW-1:FracW];
  assign ceil_o = floor_o + (exact ? '0 : rc2_pkg::DistanceW'(1));
endmodule
