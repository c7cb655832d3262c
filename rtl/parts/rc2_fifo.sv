// SPDX-License-Identifier: Apache-2.0
//
// First in, first out. The oldest word is on data_o whenever count_o is not 0.
// Latency one cycle, one word in and one out per cycle; a full queue takes a word in the cycle in
// which it gives one up. Thesis 4.4.1 (FA) and every buffer deeper than one.

module rc2_fifo #(
    parameter int unsigned Width = 8,
    parameter int unsigned Depth = 2,
    localparam int unsigned CountW = $clog2(Depth + 1)
) (
    input  logic              clk_i,
    input  logic              rst_ni,
    input  logic              push_i,
    input  logic [ Width-1:0] data_i,
    input  logic              pop_i,
    output logic [ Width-1:0] data_o,
    output logic [CountW-1:0] count_o
);
  localparam int unsigned PtrW = (Depth <= 1) ? 1 : $clog2(Depth);
  localparam logic [PtrW-1:0] Last = PtrW'(Depth - 1);

  logic [Width-1:0] mem_q[0:Depth-1];
  logic [PtrW-1:0] head_q, tail_q;
  logic [CountW-1:0] count_q;

  assign data_o  = mem_q[head_q];
  assign count_o = count_q;

  always_ff @(posedge clk_i) begin
    if (push_i) mem_q[tail_q] <= data_i;
    if (!rst_ni) begin
      head_q  <= '0;
      tail_q  <= '0;
      count_q <= '0;
    end else begin
      if (push_i) tail_q <= (tail_q == Last) ? '0 : tail_q + 1'b1;
      if (pop_i) head_q <= (head_q == Last) ? '0 : head_q + 1'b1;
      if (push_i && !pop_i) count_q <= count_q + 1'b1;
      if (pop_i && !push_i) count_q <= count_q - 1'b1;
    end
  end

  // Contract: never more than Depth words, never a word out of nothing.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(pop_i && count_q == 0));
      assert (!(push_i && !pop_i && count_q == CountW'(Depth)));
      assert (count_q <= CountW'(Depth));
    end
  end
endmodule
