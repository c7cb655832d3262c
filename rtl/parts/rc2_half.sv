// SPDX-License-Identifier: Apache-2.0
//
// A table of 1/2k for k = 1 .. Most, with FracW fraction bits, rounded up; entry 0 is 0.
// Combinational.

module rc2_half #(
    parameter  int unsigned Most   = 16,
    parameter  int unsigned FracW  = 16,
    localparam int unsigned IndexW = $clog2(Most + 1)
) (
    input  logic [IndexW-1:0] k_i,
    output logic [ FracW-1:0] half_o
);
  localparam int unsigned Entries = 1 << IndexW;

  // Entry k from bit k*FracW on, by long division, so that no tool's integers limit it.
  function automatic logic [Entries*FracW-1:0] halves();
    logic [FracW:0] quotient, rest, divisor;
    integer k, i;
    begin
      halves = 0;
      divisor = 0;
      for (k = 1; k <= Most; k = k + 1) begin
        divisor = divisor + 2;
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
        halves[k*FracW+:FracW] = quotient[FracW-1:0];
      end
    end
  endfunction
  localparam logic [Entries*FracW-1:0] Halves = halves();

  assign half_o = Halves[k_i*FracW+:FracW];
endmodule
