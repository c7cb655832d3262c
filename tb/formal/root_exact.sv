// SPDX-License-Identifier: Apache-2.0
//
// rc2_root: the root of any number, rounded down, after as many cycles as it has steps; it stays. The root
// starts in the second cycle, from any state, so the bound is complete.

module root_exact #(
    parameter int unsigned RootW = 6,
    parameter int unsigned Step = 1,
    localparam int unsigned Steps = (RootW + Step - 1) / Step
) (
    input logic clk_i,
    input logic [2*RootW-1:0] any_square_i
);
  logic [4:0] cycle_q = 5'd0;
  always_ff @(posedge clk_i) if (cycle_q != 5'h1f) cycle_q <= cycle_q + 1'b1;

  (* anyconst *) logic [2*RootW-1:0] square;
  logic start, done;
  logic [RootW-1:0] root;
  assign start = (cycle_q == 5'd1);
  rc2_root #(
      .RootW(RootW),
      .Step (Step)
  ) u_root (
      .clk_i   (clk_i),
      .rst_ni  (cycle_q != 0),
      .start_i (start),
      .square_i(start ? square : any_square_i),
      .done_o  (done),
      .root_o  (root)
  );

  logic [2*RootW+1:0] low, high;
  assign low = (2 * RootW + 2)'(root);
  assign high = low + 1'b1;
  always_comb begin
    if (cycle_q > 5'd1) assert (done == (cycle_q == 5'(Steps) + 5'd1));
    if (cycle_q > 5'(Steps) + 5'd1)
      assert (low * low <= (2 * RootW + 2)'(square) && (2 * RootW + 2)'(square) < high * high);
  end
endmodule
