// SPDX-License-Identifier: Apache-2.0
//
// A cell's part of the network of rays (docs/render.md has why it cannot block): 8 queues of rays on
// their way (4 quadrants from 2 sides), one of those that begin here, 4 of answers and 4 of starts, and
// four links out. A link carries one message a cycle, answers before starts before rays. What enters a
// queue shows at its head in the next cycle.
//
// Who may send, by number: 0-7 the queues of rays, 2 * {south, west} + axis; 8 the ray that began here;
// 9-12 answers by the way they go, E W N S; 13 the answer of the cell's own; 14-17 starts; 18 home.

module rc2_ray_net (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              clear_i,
    input  logic [      rc2_pkg::CoordW-1:0] x_i,
    input  logic [      rc2_pkg::CoordW-1:0] y_i,
    input  rc2_pkg::limits_t                 limits_i,
    // links, by the way that a message goes: E, W, N, S from the lowest
    input  logic [     4*rc2_pkg::LinkW-1:0] link_i,
    output logic [ 4*rc2_pkg::LinkRoomW-1:0] room_o,
    output logic [     4*rc2_pkg::LinkW-1:0] link_o,
    input  logic [ 4*rc2_pkg::LinkRoomW-1:0] room_i,
    // the heads of the rays, and what becomes of them
    output logic [                      7:0] waits_o,  // for the probe
    output logic [  8*rc2_pkg::MessageW-1:0] heads_o,
    input  logic [                      7:0] pass_i,   // goes on as its quadrant's ray_i
    input  logic [                      7:0] pop_i,    // has ended
    input  logic [    4*rc2_pkg::RayW-1:0] ray_i,
    output logic                             spawned_o,
    output rc2_pkg::start_t                  spawned_ray_o,
    input  logic                             spawned_taken_i,
    output logic                             launch_room_o,
    input  logic [                      3:0] launch_i,  // goes on as its quadrant's ray_i
    output logic                             spawn_room_o,
    input  logic                             spawn_i,   // a new ray begins here
    input  rc2_pkg::start_t                  spawn_ray_i,
    // the cell's own answer and its pixel's rays
    input  logic                             answer_i,
    input  rc2_pkg::answer_t                 answer_ray_i,
    output logic                             answer_taken_o,
    input  logic                             home_i,
    input  rc2_pkg::start_t                  home_ray_i,
    output logic                             home_taken_o,
    // answers that have come home: four from the ways and the cell's own
    output logic [                      4:0] arrived_o,
    output logic [  5*rc2_pkg::MessageW-1:0] answers_o,
    input  logic [                      4:0] arrived_taken_i,
    output logic [                      2:0] hops_o,  // rays that leave the cell
    output logic                             busy_o
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned StartW = rc2_pkg::StartW;
  localparam int unsigned RayW = rc2_pkg::RayW;
  localparam int unsigned AnswerW = rc2_pkg::AnswerW;
  localparam int unsigned MessageW = rc2_pkg::MessageW;
  localparam int unsigned LinkW = rc2_pkg::LinkW;
  localparam int unsigned LinkRoomW = rc2_pkg::LinkRoomW;
  localparam int unsigned CountW = rc2_pkg::RayCountW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned OriginAt = 3 * DirW;  // of a start, its x highest; below it the direction
  localparam int unsigned DirXAt = RayW - StartW + 3 * DirW - 1;  // of a ray, the signs of its direction
  localparam int unsigned DirYAt = RayW - StartW + 2 * DirW - 1;
  localparam int unsigned Senders = 19;
  localparam int unsigned Launched = 8;
  localparam int unsigned Answers = 9;
  localparam int unsigned Starts = 14;

  // ---- What comes in: for each way a message, and a bit that says for which of its queues ----------------
  logic [4*LinkRoomW-1:0] comes_to;
  logic [4*MessageW-1:0] comes;
  for (genvar w = 0; w < 4; w++) begin : g_in
    assign {comes_to[w*LinkRoomW+:LinkRoomW], comes[w*MessageW+:MessageW]} = link_i[w*LinkW+:LinkW];
  end

  // ---- Queues ------------------------------------------------------------------------------------
  logic [Senders-1:0] has, sent;
  logic [Senders*5-1:0] wish;  // way_o of rc2_ray_way, of each sender
  logic [Senders*MessageW-1:0] message;
  logic [Senders-1:0] room;  // of the queue of that number, for one more
  logic [CountW-1:0] places;
  assign places = limits_i.places;

  for (genvar k = 0; k < 8; k++) begin : g_ray
    // A quadrant's way along an axis is always the same.
    localparam int unsigned Way = (k % 2 == 0) ? ((k / 2) % 2) : 2 + (k / 4);
    localparam int unsigned WayX = (k / 2) % 2;
    localparam int unsigned WayY = 2 + k / 4;
    logic probed, along_y;
    logic [CountW-1:0] count;
    logic [RayW-1:0] bits;
    rc2_ray_queue u_queue (
        .clk_i       (clk_i),
        .rst_ni      (rst_ni && !clear_i),
        .push_i      (comes_to[Way*LinkRoomW+k/2]),
        .data_i      (comes[Way*MessageW+:RayW]),
        .probe_i     (pass_i[k]),
        .probe_data_i(ray_i[k/2*RayW+:RayW]),
        .pop_i       (sent[k] || pop_i[k]),
        .data_o      (bits),
        .probed_o    (probed),
        .along_y_o   (along_y),
        .count_o     (count)
    );
    assign has[k] = (count != 0);
    assign room[k] = (count < places);
    assign heads_o[k*MessageW+:MessageW] = MessageW'(bits);
    assign waits_o[k] = has[k] && !probed;
    assign message[k*MessageW+:MessageW] = MessageW'(bits);
    assign wish[k*5+:5] = {
      1'b0,
      probed && along_y && WayY == 3, probed && along_y && WayY == 2,
      probed && !along_y && WayX == 1, probed && !along_y && WayX == 0
    };
  end

  logic launched_q;
  logic [RayW-1:0] launched_ray;
  rc2_pkg::ray_t launched_ray_q;
  logic [1:0] launched_quadrant;
  logic [3:0] launched_kind;
  assign launched_quadrant = {launched_ray_q[DirYAt], launched_ray_q[DirXAt]};
  assign launched_kind = 4'd1 << launched_quadrant;
  assign launch_room_o = !launched_q;
  assign has[Launched] = launched_q;
  assign room[Launched] = !launched_q;
  assign message[Launched*MessageW+:MessageW] = MessageW'(launched_ray_q);
  assign wish[Launched*5+:5] = {
    1'b0,
    launched_q && launched_ray_q.along_y && launched_quadrant[1],
    launched_q && launched_ray_q.along_y && !launched_quadrant[1],
    launched_q && !launched_ray_q.along_y && launched_quadrant[0],
    launched_q && !launched_ray_q.along_y && !launched_quadrant[0]
  };
  always_comb begin
    launched_ray = '0;
    for (int q = 0; q < 4; q++)
      launched_ray = launched_ray | (ray_i[q*RayW+:RayW] & {RayW{launch_i[q]}});
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) launched_q <= 1'b0;
    else launched_q <= (launch_i != 0) || (launched_q && !sent[Launched]);
    if (launch_i != 0) launched_ray_q <= launched_ray;
  end

  for (genvar w = 0; w < 5; w++) begin : g_answer
    logic [AnswerW-1:0] bits;
    if (w < 4) begin : from
      logic [CountW-1:0] count;
      rc2_fifo #(
          .Width(AnswerW),
          .Depth(rc2_pkg::RAYQ)
      ) u_queue (
          .clk_i  (clk_i),
          .rst_ni (rst_ni && !clear_i),
          .push_i (comes_to[w*LinkRoomW+4]),
          .data_i (comes[w*MessageW+:AnswerW]),
          .pop_i  (sent[Answers+w] || arrived_taken_i[w]),
          .data_o (bits),
          .count_o(count)
      );
      assign has[Answers+w] = (count != 0);
      assign room[Answers+w] = (count < places);
    end else begin : own
      assign bits = answer_ray_i;
      assign has[Answers+w] = answer_i;
      assign room[Answers+w] = 1'b0;
    end
    assign answers_o[w*MessageW+:MessageW] = MessageW'(bits);
    assign message[(Answers+w)*MessageW+:MessageW] = MessageW'(bits);
    assign arrived_o[w] = wish[(Answers+w)*5+4];
    rc2_ray_way u_way (
        .x_i    (x_i),
        .y_i    (y_i),
        .to_x_i (bits[AnswerW-1-:CoordW]),
        .to_y_i (bits[AnswerW-1-CoordW-:CoordW]),
        .valid_i(has[Answers+w]),
        .way_o  (wish[(Answers+w)*5+:5])
    );
  end
  assign answer_taken_o = sent[Answers+4] || arrived_taken_i[4];

  logic [4:0] begin_wish, begins, start_taken;
  logic [5*StartW-1:0] start_bits;
  for (genvar w = 0; w < 5; w++) begin : g_start
    logic [StartW-1:0] bits;
    logic [PlaceW-1:0] place_x, place_y;
    if (w < 4) begin : from
      logic [CountW-1:0] count;
      rc2_fifo #(
          .Width(StartW),
          .Depth(rc2_pkg::RAYQ)
      ) u_queue (
          .clk_i  (clk_i),
          .rst_ni (rst_ni && !clear_i),
          .push_i (comes_to[w*LinkRoomW+5]),
          .data_i (comes[w*MessageW+:StartW]),
          .pop_i  (start_taken[w]),
          .data_o (bits),
          .count_o(count)
      );
      assign has[Starts+w] = (count != 0);
      assign room[Starts+w] = (count < places);
    end else begin : own
      assign bits = home_ray_i;
      assign has[Starts+w] = home_i;
      assign room[Starts+w] = 1'b0;
    end
    assign start_bits[w*StartW+:StartW] = bits;
    assign message[(Starts+w)*MessageW+:MessageW] = MessageW'(bits);
    assign begin_wish[w] = wish[(Starts+w)*5+4];
    assign start_taken[w] = sent[Starts+w] || begins[w];
    // The voxel that a place belongs to: nearest, the larger of two.
    assign place_x = bits[OriginAt+2*PlaceW+:PlaceW] + (PlaceW'(1) << (PlaceFracW - 1));
    assign place_y = bits[OriginAt+PlaceW+:PlaceW] + (PlaceW'(1) << (PlaceFracW - 1));
    rc2_ray_way u_way (
        .x_i    (x_i),
        .y_i    (y_i),
        .to_x_i (place_x[PlaceFracW+:CoordW]),
        .to_y_i (place_y[PlaceFracW+:CoordW]),
        .valid_i(has[Starts+w]),
        .way_o  (wish[(Starts+w)*5+:5])
    );
  end
  assign home_taken_o = start_taken[4];

  // ---- Rays that begin here: new ones before those that have come from their homes ---------------------
  logic [CountW-1:0] spawned;
  logic [StartW-1:0] begin_bits, spawned_bits;
  logic [4:0] begin_turn;
  logic begin_room;
  assign spawned_o = (spawned != 0);
  assign spawn_room_o = (spawned < places);
  assign begin_room = spawn_room_o && !spawn_i;
  assign begins = begin_turn & {5{begin_room}};
  rc2_rotate #(
      .Ways(5)
  ) u_begin (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni && !clear_i),
      .request_i(begin_wish),
      .take_i   (begin_room),
      .grant_o  (begin_turn)
  );
  always_comb begin
    begin_bits = '0;
    for (int i = 0; i < 5; i++)
      begin_bits = begin_bits | (start_bits[i*StartW+:StartW] & {StartW{begin_turn[i]}});
  end
  rc2_fifo #(
      .Width(StartW),
      .Depth(rc2_pkg::RAYQ)
  ) u_spawned (
      .clk_i  (clk_i),
      .rst_ni (rst_ni && !clear_i),
      .push_i (spawn_i || begins != 0),
      .data_i (spawn_i ? spawn_ray_i : begin_bits),
      .pop_i  (spawned_taken_i),
      .data_o (spawned_bits),
      .count_o(spawned)
  );
  assign spawned_ray_o = spawned_bits;

  // ---- Links -------------------------------------------------------------------------------------
  logic [4*Senders-1:0] grants;
  for (genvar w = 0; w < 4; w++) begin : g_out
    logic [LinkRoomW-1:0] next_room;
    logic [Senders-1:0] able, answers, starts, first, grant;
    logic [MessageW-1:0] bits;
    assign next_room = room_i[w*LinkRoomW+:LinkRoomW];
    for (genvar s = 0; s < Senders; s++) begin : g_able
      if (s < Launched) begin : ray
        assign able[s] = wish[s*5+w] && next_room[s/2];
      end else if (s == Launched) begin : launched
        assign able[s] = wish[s*5+w] && ((next_room[3:0] & launched_kind) != 0);
      end else begin : other
        assign able[s] = wish[s*5+w] && next_room[s<Starts?4 : 5];
      end
    end
    assign answers = able & {{(Senders - Starts) {1'b0}}, {(Starts - Answers) {1'b1}}, {Answers{1'b0}}};
    assign starts = able & {{(Senders - Starts) {1'b1}}, {Starts{1'b0}}};
    assign first = (answers != 0) ? answers : (starts != 0) ? starts : able;
    rc2_rotate #(
        .Ways(Senders)
    ) u_turn (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni && !clear_i),
        .request_i(first),
        .take_i   (1'b1),
        .grant_o  (grant)
    );
    always_comb begin
      bits = '0;
      for (int i = 0; i < Senders; i++)
        bits = bits | (message[i*MessageW+:MessageW] & {MessageW{grant[i]}});
    end
    assign grants[w*Senders+:Senders] = grant;
    assign link_o[w*LinkW+:LinkW] = {
      grant[Senders-1:Starts] != 0,
      grant[Starts-1:Answers] != 0,
      {grant[7:6] != 0, grant[5:4] != 0, grant[3:2] != 0, grant[1:0] != 0} |
          (launched_kind & {4{grant[Launched]}}),
      bits
    };
    assign room_o[w*LinkRoomW+:LinkRoomW] = {
      room[Starts+w], room[Answers+w], room[6+w/2], room[4+w/2], room[2+w/2], room[w/2]
    };
  end
  assign sent = grants[0+:Senders] | grants[Senders+:Senders] | grants[2*Senders+:Senders] |
                grants[3*Senders+:Senders];
  assign hops_o = 3'(grants[0+:Answers] != 0) + 3'(grants[Senders+:Answers] != 0) +
                  3'(grants[2*Senders+:Answers] != 0) + 3'(grants[3*Senders+:Answers] != 0);
  assign busy_o = (has != 0) || spawned_o;

  // Contract: what comes has room, and is for one queue; what goes on is of its quadrant.
  always_ff @(posedge clk_i) begin
    if (rst_ni && !clear_i) begin
      for (int q = 0; q < 4; q++) begin
        if (pass_i[2*q+:2] != 0 || launch_i[q]) begin
          assert (ray_i[q*RayW+DirXAt] == (q % 2 == 1));
          assert (ray_i[q*RayW+DirYAt] == (q / 2 == 1));
        end
      end
      for (int w = 0; w < 4; w++) begin
        assert ((comes_to[w*LinkRoomW+:LinkRoomW] & ~room_o[w*LinkRoomW+:LinkRoomW]) == 0);
        assert ((comes_to[w*LinkRoomW+:LinkRoomW] & (comes_to[w*LinkRoomW+:LinkRoomW] - 1'b1)) == 0);
      end
    end
  end
endmodule
