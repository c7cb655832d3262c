// SPDX-License-Identifier: Apache-2.0
//
// rc2_fifo against a queue that shifts: the same words in the same order, the same number.
// Induction goes through because every word of the ring is tied to its place in the shifted queue
// and the tail to head plus count. Words are of one bit: the unit never looks at them.

module fifo_order #(
    parameter int unsigned Depth = 4,
    localparam int unsigned CountW = $clog2(Depth + 1),
    localparam int unsigned PtrW = (Depth <= 1) ? 1 : $clog2(Depth)
) (
    input logic clk_i,
    input logic push_i,
    input logic data_i,
    input logic pop_i
);
  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  logic data;
  logic [CountW-1:0] count;
  rc2_fifo #(
      .Width(1),
      .Depth(Depth)
  ) u_fifo (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .push_i (push_i),
      .data_i (data_i),
      .pop_i  (pop_i),
      .data_o (data),
      .count_o(count)
  );
  always_comb assume (!pop_i || count != 0);
  always_comb assume (!push_i || pop_i || count != CountW'(Depth));

  // ---- The queue that shifts, its oldest word at bit 0 --------------------------------------------
  logic [Depth-1:0] queue_q, popped;
  logic [CountW-1:0] length_q, kept;
  assign popped = pop_i ? queue_q >> 1 : queue_q;
  assign kept = length_q - CountW'(pop_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) length_q <= '0;
    else length_q <= kept + CountW'(push_i);
    for (int i = 0; i < Depth; i++) queue_q[i] <= (push_i && kept == CountW'(i)) ? data_i : popped[i];
  end

  // ---- What holds ------------------------------------------------------------------------------
  (* hierconn *) wire [PtrW-1:0] \u_fifo.head_q ;
  (* hierconn *) wire [PtrW-1:0] \u_fifo.tail_q ;
  (* hierconn *) wire
      \u_fifo.mem_q[0] , \u_fifo.mem_q[1] , \u_fifo.mem_q[2] , \u_fifo.mem_q[3] , \u_fifo.mem_q[4] , \u_fifo.mem_q[5] ,
      \u_fifo.mem_q[6] , \u_fifo.mem_q[7] , \u_fifo.mem_q[8] , \u_fifo.mem_q[9] , \u_fifo.mem_q[10] , \u_fifo.mem_q[11] ,
      \u_fifo.mem_q[12] , \u_fifo.mem_q[13] , \u_fifo.mem_q[14] , \u_fifo.mem_q[15] ;
  logic [15:0] ring;
  assign ring = {
      \u_fifo.mem_q[15] , \u_fifo.mem_q[14] , \u_fifo.mem_q[13] , \u_fifo.mem_q[12] , \u_fifo.mem_q[11] , \u_fifo.mem_q[10] ,
      \u_fifo.mem_q[9] , \u_fifo.mem_q[8] , \u_fifo.mem_q[7] , \u_fifo.mem_q[6] , \u_fifo.mem_q[5] , \u_fifo.mem_q[4] ,
      \u_fifo.mem_q[3] , \u_fifo.mem_q[2] , \u_fifo.mem_q[1] , \u_fifo.mem_q[0] };
  logic [4:0] head, tail, after;
  logic [31:0] unrolled;  // the ring twice, from the head on
  assign head = 5'(\u_fifo.head_q );
  assign tail = 5'(\u_fifo.tail_q );
  assign after = head + 5'(length_q);
  assign unrolled = ((32'(ring) << Depth) | (32'(ring) & ((32'd1 << Depth) - 1))) >> head;
  always_comb begin
    if (rst_ni) begin
      assert (count == length_q);
      assert (length_q <= CountW'(Depth));
      assert (length_q == 0 || data == queue_q[0]);
      assert (head < 5'(Depth));
      assert (tail == ((after >= 5'(Depth)) ? after - 5'(Depth) : after));
      for (int i = 0; i < Depth; i++) assert (CountW'(i) >= length_q || unrolled[i] == queue_q[i]);
    end
  end
endmodule
