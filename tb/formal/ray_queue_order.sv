// SPDX-License-Identifier: Apache-2.0
//
// rc2_ray_queue against a queue that shifts: the same words in the same order, the oldest one replaced by
// what it was probed to, and probed until it leaves. Words are a bit wide, and the invariant is that of
// fifo_order.

module ray_queue_order #(
    parameter int unsigned Depth = 2,
    localparam int unsigned CountW = $clog2(Depth + 1),
    localparam int unsigned PtrW = (Depth <= 1) ? 1 : $clog2(Depth),
    localparam int unsigned RayW = rc2_pkg::RayW
) (
    input logic clk_i,
    input logic push_i,
    input logic data_i,
    input logic probe_i,
    input logic probe_data_i,
    input logic pop_i
);
  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  rc2_pkg::ray_t head;
  logic probed, along_y;
  logic [CountW-1:0] count;
  rc2_ray_queue #(
      .Depth(Depth)
  ) u_queue (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .push_i      (push_i),
      .data_i      (RayW'(data_i)),
      .probe_i     (probe_i),
      .probe_data_i(RayW'(probe_data_i)),
      .pop_i       (pop_i),
      .data_o      (head),
      .probed_o    (probed),
      .along_y_o   (along_y),
      .count_o     (count)
  );
  always_comb begin
    assume (!(pop_i || probe_i) || count != 0);
    assume (!probe_i || !(probed || pop_i));
    assume (!push_i || count != CountW'(Depth));
  end

  // ---- The queue that shifts, its oldest word at bit 0 --------------------------------------------
  logic [Depth-1:0] queue_q, popped;
  logic [CountW-1:0] length_q, kept;
  logic probed_q;
  assign popped = pop_i ? queue_q >> 1 : queue_q;
  assign kept = length_q - CountW'(pop_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) length_q <= '0;
    else length_q <= kept + CountW'(push_i);
    for (int i = 0; i < Depth; i++)
      queue_q[i] <= (push_i && kept == CountW'(i)) ? data_i : popped[i];
    if (probe_i) queue_q[0] <= probe_data_i;
    probed_q <= rst_ni && !pop_i && (probe_i || probed_q);
  end

  // ---- What holds ------------------------------------------------------------------------------
  (* hierconn *) wire [PtrW-1:0] \u_queue.head_q ;
  (* hierconn *) wire [PtrW-1:0] \u_queue.tail_q ;
  (* hierconn *) wire [RayW-1:0] \u_queue.mem_q[0] , \u_queue.mem_q[1] , \u_queue.mem_q[2] , \u_queue.mem_q[3] ;
  logic [3:0] ring;
  assign ring = {\u_queue.mem_q[3] [0], \u_queue.mem_q[2] [0], \u_queue.mem_q[1] [0], \u_queue.mem_q[0] [0]};
  logic [3:0] at, tail, after;
  logic [7:0] unrolled;  // the ring twice, from the head on
  assign at = 4'(\u_queue.head_q );
  assign tail = 4'(\u_queue.tail_q );
  assign after = at + 4'(length_q);
  assign unrolled = ((8'(ring) << Depth) | (8'(ring) & ((8'd1 << Depth) - 1))) >> at;
  always_comb begin
    if (rst_ni) begin
      assert (count == length_q);
      assert (length_q <= CountW'(Depth));
      assert (length_q == 0 || head[0] == queue_q[0]);
      assert (along_y == head.along_y);
      assert (probed == probed_q);
      assert (!probed_q || length_q != 0);
      assert (at < 4'(Depth));
      assert (tail == ((after >= 4'(Depth)) ? after - 4'(Depth) : after));
      for (int i = 0; i < Depth; i++) assert (CountW'(i) >= length_q || unrolled[i] == queue_q[i]);
    end
  end
endmodule
