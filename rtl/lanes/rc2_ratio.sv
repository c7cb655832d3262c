// SPDX-License-Identifier: Apache-2.0
//
// L/2k for the steps k of a light, with RatioF fraction bits, less than two units too large: times
// an odd number up to 2N-1 it is too large by less than 1/2N, too little to reach the next integer
// (Y_med of thesis 4.3.1 is a multiple of 1/2k). Latency one cycle for k, none for L.

module rc2_ratio (
    input  logic                             clk_i,
    input  logic [   rc2_pkg::CountW-1:0] step_i,      // k = 3 .. N
    input  logic [rc2_pkg::DistanceW-1:0] distance_i,  // L
    output logic [   rc2_pkg::RatioW-1:0] ratio_o      // of the step in the cycle before
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned RatioW = rc2_pkg::RatioW;
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned FracW = rc2_pkg::RatioF + DistanceW;

  logic [FracW-1:0] half, half_q;
  rc2_half #(
      .Most (N),
      .FracW(FracW)
  ) u_half (
      .k_i   (step_i),
      .half_o(half)
  );
  always_ff @(posedge clk_i) half_q <= half;

  logic [FracW+DistanceW-1:0] product;
  assign product = (FracW + DistanceW)'(half_q) * (FracW + DistanceW)'(distance_i);
  assign ratio_o = RatioW'(product[FracW+DistanceW-1:DistanceW]) +
                   RatioW'(product[DistanceW-1:0] != 0);
endmodule
