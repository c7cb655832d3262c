// SPDX-License-Identifier: Apache-2.0
//
// Square root, rounded down, a bit in each cycle: two bits of the square are brought down, and the
// root so far, with 01 behind it, is taken away if it can be. What was given in the cycle of start_i
// takes the RootW cycles after it; done_o is high in the last of them, from the next on the root stays.

module rc2_root #(
    parameter int unsigned RootW = 8
) (
    input  logic               clk_i,
    input  logic               rst_ni,
    input  logic               start_i,
    input  logic [2*RootW-1:0] square_i,
    output logic               done_o,
    output logic [  RootW-1:0] root_o
);
  localparam int unsigned LeftW = $clog2(RootW + 1);
  logic [LeftW-1:0] left_q;
  logic [2*RootW-1:0] square_q;
  logic [RootW-1:0] root_q;
  logic [RootW-1:0] rest_q;  // at most twice a root that still lacks a bit
  logic [RootW+1:0] down, trial;
  logic fits;

  assign down = {rest_q, square_q[2*RootW-1-:2]};
  assign trial = {root_q, 2'b01};
  assign fits = (down >= trial);
  assign done_o = (left_q == LeftW'(1));
  assign root_o = root_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) left_q <= '0;
    else if (start_i) left_q <= LeftW'(RootW);
    else if (left_q != 0) left_q <= left_q - 1'b1;
    if (start_i) begin
      square_q <= square_i;
      root_q   <= '0;
      rest_q   <= '0;
    end else if (left_q != 0) begin
      square_q <= square_q << 2;
      root_q   <= {root_q[RootW-2:0], fits};
      rest_q   <= RootW'(fits ? down - trial : down);
    end
  end

  // Contract: one root at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni && start_i) assert (left_q == 0);
  end
endmodule
