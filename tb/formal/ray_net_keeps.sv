// SPDX-License-Identifier: Apache-2.0
//
// rc2_ray_net between any neighbours, engine and home (ray_cell.sv), its queues one deep: of any one message as
// many are there as have come and not gone; what goes is nearer to where it goes to by a step, x before y,
// and into a queue that has room; answers come home and starts begin in the cell that they name. Room that
// was offered stays until it is used, and an answer that has come home until it is taken.

module ray_net_keeps #(
    localparam int unsigned Side = rc2_pkg::N,
    localparam int unsigned CoordW = rc2_pkg::CoordW,
    localparam int unsigned MessageW = rc2_pkg::MessageW,
    localparam int unsigned LinkW = rc2_pkg::LinkW,
    localparam int unsigned LinkRoomW = rc2_pkg::LinkRoomW,
    localparam int unsigned NodeW = rc2_pkg::NodeW,
    localparam int unsigned WantW = 35 + 7 * NodeW + 4 * CoordW,
    localparam int unsigned CameW = LinkRoomW + NodeW + 2 * CoordW
) (
    input logic                   clk_i,
    input logic [      WantW-1:0] want_i,
    input logic [    4*CameW-1:0] came_i,  // on each link: for which queue, tag, to where
    input logic [4*LinkRoomW-1:0] room_i
);
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned FracW = rc2_pkg::PlaceFracW;
  localparam int unsigned StartW = rc2_pkg::StartW;
  localparam int unsigned RayW = rc2_pkg::RayW;
  localparam int unsigned AnswerW = rc2_pkg::AnswerW;
  localparam int unsigned NodeAt = StartW - 2 * CoordW - NodeW;  // of a start, its node

  logic rst_ni = 1'b0;
  logic past_q = 1'b0;  // the cycle before had no reset
  always_ff @(posedge clk_i) begin
    rst_ni <= 1'b1;
    past_q <= rst_ni;
  end

  (* anyconst *) logic [CoordW-1:0] x;
  (* anyconst *) logic [CoordW-1:0] y;
  always_comb assume (x < Side && y < Side);

  // ---- What comes ----------------------------------------------------------------------------------
  logic [4*LinkW-1:0] link_in, link_out;
  logic [4*LinkRoomW-1:0] room;
  for (genvar w = 0; w < 4; w++) begin : g_in
    logic [LinkRoomW-1:0] kind;
    logic [NodeW-1:0] tag;
    logic [CoordW-1:0] to_x, to_y;
    assign {kind, tag, to_x, to_y} = came_i[w*CameW+:CameW];
    logic [MessageW-1:0] message;
    ray_message u_message (
        .kind_i   (kind),
        .tag_i    (tag),
        .to_x_i   (to_x),
        .to_y_i   (to_y),
        .message_o(message)
    );
    assign link_in[w*LinkW+:LinkW] = {kind, message};
    always_comb begin
      assume ((kind & (kind - 1'b1)) == 0 && (kind & ~room[w*LinkRoomW+:LinkRoomW]) == 0);
      assume (to_x < Side && to_y < Side);
      // Only the quadrants that go this way; answers and starts as far as this cell on their way.
      assume (w != 0 || ((kind & 6'b001010) == 0 && to_x >= x));
      assume (w != 1 || ((kind & 6'b000101) == 0 && to_x <= x));
      assume (w != 2 || ((kind & 6'b001100) == 0 && to_x == x && to_y >= y));
      assume (w != 3 || ((kind & 6'b000011) == 0 && to_x == x && to_y <= y));
    end
  end

  logic sound;
  ray_cell #(
      .Side(Side)
  ) u_cell (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .want_i   (want_i),
      .x_i      (x),
      .y_i      (y),
      .link_i   (link_in),
      .room_o   (room),
      .link_o   (link_out),
      .room_i   (room_i),
      .has_any_o(),
      .moves_o  (),
      .sound_o  (sound)
  );

  // ---- Any one message: of a kind (a quadrant's rays, answers, starts), with a tag, to a place -----------------
  (* anyconst *) logic [2:0] kind;
  (* anyconst *) logic [NodeW-1:0] tag;
  (* anyconst *) logic [CoordW-1:0] to_x;
  (* anyconst *) logic [CoordW-1:0] to_y;
  always_comb assume (kind < 3'd6 && (kind > 3'd3 || (to_x == 0 && to_y == 0)));
  logic of_rays;
  assign of_rays = (kind < 3'd4);

  (* hierconn *) wire [18:0] \u_cell.u_net.has ;
  (* hierconn *) wire [19*MessageW-1:0] \u_cell.u_net.message ;
  (* hierconn *) wire [7:0] \u_cell.pass , \u_cell.pop ;
  (* hierconn *) wire [4:0] \u_cell.arrived , \u_cell.arrived_taken , \u_cell.u_net.begins ;
  (* hierconn *) wire \u_cell.answer_taken , \u_cell.home_taken ;
  (* hierconn *) wire [4*NodeW-1:0] \u_cell.ray_tags ;
  (* hierconn *) wire [3:0] \u_cell.goes_on ;

  // Which senders have it, in the order of rc2_ray_net, and which links take or bring it.
  logic [18:0] is_it;
  for (genvar s = 0; s < 19; s++) begin : g_is
    logic [MessageW-1:0] bits;
    logic [StartW-1:0] start;
    assign bits = \u_cell.u_net.message [s*MessageW+:MessageW];
    assign start = (s < 9) ? bits[RayW-1-:StartW] : (s < 14) ? bits[AnswerW-1-:StartW] : bits[StartW-1:0];
    if (s < 9) begin : g_ray
      logic [1:0] quadrant;
      assign quadrant = {start[2*DirW-1], start[3*DirW-1]};
      assign is_it[s] = \u_cell.u_net.has [s] && kind == {1'b0, quadrant} && start[NodeAt+:NodeW] == tag;
      // It lies among those of its quadrant.
      always_comb if (rst_ni && \u_cell.u_net.has [s] && s < 8) assert (quadrant == s / 2);
    end else if (s < 14) begin : g_answer
      assign is_it[s] = \u_cell.u_net.has [s] && kind == 3'd4 && start[NodeAt+:NodeW] == tag && start[StartW-1-:CoordW] == to_x &&
                        start[StartW-1-CoordW-:CoordW] == to_y;
    end else begin : g_start
      assign is_it[s] = \u_cell.u_net.has [s] && kind == 3'd5 && start[NodeAt+:NodeW] == tag &&
                        start[3*DirW+2*PlaceW+:PlaceW] == (PlaceW'(to_x) << FracW) && start[3*DirW+PlaceW+:PlaceW] == (PlaceW'(to_y) << FracW);
    end
  end
  logic [3:0] comes, goes;
  for (genvar w = 0; w < 4; w++) begin : g_link
    logic [LinkRoomW-1:0] in_kind, out_kind;
    logic [MessageW-1:0] bits;
    logic [StartW-1:0] start;
    assign {out_kind, bits} = link_out[w*LinkW+:LinkW];
    logic [NodeW-1:0] in_tag;
    logic [CoordW-1:0] in_x, in_y;
    assign {in_kind, in_tag, in_x, in_y} = came_i[w*CameW+:CameW];
    assign comes[w] = in_kind[kind] && in_tag == tag && (of_rays || (in_x == to_x && in_y == to_y));
    assign start = of_rays ? bits[RayW-1-:StartW] : (kind == 3'd4) ? bits[AnswerW-1-:StartW] : bits[StartW-1:0];
    assign goes[w] = out_kind[kind] && start[NodeAt+:NodeW] == tag &&
                     (of_rays || ((kind == 3'd4) ? (start[StartW-1-:CoordW] == to_x && start[StartW-1-CoordW-:CoordW] == to_y)
                                                 : (start[3*DirW+2*PlaceW+:PlaceW] == (PlaceW'(to_x) << FracW) &&
                                                    start[3*DirW+PlaceW+:PlaceW] == (PlaceW'(to_y) << FracW))));
    always_comb begin
      if (rst_ni) begin
        assert ((out_kind & (out_kind - 1'b1)) == 0);
        assert ((out_kind & ~room_i[w*LinkRoomW+:LinkRoomW]) == 0);
        if (goes[w] && of_rays) assert (w == 0 ? !kind[0] : w == 1 ? kind[0] : w == 2 ? !kind[1] : kind[1]);
        if (goes[w] && !of_rays)
          assert (w == 0 ? to_x > x : w == 1 ? to_x < x : to_x == x && (w == 2 ? to_y > y : to_y < y));
      end
    end
  end

  // What the engine makes of a ray is another one. A start that begins is no message any more.
  logic [3:0] there, came, gone, balance_q;
  logic made;
  assign made = of_rays && \u_cell.goes_on [kind[1:0]] && \u_cell.ray_tags [kind[1:0]*NodeW+:NodeW] == tag;
  always_comb begin
    there = 4'd0;
    came = 4'(made);
    gone = 4'd0;
    for (int s = 0; s < 19; s++) if (s != 13 && s != 18) there = there + 4'(is_it[s]);
    for (int k = 0; k < 8; k++) gone = gone + 4'(is_it[k] && (\u_cell.pass [k] || \u_cell.pop [k]));
    for (int w = 0; w < 4; w++) begin
      came = came + 4'(comes[w]);
      gone = gone + 4'(goes[w]) + 4'(is_it[9+w] && \u_cell.arrived_taken [w]) +
             4'(is_it[14+w] && \u_cell.u_net.begins [w]);
    end
    // The cell's own answer and start go at once to where they are taken.
    came = came + 4'(is_it[13] && \u_cell.answer_taken ) + 4'(is_it[18] && \u_cell.home_taken );
    gone = gone + 4'(is_it[13] && \u_cell.arrived_taken [4]) + 4'(is_it[18] && \u_cell.u_net.begins [4]);
  end
  always_ff @(posedge clk_i) balance_q <= !rst_ni ? 4'd0 : balance_q + came - gone;

  logic [4*LinkRoomW-1:0] kept_q;
  logic [3:0] waits_q;
  always_ff @(posedge clk_i) waits_q <= \u_cell.arrived [3:0] & ~\u_cell.arrived_taken [3:0];
  for (genvar w = 0; w < 4; w++) begin : g_kept
    // A queue has one way in, but for two ways' names of it.
    always_ff @(posedge clk_i) kept_q[w*LinkRoomW+:LinkRoomW] <=
        room[w*LinkRoomW+:LinkRoomW] & ~came_i[w*CameW+2*CoordW+NodeW+:LinkRoomW];
  end
  always_comb begin
    if (rst_ni) begin
      assert (sound);
      assert (balance_q == there);
      for (int s = 0; s < 5; s++) begin
        if (is_it[9+s] && \u_cell.arrived [s]) assert (to_x == x && to_y == y);
        if (is_it[14+s] && \u_cell.u_net.begins [s]) assert (to_x == x && to_y == y);
      end
      if (past_q) begin
        for (int i = 0; i < 4; i++) begin
          assert ((kept_q[i*LinkRoomW+4+:2] & ~room[i*LinkRoomW+4+:2]) == 0);
          assert (!waits_q[i] || \u_cell.arrived [i]);
        end
      end
    end
  end
endmodule

// A message with what the network looks at: of a ray its quadrant, of a start its place, of an answer its home.
module ray_message (
    input  logic [rc2_pkg::LinkRoomW-1:0] kind_i,
    input  logic [    rc2_pkg::NodeW-1:0] tag_i,
    input  logic [   rc2_pkg::CoordW-1:0] to_x_i,
    input  logic [   rc2_pkg::CoordW-1:0] to_y_i,
    output logic [ rc2_pkg::MessageW-1:0] message_o
);
  localparam int unsigned MessageW = rc2_pkg::MessageW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  rc2_pkg::start_t start, sender;
  rc2_pkg::answer_t answer;
  rc2_pkg::ray_t ray;
  ray_of_quadrant u_ray (
      .tag_i    (tag_i),
      .west_i   (kind_i[1] || kind_i[3]),
      .south_i  (kind_i[2] || kind_i[3]),
      .along_y_i(1'b0),
      .ray_o    (ray)
  );
  always_comb begin
    start = '0;
    start.node = tag_i;
    start.ox = PlaceW'(to_x_i) << rc2_pkg::PlaceFracW;
    start.oy = PlaceW'(to_y_i) << rc2_pkg::PlaceFracW;
    sender = '0;
    sender.node = tag_i;
    sender.home_x = to_x_i;
    sender.home_y = to_y_i;
    answer = '0;
    answer.start = sender;
  end
  assign message_o = kind_i[5] ? MessageW'(start) : kind_i[4] ? MessageW'(answer) : MessageW'(ray);
endmodule
