// SPDX-License-Identifier: Apache-2.0
//
// Division, Step bits of the quotient in each cycle, one restoring subtraction after another:
// floor(num / div), all ones if that has more than QuotW bits (or div is 0). What was given in the
// cycle of start_i takes the Steps cycles after it; done_o is high in the last of them, and from the
// next on the quotient stays.

module rc2_divide #(
    parameter int unsigned NumW = 16,
    parameter int unsigned DivW = 8,
    parameter int unsigned QuotW = 8,
    parameter int unsigned Step = 1
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             start_i,
    input  logic [ NumW-1:0] num_i,
    input  logic [ DivW-1:0] div_i,
    output logic             done_o,
    output logic [QuotW-1:0] quot_o,
    output logic             rest_o   // the division leaves a rest, if the quotient is no larger
);
  localparam int unsigned Steps = (QuotW + Step - 1) / Step;
  localparam int unsigned BitsW = Steps * Step;  // of the quotient: the first of them may be 0 always
  localparam int unsigned WideW = BitsW + ((NumW > BitsW + DivW) ? NumW - BitsW : DivW);
  localparam int unsigned LeftW = $clog2(Steps + 1);

  // What is left of the number, and below it the bits that have not come down yet; from below the
  // quotient's follow them.
  logic [LeftW-1:0] left_q;
  logic [DivW-1:0] div_q;
  logic [DivW-1:0] rest_q, rest;
  logic [BitsW-1:0] down_q, down;
  logic over_q;  // the quotient has more bits
  logic [WideW-1:0] wide;
  logic [WideW-1:0] too_large;
  assign wide = WideW'(num_i);
  assign too_large = WideW'(div_i) << QuotW;

  logic [DivW:0] trial, less;
  always_comb begin
    rest = rest_q;
    down = down_q;
    trial = '0;
    less = '0;
    for (int i = 0; i < Step; i++) begin
      trial = {rest, down[BitsW-1]};
      less = trial - {1'b0, div_q};
      rest = less[DivW] ? trial[DivW-1:0] : less[DivW-1:0];
      down = {down[BitsW-2:0], !less[DivW]};
    end
  end

  assign done_o = (left_q == LeftW'(1));
  assign quot_o = over_q ? '1 : down_q[QuotW-1:0];
  assign rest_o = (rest_q != 0);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) left_q <= '0;
    else if (start_i) left_q <= LeftW'(Steps);
    else if (left_q != 0) left_q <= left_q - 1'b1;
    if (start_i) begin
      div_q  <= div_i;
      rest_q <= wide[BitsW+:DivW];
      down_q <= wide[BitsW-1:0];
      over_q <= (wide >= too_large);
    end else if (left_q != 0) begin
      rest_q <= rest;
      down_q <= down;
    end
  end

  // Contract: one division at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni && start_i) assert (left_q <= LeftW'(1));
  end
endmodule
