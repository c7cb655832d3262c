// SPDX-License-Identifier: Apache-2.0
//
// The cell's beam engine in thesis mode (thesis 4.4.1, 4.4.2): a queue of beams (FA), served in
// order, voxel by voxel. The head beam ends where its voxel is occupied; else it is split and its
// children leave all together, when every output buffer that they need is free. A child that stays
// in the cell (z beams) goes to the queue's tail, in the place that its parent gives up, so the
// queue can never block itself.
//
// One beam (for a side beam: one part of V) per cycle. A beam that arrives is served in the next
// cycle at the earliest.

module rc2_diffuser (
    /*verilator tracing_off*/
    input  logic                               clk_i,
    input  logic                               rst_ni,
    input  logic           [rc2_pkg::CoordW-1:0] x_i,
    input  logic           [rc2_pkg::CoordW-1:0] y_i,
    input  rc2_pkg::light_t                    light_i,
    input  logic           [     rc2_pkg::N-1:0] occupied_i,
    // a beam that wants to enter; it does when take_o is set
    input  logic                               valid_i,
    input  rc2_pkg::beam_t                     beam_i,
    output logic                               take_o,
    // children of the head beam: written into the output buffers when send_o is set
    input  logic           [               7:0] writable_i,
    output rc2_pkg::split_t                    split_o,
    output logic           [               7:0] send_o,
    // targets that reach the column: the beam at voxel absorb_z_o, absorb_u_o x absorb_v_o targets
    output logic                               absorb_o,
    output logic           [rc2_pkg::CoordW-1:0] absorb_z_o,
    // targets served in this cycle and those of them that travel on
    output logic           [rc2_pkg::ExtentW-1:0] served_u_o,
    output logic           [rc2_pkg::ExtentW-1:0] served_v_o,
    output logic           [rc2_pkg::ExtentW-1:0] kept_u_o,
    output logic           [rc2_pkg::ExtentW-1:0] kept_v_o,
    output logic                               served_o,     // some targets are served
    output logic                               finished_o,   // a beam leaves the queue
    output logic           [rc2_pkg::QueueW-1:0] queue_o
);
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned ExtentW = rc2_pkg::ExtentW;
  localparam int unsigned BeamW = rc2_pkg::BeamW;

  // ---- The queue -------------------------------------------------------------------------------
  logic [BeamW-1:0] head_bits, push_bits;
  logic [$clog2(rc2_pkg::FAMAX+1)-1:0] held;
  logic [rc2_pkg::QueueW-1:0] count;
  logic push, pop;
  rc2_fifo #(
      .Width(BeamW),
      .Depth(rc2_pkg::FAMAX)
  ) u_queue (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .push_i (push),
      .data_i (push_bits),
      .pop_i  (pop),
      .data_o (head_bits),
      .count_o(held)
  );
  assign count = rc2_pkg::QueueW'(held);
  assign queue_o = count;

  // ---- The head beam, or what is left of it ------------------------------------------------------
  logic present, resumed_q;
  logic [TargetW-1:0] resume_q, resume;
  /*verilator tracing_on*/
  rc2_pkg::beam_t head;
  /*verilator tracing_off*/
  always_comb begin
    head = head_bits;
    if (resumed_q) head.vmin = resume_q;
  end
  assign present = (count != 0);

  logic stopped, splits;
  assign stopped = present && occupied_i[head.z];
  assign splits = present && !stopped;

  logic [7:0] send;
  logic own, more;
  logic [ExtentW-1:0] split_u, split_v, split_kept_u, split_kept_v;
  rc2_splitter u_splitter (
      .valid_i   (splits),
      .beam_i    (head),
      .x_i       (x_i),
      .y_i       (y_i),
      .light_i   (light_i),
      .split_o   (split_o),
      .send_o    (send),
      .own_o     (own),
      .more_o    (more),
      .resume_o  (resume),
      .served_u_o(split_u),
      .served_v_o(split_v),
      .kept_u_o  (split_kept_u),
      .kept_v_o  (split_kept_v)
  );

  logic go;
  assign go = splits && ((send & ~writable_i) == 0);
  assign send_o = go ? send : 8'd0;
  assign pop = stopped || (go && !more);

  // ---- Into the queue: the own child first, else an arrival if there is a place ------------------
  rc2_pkg::beam_t own_child;
  assign own_child.dir = split_o.dir;
  assign own_child.z = split_o.z;
  assign own_child.umin = split_o.u_mid_min;
  assign own_child.umax = split_o.u_mid_max;
  assign own_child.vmin = split_o.v_mid_min;
  assign own_child.vmax = split_o.v_mid_max;

  logic own_push;
  assign own_push = go && own;
  assign take_o = valid_i && !own_push && (count < light_i.fa);
  assign push = own_push || take_o;
  assign push_bits = own_push ? own_child : beam_i;

  // ---- What was served -------------------------------------------------------------------------
  assign absorb_o = stopped;
  assign absorb_z_o = head.z;
  assign served_o = stopped || go;
  assign finished_o = pop;
  assign served_u_o = split_u;
  assign served_v_o = stopped ? ExtentW'($signed(head.vmax)) - ExtentW'($signed(head.vmin)) + 1'b1 :
                                split_v;
  assign kept_u_o = stopped ? '0 : split_kept_u;
  assign kept_v_o = stopped ? '0 : split_kept_v;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) resumed_q <= 1'b0;
    else if (go) resumed_q <= more;
    if (go) resume_q <= resume;
  end

  // Contract: the queue keeps to its depth; a remainder keeps its place; an own child finds one.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (count <= light_i.fa || !present);
      assert (!(resumed_q && !present));
      assert (!(own_push && !pop));
      assert (!(stopped && resumed_q));
    end
  end
endmodule
