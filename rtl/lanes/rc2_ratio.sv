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
  localparam int unsigned Entries = 1 << rc2_pkg::CountW;

  // 1/2k rounded up, entry k from bit k*FracW on.
  function automatic logic [Entries*FracW-1:0] reciprocals();
    logic [FracW:0] quotient, rest, divisor;
    integer k, i;
    begin
      reciprocals = 0;
      for (k = 3; k <= N; k = k + 1) begin
        // Long division, so that no tool's integers limit it.
        divisor = 0;
        for (i = 0; i < 2 * k; i = i + 1) divisor = divisor + 1;
        quotient = 0;
        rest = 1;
        for (i = 0; i < FracW; i = i + 1) begin
          rest = rest << 1;
          quotient = quotient << 1;
          if (rest >= divisor) begin
            rest = rest - divisor;
            quotient = quotient + 1;
          end
        end
        if (rest != 0) quotient = quotient + 1;
        reciprocals[k*FracW+:FracW] = quotient[FracW-1:0];
      end
    end
  endfunction
  localparam logic [Entries*FracW-1:0] Reciprocals = reciprocals();

  logic [FracW-1:0] reciprocal_q;
  always_ff @(posedge clk_i) reciprocal_q <= Reciprocals[step_i*FracW+:FracW];

  logic [FracW+DistanceW-1:0] product;
  assign product = (FracW + DistanceW)'(reciprocal_q) * (FracW + DistanceW)'(distance_i);
  assign ratio_o = RatioW'(product[FracW+DistanceW-1:DistanceW]) +
                   RatioW'(product[DistanceW-1:0] != 0);
endmodule
