// SPDX-License-Identifier: Apache-2.0
//
// Square root, rounded down, Step bits in each cycle. For each, two bits of the square are brought
// down, and the root so far, with 01 behind it, is taken away if it can be. What was given in the cycle
// of start_i takes the RootW / Step cycles after it, rounded up; done_o is high in the last of them,
// from the next on the root stays.

module rc2_root #(
    parameter int unsigned RootW = 8,
    parameter int unsigned Step = 1
) (
    input  logic               clk_i,
    input  logic               rst_ni,
    input  logic               start_i,
    input  logic [2*RootW-1:0] square_i,
    output logic               done_o,
    output logic [  RootW-1:0] root_o
);
  localparam int unsigned Steps = (RootW + Step - 1) / Step;
  localparam int unsigned BitsW = Steps * Step;  // of the root: the first of them may be 0 always
  localparam int unsigned LeftW = $clog2(Steps + 1);
  logic [LeftW-1:0] left_q;
  logic [2*BitsW-1:0] square_q, square;
  logic [BitsW-1:0] root_q, root;
  logic [BitsW-1:0] rest_q, rest;  // at most twice a root that still lacks a bit
  logic [BitsW+1:0] down, trial;
  logic fits;

  always_comb begin
    square = square_q;
    root = root_q;
    rest = rest_q;
    down = '0;
    trial = '0;
    fits = 1'b0;
    for (int i = 0; i < Step; i++) begin
      down = {rest, square[2*BitsW-1-:2]};
      trial = {root, 2'b01};
      fits = (down >= trial);
      square = square << 2;
      root = {root[BitsW-2:0], fits};
      rest = BitsW'(fits ? down - trial : down);
    end
  end
  assign done_o = (left_q == LeftW'(1));
  assign root_o = root_q[RootW-1:0];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) left_q <= '0;
    else if (start_i) left_q <= LeftW'(Steps);
    else if (left_q != 0) left_q <= left_q - 1'b1;
    if (start_i) begin
      square_q <= (2 * BitsW)'(square_i);
      root_q   <= '0;
      rest_q   <= '0;
    end else if (left_q != 0) begin
      square_q <= square;
      root_q   <= root;
      rest_q   <= rest;
    end
  end

  // Contract: one root at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni && start_i) assert (left_q <= LeftW'(1));
  end
endmodule
