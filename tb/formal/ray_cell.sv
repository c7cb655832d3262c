// SPDX-License-Identifier: Apache-2.0
//
// The rays' network of a cell, rc2_ray_net, with an engine and a home that do anything that keeps to what the
// network asks of them:
//
// - A ray at the head of a queue, or one that begins here, goes on or ends at any time; in a cycle one of each
//   quadrant goes on and one of the cell ends. What goes on keeps to its quadrant and to the array. One begins only
//   if there is a place for it to go on from; two wait for that at most.
// - Of what has ended Held rays at most wait in the engine. Each of them may send new rays that begin here,
//   where there is room, and becomes an answer to any home. An answer stays until it is taken.
// - The home sends any rays to any cells, one at a time, and takes what has arrived one at a time, sooner or later.
//
// The engine is moreover allowed to do nothing while it has an answer to send (moves_o). Checkers see all this by
// name. Of a message there is what the network looks at and a tag (its node) to know it by; the rest is 0.

module ray_cell #(
    parameter int unsigned Side = rc2_pkg::N,  // cells of the array along x and y
    localparam int unsigned CoordW = rc2_pkg::CoordW,
    localparam int unsigned LinkW = rc2_pkg::LinkW,
    localparam int unsigned LinkRoomW = rc2_pkg::LinkRoomW,
    localparam int unsigned MessageW = rc2_pkg::MessageW,
    localparam int unsigned WantW = 35 + 7 * rc2_pkg::NodeW + 4 * rc2_pkg::CoordW
) (
    input  logic                   clk_i,
    input  logic                   rst_ni,
    input  logic [      WantW-1:0] want_i,  // whatever the engine and the home want to do
    input  logic [     CoordW-1:0] x_i,
    input  logic [     CoordW-1:0] y_i,
    input  logic [    4*LinkW-1:0] link_i,
    output logic [4*LinkRoomW-1:0] room_o,
    output logic [    4*LinkW-1:0] link_o,
    input  logic [4*LinkRoomW-1:0] room_i,
    output logic                   has_any_o,  // there is a message or a ray
    output logic                   moves_o,    // and one of them moves, or the engine or the home can move it
    output logic                   sound_o     // what never fails in a state that can be reached
);
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned FracW = rc2_pkg::PlaceFracW;
  localparam int unsigned NodeW = rc2_pkg::NodeW;
  localparam int unsigned RayW = rc2_pkg::RayW;
  localparam logic [2:0] Held = 3'd6;
  localparam logic [1:0] Starting = 2'd2;

  logic [7:0] pass, pop;
  logic [3:0] launch, along_y;  // by quadrant, {south, west} as a number
  logic takes, begins, spawn, replies, sends;
  logic fails;  // what began here ends here
  logic [4:0] arrived_taken;
  logic [4*NodeW-1:0] ray_tags;
  logic [NodeW-1:0] spawn_tag, reply_tag, letter_tag;
  logic [CoordW-1:0] home_x, home_y, to_x, to_y;
  assign {pass, pop, takes, begins, launch, fails, spawn, replies, sends, arrived_taken, along_y,
          ray_tags, spawn_tag, reply_tag, letter_tag, home_x, home_y, to_x, to_y} = want_i;
  logic [4*RayW-1:0] rays;
  logic [3:0] goes_on, leaves_array, alone;
  for (genvar q = 0; q < 4; q++) begin : g_quadrant
    ray_of_quadrant u_ray (
        .tag_i    (ray_tags[q*NodeW+:NodeW]),
        .west_i   (q % 2 == 1),
        .south_i  (q / 2 == 1),
        .along_y_i(along_y[q]),
        .ray_o    (rays[q*RayW+:RayW])
    );
    assign goes_on[q] = pass[2*q+:2] != 0 || launch[q];
    assign alone[q] = pass[2*q+:2] != 2'b11 && !(pass[2*q+:2] != 0 && launch[q]);
    assign leaves_array[q] = along_y[q] ? ((q / 2 == 1) ? y_i == 0 : y_i == CoordW'(Side - 1))
                                        : ((q % 2 == 1) ? x_i == 0 : x_i == CoordW'(Side - 1));
  end
  rc2_pkg::start_t reply_start, spawn_ray, letter;
  rc2_pkg::answer_t reply;
  always_comb begin
    spawn_ray = '0;
    spawn_ray.node = spawn_tag;
    reply_start = '0;
    reply_start.home_x = home_x;
    reply_start.home_y = home_y;
    reply_start.node = reply_tag;
    reply = '0;
    reply.start = reply_start;
    letter = '0;
    letter.node = letter_tag;
    letter.ox = PlaceW'(to_x) << FracW;
    letter.oy = PlaceW'(to_y) << FracW;
  end

  logic [7:0] waits;
  logic spawned, launch_room, spawn_room, answer_taken, home_taken, busy;
  logic [4:0] arrived;
  logic [8*MessageW-1:0] heads;
  logic [5*MessageW-1:0] answers;
  rc2_pkg::start_t spawned_ray;

  // ---- What they have ----------------------------------------------------------------------------------
  logic begun_q, answer_q, home_q;
  logic [1:0] starting_q;
  logic [2:0] held_q;
  rc2_pkg::answer_t answer_ray_q;
  rc2_pkg::start_t home_ray_q;
  logic ends;
  assign ends = (pop != 0) || fails;
  always_ff @(posedge clk_i) begin
    starting_q <= !rst_ni ? 2'd0 : starting_q + 2'(takes) - 2'(begins);
    begun_q    <= rst_ni && (begins || begun_q) && launch == 0 && !fails;
    held_q     <= !rst_ni ? 3'd0 : held_q + 3'(ends) - 3'(replies);
    answer_q   <= rst_ni && (replies || (answer_q && !answer_taken));
    home_q     <= rst_ni && (sends || (home_q && !home_taken));
    if (replies) answer_ray_q <= reply;
    if (sends) home_ray_q <= letter;
  end

  // ---- What the network asks of them ------------------------------------------------------------------
  always_comb begin
    assume ((pass & ~waits) == 0 && (pop & ~waits) == 0 && (pass & pop) == 0);
    assume ((pop & (pop - 1'b1)) == 0 && (launch & (launch - 1'b1)) == 0);
    assume (alone == '1 && (goes_on & leaves_array) == 0);
    assume (!takes || (spawned && (starting_q != Starting || begins)));
    assume (!begins || (starting_q != 0 && launch_room && !begun_q));
    assume (!(launch != 0 || fails) || begun_q || begins);
    assume (!(launch != 0 && fails) && !(fails && pop != 0));
    assume (!ends || held_q != Held);
    assume (!spawn || (spawn_room && held_q != 0));
    assume (!replies || (held_q != 0 && !answer_q));
    assume (home_x < Side && home_y < Side);
    assume (!sends || !home_q);
    assume (to_x < Side && to_y < Side);
    assume ((arrived_taken & ~arrived) == 0 && (arrived_taken & (arrived_taken - 1'b1)) == 0);
  end

  rc2_pkg::limits_t limits;
  always_comb begin
    limits = '0;
    limits.places = rc2_pkg::RayCountW'(rc2_pkg::RAYQ);
  end
  rc2_ray_net u_net (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .clear_i        (1'b0),
      .x_i            (x_i),
      .y_i            (y_i),
      .limits_i       (limits),
      .link_i         (link_i),
      .room_o         (room_o),
      .link_o         (link_o),
      .room_i         (room_i),
      .waits_o        (waits),
      .heads_o        (heads),
      .pass_i         (pass),
      .pop_i          (pop),
      .ray_i          (rays),
      .spawned_o      (spawned),
      .spawned_ray_o  (spawned_ray),
      .spawned_taken_i(takes),
      .launch_room_o  (launch_room),
      .launch_i       (launch),
      .spawn_room_o   (spawn_room),
      .spawn_i        (spawn),
      .spawn_ray_i    (spawn_ray),
      .answer_i       (answer_q),
      .answer_ray_i   (answer_ray_q),
      .answer_taken_o (answer_taken),
      .home_i         (home_q),
      .home_ray_i     (home_ray_q),
      .home_taken_o   (home_taken),
      .arrived_o      (arrived),
      .answers_o      (answers),
      .arrived_taken_i(arrived_taken),
      .hops_o         (),
      .busy_o         (busy)
  );

  // ---- What there is, and what moves -----------------------------------------------------------------------
  (* hierconn *) wire [18:0] \u_net.has , \u_net.sent ;
  (* hierconn *) wire [4:0] \u_net.begins ;
  assign has_any_o = busy || starting_q != 0 || begun_q || held_q != 0;
  assign moves_o = \u_net.sent != 0 || \u_net.begins != 0 || spawn || arrived != 0 ||
                   (!answer_q && (waits != 0 || held_q != 0 || begun_q ||
                                  (spawned && starting_q != Starting) || (starting_q != 0 && launch_room)));
  // Queues of one place: their pointers stand still; what is probed is there.
  (* hierconn *) wire
      \u_net.g_ray[0].u_queue.probed_q , \u_net.g_ray[1].u_queue.probed_q , \u_net.g_ray[2].u_queue.probed_q ,
      \u_net.g_ray[3].u_queue.probed_q , \u_net.g_ray[4].u_queue.probed_q , \u_net.g_ray[5].u_queue.probed_q ,
      \u_net.g_ray[6].u_queue.probed_q , \u_net.g_ray[7].u_queue.probed_q ;
  (* hierconn *) wire
      \u_net.g_ray[0].u_queue.head_q , \u_net.g_ray[1].u_queue.head_q , \u_net.g_ray[2].u_queue.head_q ,
      \u_net.g_ray[3].u_queue.head_q , \u_net.g_ray[4].u_queue.head_q , \u_net.g_ray[5].u_queue.head_q ,
      \u_net.g_ray[6].u_queue.head_q , \u_net.g_ray[7].u_queue.head_q , \u_net.g_answer[0].from.u_queue.head_q ,
      \u_net.g_answer[1].from.u_queue.head_q , \u_net.g_answer[2].from.u_queue.head_q ,
      \u_net.g_answer[3].from.u_queue.head_q , \u_net.g_start[0].from.u_queue.head_q ,
      \u_net.g_start[1].from.u_queue.head_q , \u_net.g_start[2].from.u_queue.head_q ,
      \u_net.g_start[3].from.u_queue.head_q , \u_net.u_spawned.head_q ;
  (* hierconn *) wire
      \u_net.g_ray[0].u_queue.tail_q , \u_net.g_ray[1].u_queue.tail_q , \u_net.g_ray[2].u_queue.tail_q ,
      \u_net.g_ray[3].u_queue.tail_q , \u_net.g_ray[4].u_queue.tail_q , \u_net.g_ray[5].u_queue.tail_q ,
      \u_net.g_ray[6].u_queue.tail_q , \u_net.g_ray[7].u_queue.tail_q , \u_net.g_answer[0].from.u_queue.tail_q ,
      \u_net.g_answer[1].from.u_queue.tail_q , \u_net.g_answer[2].from.u_queue.tail_q ,
      \u_net.g_answer[3].from.u_queue.tail_q , \u_net.g_start[0].from.u_queue.tail_q ,
      \u_net.g_start[1].from.u_queue.tail_q , \u_net.g_start[2].from.u_queue.tail_q ,
      \u_net.g_start[3].from.u_queue.tail_q , \u_net.u_spawned.tail_q ;
  // Whoever goes somewhere goes to a cell of the array.
  (* hierconn *) wire [CoordW-1:0]
      \u_net.g_answer[0].u_way.to_x_i , \u_net.g_answer[1].u_way.to_x_i , \u_net.g_answer[2].u_way.to_x_i ,
      \u_net.g_answer[3].u_way.to_x_i , \u_net.g_answer[4].u_way.to_x_i , \u_net.g_start[0].u_way.to_x_i ,
      \u_net.g_start[1].u_way.to_x_i , \u_net.g_start[2].u_way.to_x_i , \u_net.g_start[3].u_way.to_x_i ,
      \u_net.g_start[4].u_way.to_x_i ,
      \u_net.g_answer[0].u_way.to_y_i , \u_net.g_answer[1].u_way.to_y_i , \u_net.g_answer[2].u_way.to_y_i ,
      \u_net.g_answer[3].u_way.to_y_i , \u_net.g_answer[4].u_way.to_y_i , \u_net.g_start[0].u_way.to_y_i ,
      \u_net.g_start[1].u_way.to_y_i , \u_net.g_start[2].u_way.to_y_i , \u_net.g_start[3].u_way.to_y_i ,
      \u_net.g_start[4].u_way.to_y_i ;
  logic [10*CoordW-1:0] far_x, far_y;
  logic [9:0] strays;
  assign far_x = {
      \u_net.g_start[4].u_way.to_x_i , \u_net.g_start[3].u_way.to_x_i , \u_net.g_start[2].u_way.to_x_i ,
      \u_net.g_start[1].u_way.to_x_i , \u_net.g_start[0].u_way.to_x_i , \u_net.g_answer[4].u_way.to_x_i ,
      \u_net.g_answer[3].u_way.to_x_i , \u_net.g_answer[2].u_way.to_x_i , \u_net.g_answer[1].u_way.to_x_i ,
      \u_net.g_answer[0].u_way.to_x_i };
  assign far_y = {
      \u_net.g_start[4].u_way.to_y_i , \u_net.g_start[3].u_way.to_y_i , \u_net.g_start[2].u_way.to_y_i ,
      \u_net.g_start[1].u_way.to_y_i , \u_net.g_start[0].u_way.to_y_i , \u_net.g_answer[4].u_way.to_y_i ,
      \u_net.g_answer[3].u_way.to_y_i , \u_net.g_answer[2].u_way.to_y_i , \u_net.g_answer[1].u_way.to_y_i ,
      \u_net.g_answer[0].u_way.to_y_i };
  always_comb begin
    for (int i = 0; i < 10; i++)
      strays[i] = \u_net.has [9+i] && (far_x[i*CoordW+:CoordW] >= Side || far_y[i*CoordW+:CoordW] >= Side);
  end
  logic [7:0] probed;
  logic [33:0] pointers;
  assign probed = {
      \u_net.g_ray[7].u_queue.probed_q , \u_net.g_ray[6].u_queue.probed_q , \u_net.g_ray[5].u_queue.probed_q ,
      \u_net.g_ray[4].u_queue.probed_q , \u_net.g_ray[3].u_queue.probed_q , \u_net.g_ray[2].u_queue.probed_q ,
      \u_net.g_ray[1].u_queue.probed_q , \u_net.g_ray[0].u_queue.probed_q };
  assign pointers = {
      \u_net.u_spawned.head_q , \u_net.g_start[3].from.u_queue.head_q , \u_net.g_start[2].from.u_queue.head_q ,
      \u_net.g_start[1].from.u_queue.head_q , \u_net.g_start[0].from.u_queue.head_q ,
      \u_net.g_answer[3].from.u_queue.head_q , \u_net.g_answer[2].from.u_queue.head_q ,
      \u_net.g_answer[1].from.u_queue.head_q , \u_net.g_answer[0].from.u_queue.head_q ,
      \u_net.g_ray[7].u_queue.head_q , \u_net.g_ray[6].u_queue.head_q , \u_net.g_ray[5].u_queue.head_q ,
      \u_net.g_ray[4].u_queue.head_q , \u_net.g_ray[3].u_queue.head_q , \u_net.g_ray[2].u_queue.head_q ,
      \u_net.g_ray[1].u_queue.head_q , \u_net.g_ray[0].u_queue.head_q ,
      \u_net.u_spawned.tail_q , \u_net.g_start[3].from.u_queue.tail_q , \u_net.g_start[2].from.u_queue.tail_q ,
      \u_net.g_start[1].from.u_queue.tail_q , \u_net.g_start[0].from.u_queue.tail_q ,
      \u_net.g_answer[3].from.u_queue.tail_q , \u_net.g_answer[2].from.u_queue.tail_q ,
      \u_net.g_answer[1].from.u_queue.tail_q , \u_net.g_answer[0].from.u_queue.tail_q ,
      \u_net.g_ray[7].u_queue.tail_q , \u_net.g_ray[6].u_queue.tail_q , \u_net.g_ray[5].u_queue.tail_q ,
      \u_net.g_ray[4].u_queue.tail_q , \u_net.g_ray[3].u_queue.tail_q , \u_net.g_ray[2].u_queue.tail_q ,
      \u_net.g_ray[1].u_queue.tail_q , \u_net.g_ray[0].u_queue.tail_q };
  assign sound_o = (probed & ~\u_net.has [7:0]) == 0 && pointers == 0 &&
                   held_q <= Held && starting_q <= Starting && (launch_room || !begun_q) && strays == 0;
endmodule

// A ray that goes on.
module ray_of_quadrant (
    input  logic [rc2_pkg::NodeW-1:0] tag_i,
    input  logic                       west_i,
    input  logic                       south_i,
    input  logic                       along_y_i,
    output rc2_pkg::ray_t             ray_o
);
  localparam int unsigned DirW = rc2_pkg::DirW;
  rc2_pkg::start_t start;
  always_comb begin
    start = '0;
    start.node = tag_i;
    start.dx = {west_i, {(DirW - 1) {1'b0}}};
    start.dy = {south_i, {(DirW - 1) {1'b0}}};
    ray_o = '0;
    ray_o.start = start;
    ray_o.along_y = along_y_i;
  end
endmodule
