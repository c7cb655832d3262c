// SPDX-License-Identifier: Apache-2.0
//
// rc2_divide: the quotient of any two numbers, rounded down, or all ones if it has more bits than asked for;
// whether there is a rest; after as many cycles as steps, and both stay. The division starts in the second
// cycle, from any state, and is over Steps cycles later, so the bound is complete.

module divide_exact #(
    parameter int unsigned NumW = 8,
    parameter int unsigned DivW = 4,
    parameter int unsigned QuotW = 6,
    parameter int unsigned Step = 1,
    localparam int unsigned Steps = (QuotW + Step - 1) / Step,
    localparam int unsigned WideW = NumW + QuotW + DivW
) (
    input logic clk_i,
    input logic [NumW-1:0] any_num_i,
    input logic [DivW-1:0] any_div_i
);
  logic [3:0] cycle_q = 4'd0;
  always_ff @(posedge clk_i) if (cycle_q != 4'hf) cycle_q <= cycle_q + 1'b1;

  (* anyconst *) logic [NumW-1:0] num;
  (* anyconst *) logic [DivW-1:0] div;
  logic start, done, rest;
  logic [QuotW-1:0] quot;
  assign start = (cycle_q == 4'd1);
  rc2_divide #(
      .NumW (NumW),
      .DivW (DivW),
      .QuotW(QuotW),
      .Step (Step)
  ) u_divide (
      .clk_i  (clk_i),
      .rst_ni (cycle_q != 0),
      .start_i(start),
      .num_i  (start ? num : any_num_i),
      .div_i  (start ? div : any_div_i),
      .done_o (done),
      .quot_o (quot),
      .rest_o (rest)
  );
  logic [WideW-1:0] most, true_quot;
  assign most = (WideW'(1) << QuotW) - 1'b1;
  assign true_quot = WideW'(num) / WideW'(div);
  always_comb begin
    if (cycle_q > 4'd1) assert (done == (cycle_q == 4'(Steps) + 4'd1));
    if (cycle_q > 4'(Steps) + 4'd1) begin
      if (div == 0 || true_quot > most) assert (WideW'(quot) == most);
      else begin
        assert (WideW'(quot) == true_quot);
        assert (rest == (true_quot * WideW'(div) != WideW'(num)));
      end
    end
  end
endmodule
