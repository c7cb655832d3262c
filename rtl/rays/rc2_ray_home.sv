// SPDX-License-Identifier: Apache-2.0
//
// A pixel's home: the rays of its tree that wait to be sent, and the hits of those that have ended. It
// takes every answer, in as many cycles as it brings rays, at least one; so nobody waits for it for ever.
// No ray waits here together with one that it comes from, so there are never more than 2^RAYDEPTH.
//
// Readback (thesis 1.3): of each hit HitWords words, the lowest bits first, in the order of nodes; then
// the counts: columns looked into, planes, rays that ran on, hops, cycles at work of the other stages.

module rc2_ray_home (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              clear_i,  // forget all hits and counts
    input  logic                              run_i,    // rays may leave
    // the pixel's first ray
    input  logic                              first_i,
    input  rc2_pkg::start_t                   first_ray_i,
    // rays that wait
    output logic                              waits_o,
    output rc2_pkg::start_t                   ray_o,
    input  logic                              taken_i,
    // answers
    input  logic [                       4:0] arrived_i,
    input  logic [   5*rc2_pkg::MessageW-1:0] answers_i,
    output logic [                       4:0] arrived_taken_o,
    // what to count
    input  logic                              plane_i,
    input  logic                              run_on_i,
    input  logic [                       2:0] hops_i,
    input  logic [                       8:0] work_i,  // of the units: 4 look, 1 read, 2 launch, 2 meet
    // readback
    input  logic                              read_i,
    output logic                              read_done_o,
    input  logic                              read_done_taken_i,
    output logic                              data_valid_o,
    output rc2_pkg::data_t                    data_o,
    input  logic                              data_ready_i,
    output logic                              busy_o
);
  localparam int unsigned StartW = rc2_pkg::StartW;
  localparam int unsigned MessageW = rc2_pkg::MessageW;
  localparam int unsigned NodeW = rc2_pkg::NodeW;
  localparam int unsigned HitW = rc2_pkg::HitW;
  localparam int unsigned HitWords = rc2_pkg::HitWords;
  localparam int unsigned ValueW = rc2_pkg::ValueW;
  localparam int unsigned Nodes = 1 << NodeW;
  localparam int unsigned Waiting = 1 << rc2_pkg::RAYDEPTH;
  localparam int unsigned WaitingW = $clog2(Waiting + 1);
  localparam int unsigned Counts = 7;

  // ---- Answers -----------------------------------------------------------------------------------
  logic [4:0] turn, chosen, held_q;  // held: the answer whose first ray has been taken
  logic [MessageW-1:0] bits;
  rc2_pkg::answer_t answer;
  rc2_pkg::start_t sender, again;
  logic second, done;
  rc2_rotate #(
      .Ways(5)
  ) u_turn (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni && !clear_i),
      .request_i(arrived_i),
      .take_i   (held_q == 0),
      .grant_o  (turn)
  );
  assign second = (held_q != 0);
  assign chosen = second ? held_q : turn;
  always_comb begin
    bits = '0;
    for (int i = 0; i < 5; i++) bits = bits | (answers_i[i*MessageW+:MessageW] & {MessageW{chosen[i]}});
  end
  assign answer = bits[rc2_pkg::AnswerW-1:0];
  assign sender = answer.start;
  assign done = (chosen != 0) && (second || !(answer.mirrored && answer.cleared));
  assign arrived_taken_o = done ? chosen : '0;

  // The ray that it brings: the mirrored one, then the other.
  logic brings, clears;
  assign brings = (chosen != 0) && (answer.mirrored || answer.cleared);
  assign clears = second || !answer.mirrored;
  always_comb begin
    again = sender;
    again.node = {sender.node[NodeW-2:0], clears};
    again.in_glass = clears ? answer.cleared_inside : sender.in_glass;
    again.weight = clears ? answer.cleared_weight : answer.mirrored_weight;
    again.ox = answer.ex;
    again.oy = answer.ey;
    again.oz = answer.ez;
    again.dx = clears ? answer.cx : answer.mx;
    again.dy = clears ? answer.cy : answer.my;
    again.dz = clears ? answer.cz : answer.mz;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) held_q <= '0;
    else held_q <= done ? '0 : chosen;
  end

  // ---- Rays that wait ----------------------------------------------------------------------------
  logic [WaitingW-1:0] count;
  logic [StartW-1:0] waiting;
  rc2_fifo #(
      .Width(StartW),
      .Depth(Waiting)
  ) u_waiting (
      .clk_i  (clk_i),
      .rst_ni (rst_ni && !clear_i),
      .push_i (brings || first_i),
      .data_i (brings ? again : first_ray_i),
      .pop_i  (taken_i),
      .data_o (waiting),
      .count_o(count)
  );
  assign waits_o = run_i && (count != 0);
  assign ray_o = waiting;

  // ---- Hits --------------------------------------------------------------------------------------
  logic [Nodes-1:0] have_q, todo_q;
  logic [NodeW-1:0] node;
  logic [HitW-1:0] hit;
  rc2_ram #(
      .Width(HitW),
      .Depth(Nodes)
  ) u_hits (
      .clk_i       (clk_i),
      .write_i     (done),
      .write_addr_i(sender.node),
      .write_data_i({sender[StartW-2*rc2_pkg::CoordW-1:0], answer.ended}),
      .read_addr_i (node),
      .read_data_o (hit)
  );
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) have_q <= '0;
    else if (done) have_q[sender.node] <= 1'b1;
  end

  // ---- Counts: what happens is counted a cycle later, so that no long path of the engine ends in a sum ------
  logic [ValueW-1:0] probes_q, planes_q, run_on_q, hops_q, reader_q, launch_q, meet_q;
  logic [13:0] happens_q;
  logic plane, runs_on;
  logic [2:0] hops, looks;
  logic [1:0] launches, meets;
  logic [8:0] work;
  assign {plane, runs_on, hops, work} = happens_q;
  assign looks = 3'(work[0]) + 3'(work[1]) + 3'(work[2]) + 3'(work[3]);
  assign launches = 2'(work[5]) + 2'(work[6]);
  assign meets = 2'(work[7]) + 2'(work[8]);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      happens_q <= '0;
      probes_q  <= '0;
      planes_q  <= '0;
      run_on_q  <= '0;
      hops_q    <= '0;
      reader_q  <= '0;
      launch_q  <= '0;
      meet_q    <= '0;
    end else begin
      happens_q <= {plane_i, run_on_i, hops_i, work_i};
      probes_q  <= probes_q + ValueW'(looks);
      planes_q  <= planes_q + ValueW'(plane);
      run_on_q  <= run_on_q + ValueW'(runs_on);
      hops_q    <= hops_q + ValueW'(hops);
      reader_q  <= reader_q + ValueW'(work[4]);
      launch_q  <= launch_q + ValueW'(launches);
      meet_q    <= meet_q + ValueW'(meets);
    end
  end

  // ---- Readback ----------------------------------------------------------------------------------
  logic reading_q, fetched_q, done_q, sent, any, of_counts;
  logic [HitWords-1:0] word_q;  // of the hit, one bit each
  logic [Counts-1:0] count_q;   // likewise
  logic [HitWords*ValueW-1:0] padded;
  logic [ValueW-1:0] value;
  rc2_first #(
      .Width(Nodes)
  ) u_first (
      .bits_i (todo_q),
      .found_o(any),
      .index_o(node)
  );
  assign of_counts = !any;
  assign padded = (HitWords * ValueW)'(hit);
  always_comb begin
    value = '0;
    for (int i = 0; i < HitWords; i++)
      value = value | (padded[i*ValueW+:ValueW] & {ValueW{word_q[i] && !of_counts}});
    if (of_counts && count_q[0]) value = probes_q;
    if (of_counts && count_q[1]) value = planes_q;
    if (of_counts && count_q[2]) value = run_on_q;
    if (of_counts && count_q[3]) value = hops_q;
    if (of_counts && count_q[4]) value = reader_q;
    if (of_counts && count_q[5]) value = launch_q;
    if (of_counts && count_q[6]) value = meet_q;
  end
  assign sent = fetched_q && data_ready_i;
  assign data_valid_o = fetched_q;
  assign read_done_o = done_q;
  always_comb begin
    data_o.last = of_counts && count_q[Counts-1];
    data_o.empty = 1'b0;
    data_o.z = '0;
    data_o.value = value;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      reading_q <= 1'b0;
      fetched_q <= 1'b0;
      done_q    <= 1'b0;
    end else begin
      if (read_i && !reading_q && !done_q) reading_q <= 1'b1;
      if (reading_q) fetched_q <= !sent;
      if (sent && data_o.last) begin
        reading_q <= 1'b0;
        fetched_q <= 1'b0;
        done_q    <= 1'b1;
      end
      if (read_done_taken_i) done_q <= 1'b0;
    end
    if (read_i && !reading_q) begin
      todo_q  <= have_q;
      word_q  <= HitWords'(1);
      count_q <= Counts'(1);
    end else if (sent) begin
      if (of_counts) count_q <= count_q << 1;
      else word_q <= {word_q[HitWords-2:0], word_q[HitWords-1]};
      if (!of_counts && word_q[HitWords-1]) todo_q <= todo_q & ~(Nodes'(1) << node);
    end
  end
  assign busy_o = reading_q || done_q;

  // Contract: a hit comes once; rays wait that are not on their way.
  always_ff @(posedge clk_i) begin
    if (rst_ni && !clear_i) begin
      assert (!(done && have_q[sender.node]));
      assert (!(brings && first_i));
    end
  end
endmodule
