// SPDX-License-Identifier: Apache-2.0
//
// rc2_half against the definition of a number rounded up: half * 2k is 2^FracW or as little more as it
// can be, for every k; k = 0 gives 0.

module half_table #(
    parameter int unsigned Most = 16,
    parameter int unsigned FracW = 16,
    localparam int unsigned IndexW = $clog2(Most + 1)
) (
    input logic [IndexW-1:0] k_i
);
  localparam int unsigned WideW = FracW + IndexW + 2;
  logic [FracW-1:0] half;
  rc2_half #(
      .Most (Most),
      .FracW(FracW)
  ) u_half (
      .k_i   (k_i),
      .half_o(half)
  );
  logic [WideW-1:0] twice, product;
  assign twice = {{(WideW - IndexW - 1) {1'b0}}, k_i, 1'b0};
  assign product = WideW'(half) * twice;
  always_comb begin
    assume (k_i <= IndexW'(Most));
    if (k_i == 0) assert (half == 0);
    else begin
      assert (product >= (WideW'(1) << FracW));
      assert (product < (WideW'(1) << FracW) + twice);
    end
  end
endmodule
