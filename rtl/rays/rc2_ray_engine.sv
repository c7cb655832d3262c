// SPDX-License-Identifier: Apache-2.0
//
// What a cell does with rays, one after another (docs/render.md, thesis 1.3.2): those that begin here
// first, then by turns the heads of the queues. A ray that passes nothing is sent on in the cycle in
// which it is looked at. Else its column is read, a voxel a cycle (rc2_ray_face), until it has passed or
// ends; then come the meeting point and the new rays (rc2_ray_unit). What has ended waits here until
// the answer is taken, and for nothing else.
//
// Cycles of a ray (sw/cycle/ray_timing.h): 1 if it passes nothing; else 1, and 2 + the voxels read, if any,
// and 1 to pass it on or to leave the cube; one that begins its launch and 3 more. A hit: its arithmetic, 1 before each
// operation, and 4 to share out weights, to begin new rays here and to answer.

module rc2_ray_engine (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              clear_i,
    input  logic [      rc2_pkg::CoordW-1:0] x_i,
    input  logic [      rc2_pkg::CoordW-1:0] y_i,
    input  rc2_pkg::limits_t                 limits_i,
    // the column
    input  logic [           rc2_pkg::N-1:0] occupied_i,
    input  logic [           rc2_pkg::N-1:0] solid_i,
    output logic [      rc2_pkg::CoordW-1:0] addr_o,
    input  rc2_pkg::claim_t                  owner_i,   // of the address in the cycle before
    input  rc2_pkg::optics_t                 optics_i,
    // heads of the queues, quadrant {south, west} and axis of the way in as a number
    input  logic [                      7:0] waits_i,
    input  logic [  8*rc2_pkg::MessageW-1:0] heads_i,
    output logic [                      7:0] pass_o,  // the head goes on, as ray_o
    output logic [                      7:0] pop_o,   // the head has ended
    // rays that begin here
    input  logic                             spawned_i,
    input  rc2_pkg::start_t                  spawned_ray_i,
    output logic                             spawned_taken_o,
    input  logic                             launch_room_i,
    output logic                             launch_o,  // it goes on, as ray_o
    output rc2_pkg::ray_t                    ray_o,
    // new rays, and the answer
    input  logic                             spawn_room_i,
    output logic                             spawn_o,
    output rc2_pkg::start_t                  spawn_ray_o,
    output logic                             answer_o,
    output rc2_pkg::answer_t                 answer_ray_o,
    input  logic                             answer_taken_i,
    // what happens
    output logic                             probe_o,  // a column is looked into
    output logic                             plane_o,  // a ray is held against a facet
    output logic                             busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned MessageW = rc2_pkg::MessageW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned RiseW = rc2_pkg::RiseW;
  localparam int unsigned NodeW = rc2_pkg::NodeW;
  localparam int unsigned WeightW = rc2_pkg::WeightW;
  localparam int unsigned DecisionW = rc2_pkg::DecisionW;

  // ---- What the cell is at: one bit each; none, and it takes the next ray ---------------------------
  logic launching_q, launched_q, running_q, scanning_q, passing_q, meeting_q, bending_q, sharing_q, mirroring_q;
  logic first_child_q, second_child_q, answering_q;
  logic idle, fresh_q;  // fresh: the first cycle of an operation
  assign idle = !(launching_q || launched_q || running_q || scanning_q || passing_q || meeting_q || bending_q ||
                  sharing_q || mirroring_q || first_child_q || second_child_q || answering_q);

  // ---- Which ray ---------------------------------------------------------------------------------
  logic take_spawned, take_head;
  logic [7:0] turn, of_q;
  logic begins_q;  // it began here
  logic [MessageW-1:0] head_bits;
  rc2_pkg::ray_t head, ray_q, ray;
  rc2_pkg::start_t start;
  assign take_spawned = idle && spawned_i && launch_room_i;
  assign take_head = idle && !take_spawned && (waits_i != 0);
  assign spawned_taken_o = take_spawned;
  rc2_rotate #(
      .Ways(8)
  ) u_turn (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni && !clear_i),
      .request_i(waits_i),
      .take_i   (take_head),
      .grant_o  (turn)
  );
  always_comb begin
    head_bits = '0;
    for (int i = 0; i < 8; i++) head_bits = head_bits | (heads_i[i*MessageW+:MessageW] & {MessageW{turn[i]}});
  end
  assign head = head_bits[rc2_pkg::RayW-1:0];
  assign ray = idle ? head : ray_q;
  assign start = ray.start;

  // ---- The ray's way through the column --------------------------------------------------------------
  logic along_y, leaves, ends_cube, beyond;
  logic [N-1:0] todo, todo_q, first;
  logic [CoordW-1:0] last, last_q;
  logic along_y_q, beyond_q;
  assign along_y = !ray.decision[DecisionW-1];
  rc2_ray_run u_run (
      .z_i     (ray.z),
      .down_i  (start.dz[DirW-1]),
      .exit_i  (along_y ? ray.exit_y : ray.exit_x),
      .worth_i (occupied_i | (solid_i ^ {N{start.in_glass}})),
      .todo_o  (todo),
      .last_o  (last),
      .leaves_o(leaves)
  );
  assign ends_cube = along_y ? (start.dy[DirW-1] ? (y_i == 0) : (y_i == CoordW'(N - 1)))
                             : (start.dx[DirW-1] ? (x_i == 0) : (x_i == CoordW'(N - 1)));
  assign beyond = leaves || ends_cube;

  logic passes_at_once, passes;
  assign passes_at_once = take_head && (todo == 0) && !beyond;
  assign passes = passing_q && !beyond_q;

  // ---- Two additions, and it is the neighbour's --------------------------------------------------------
  rc2_pkg::ray_t passed;
  logic signed [DecisionW-1:0] wide_x, wide_y, size_x, size_y;
  logic by_y;
  assign wide_x = DecisionW'($signed(start.dx));
  assign wide_y = DecisionW'($signed(start.dy));
  assign size_x = start.dx[DirW-1] ? -wide_x : wide_x;
  assign size_y = start.dy[DirW-1] ? -wide_y : wide_y;
  assign by_y = idle ? along_y : along_y_q;
  always_comb begin
    passed = ray;
    passed.along_y = by_y;
    passed.z = idle ? last : last_q;
    passed.decision = by_y ? ray.decision - $unsigned(size_x <<< PlaceFracW)
                           : ray.decision + $unsigned(size_y <<< PlaceFracW);
    if (by_y) passed.exit_y = ray.exit_y + ray.slope_y;
    else passed.exit_x = ray.exit_x + ray.slope_x;
  end
  assign ray_o = passed;
  assign pass_o = passes_at_once ? turn : (passes && !begins_q) ? of_q : '0;
  assign launch_o = passes && begins_q;

  // ---- The column, voxel after voxel: address, planes, verdict -------------------------------------------
  logic read_q, judge_q, read_occupied_q, judge_occupied_q;
  logic [CoordW-1:0] z, read_z_q, judge_z_q;
  logic [2:0] read_axis;
  assign first = todo_q & (~todo_q + 1'b1);
  always_comb begin
    z = '0;
    for (int i = 0; i < N; i++) if (first[i]) z = z | (start.dz[DirW-1] ? CoordW'(N - 1 - i) : CoordW'(i));
  end
  assign addr_o = z;
  logic leaves_q, turns;  // turns: the ray leaves the voxel to the side
  assign turns = !leaves_q && (read_z_q == last_q);
  assign read_axis = !turns ? 3'b100 : along_y_q ? 3'b010 : 3'b001;

  rc2_pkg::face_t face;
  logic seen, reached, in_room, touches;
  rc2_ray_face u_face (
      .clk_i    (clk_i),
      .ox_i     (start.ox),
      .oy_i     (start.oy),
      .oz_i     (start.oz),
      .dx_i     (start.dx),
      .dy_i     (start.dy),
      .dz_i     (start.dz),
      .inside_i (start.in_glass),
      .x_i      (x_i),
      .y_i      (y_i),
      .z_i      (read_z_q),
      .axis_i   (read_axis),
      .owner_i  (owner_i),
      .optics_i (optics_i),
      .face_o   (face),
      .seen_o   (seen),
      .reached_o(reached),
      .in_room_o(in_room),
      .touches_o(touches)
  );
  logic judged, stops, slips, scanned, flees, rescued, ends;
  assign judged = scanning_q && judge_q && judge_occupied_q;
  assign stops = judged && reached;
  assign slips = scanning_q && judge_q && !judge_occupied_q && ray_q.touched;
  assign scanned = scanning_q && judge_q && !read_q && (todo_q == 0) && !stops && !slips;
  assign flees = passing_q && beyond_q;  // out of the cube
  assign rescued = slips || (flees && ray_q.in_room);
  assign ends = stops || slips || flees;
  assign pop_o = (ends && !begins_q) ? of_q : '0;

  // ---- Arithmetic ------------------------------------------------------------------------------------
  logic unit_done, none;
  logic [DecisionW-1:0] decision;
  logic [RiseW-1:0] exit_x, exit_y, slope_x, slope_y;
  logic [PlaceW-1:0] px, py, pz;
  logic [DirW-1:0] bx, by, bz;
  rc2_pkg::face_t met;
  assign met = ray_q.face;
  rc2_ray_unit u_unit (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .start_i   (fresh_q && (launching_q || meeting_q || bending_q || mirroring_q)),
      .op_i      (launching_q ? rc2_pkg::OpLaunch : meeting_q ? rc2_pkg::OpMeet :
                  bending_q ? rc2_pkg::OpRefract : rc2_pkg::OpReflect),
      .ox_i      (start.ox),
      .oy_i      (start.oy),
      .oz_i      (start.oz),
      .dx_i      (start.dx),
      .dy_i      (start.dy),
      .dz_i      (start.dz),
      .face_i    (met),
      .vx_i      (ray_q.vx),
      .vy_i      (ray_q.vy),
      .vz_i      (ray_q.vz),
      .done_o    (unit_done),
      .decision_o(decision),
      .exit_x_o  (exit_x),
      .exit_y_o  (exit_y),
      .slope_x_o (slope_x),
      .slope_y_o (slope_y),
      .px_o      (px),
      .py_o      (py),
      .pz_o      (pz),
      .bx_o      (bx),
      .by_o      (by),
      .bz_o      (bz),
      .none_o    (none)
  );

  // ---- New rays: what they are worth ---------------------------------------------------------------------
  logic send_mirrored, send_cleared, is_here;
  logic [WeightW-1:0] mirrored_weight, cleared_weight;
  logic [1:0] too_light, too_deep;
  rc2_ray_share u_share (
      .limits_i         (limits_i),
      .node_i           (start.node),
      .weight_i         (start.weight),
      .mirror_i         (met.mirror),
      .clear_i          (met.clear),
      .all_back_i       (met.glass && none),
      .mirrored_o       (send_mirrored),
      .mirrored_weight_o(mirrored_weight),
      .cleared_o        (send_cleared),
      .cleared_weight_o (cleared_weight),
      .too_light_o      (too_light),
      .too_deep_o       (too_deep)
  );

  // Where they start: where the old ray ended, moved into the voxel in which it stopped.
  logic rescued_q;
  logic [CoordW-1:0] hx_q, hy_q, hz_q;
  rc2_pkg::answer_t answer_q;
  rc2_pkg::end_t ended;
  logic signed [PlaceW-1:0] low_x, low_y, low_z, ex, ey, ez;
  localparam logic [PlaceFracW-1:0] Half = PlaceFracW'(1) << (PlaceFracW - 1);
  localparam logic signed [PlaceW-1:0] Most = PlaceW'((1 << PlaceFracW) - 1);
  assign low_x = $signed(PlaceW'({hx_q, {PlaceFracW{1'b0}}})) - $signed(PlaceW'(Half));
  assign low_y = $signed(PlaceW'({hy_q, {PlaceFracW{1'b0}}})) - $signed(PlaceW'(Half));
  assign low_z = $signed(PlaceW'({hz_q, {PlaceFracW{1'b0}}})) - $signed(PlaceW'(Half));
  assign ex = ($signed(px) < low_x) ? low_x : ($signed(px) > low_x + Most) ? low_x + Most : $signed(px);
  assign ey = ($signed(py) < low_y) ? low_y : ($signed(py) > low_y + Most) ? low_y + Most : $signed(py);
  assign ez = ($signed(pz) < low_z) ? low_z : ($signed(pz) > low_z + Most) ? low_z + Most : $signed(pz);
  assign is_here = (hx_q == x_i) && (hy_q == y_i);

  always_comb begin
    ended.escaped = 1'b0;
    ended.rescued = rescued_q;
    ended.back = met.back;
    ended.facet = met.facet;
    ended.vx = ray_q.vx;
    ended.vy = ray_q.vy;
    ended.vz = ray_q.vz;
    ended.px = px;
    ended.py = py;
    ended.pz = pz;
    ended.too_light = too_light;
    ended.too_deep = too_deep;
  end

  // ---- They begin here, if there is room, the mirrored one first ---------------------------------------
  logic begins_mirrored, begins_cleared;
  assign begins_mirrored = first_child_q && answer_q.mirrored && is_here && spawn_room_i;
  assign begins_cleared = second_child_q && answer_q.cleared && is_here && spawn_room_i;
  assign spawn_o = begins_mirrored || begins_cleared;
  always_comb begin
    spawn_ray_o = start;
    spawn_ray_o.node = {start.node[NodeW-2:0], second_child_q};
    spawn_ray_o.in_glass = second_child_q ? answer_q.cleared_inside : start.in_glass;
    spawn_ray_o.weight = second_child_q ? answer_q.cleared_weight : answer_q.mirrored_weight;
    spawn_ray_o.ox = answer_q.ex;
    spawn_ray_o.oy = answer_q.ey;
    spawn_ray_o.oz = answer_q.ez;
    spawn_ray_o.dx = second_child_q ? answer_q.cx : bx;
    spawn_ray_o.dy = second_child_q ? answer_q.cy : by;
    spawn_ray_o.dz = second_child_q ? answer_q.cz : bz;
  end
  assign answer_o = answering_q;
  assign answer_ray_o = answer_q;

  // ---- Registers -------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      launching_q    <= 1'b0;
      launched_q     <= 1'b0;
      running_q      <= 1'b0;
      scanning_q     <= 1'b0;
      passing_q      <= 1'b0;
      meeting_q      <= 1'b0;
      bending_q      <= 1'b0;
      sharing_q      <= 1'b0;
      mirroring_q    <= 1'b0;
      first_child_q  <= 1'b0;
      second_child_q <= 1'b0;
      answering_q    <= 1'b0;
    end else begin
      launching_q <= take_spawned || (launching_q && !unit_done);
      launched_q <= launching_q && unit_done;
      running_q <= launched_q;
      scanning_q <= ((take_head || running_q) && todo != 0) ||
                    (scanning_q && !scanned && !stops && !slips);
      passing_q <= (((take_head && beyond) || running_q) && todo == 0) || scanned;
      meeting_q <= stops || slips || (flees && ray_q.in_room) || (meeting_q && !unit_done);
      bending_q <= (meeting_q && unit_done && met.glass) || (bending_q && !unit_done);
      sharing_q <= (meeting_q && unit_done && !met.glass) || (bending_q && unit_done);
      mirroring_q <= (sharing_q && send_mirrored) || (mirroring_q && !unit_done);
      first_child_q <= (sharing_q && !send_mirrored) || (mirroring_q && unit_done);
      second_child_q <= first_child_q;
      answering_q <= second_child_q || (flees && !ray_q.in_room) || (answering_q && !answer_taken_i);
    end
    fresh_q <= take_spawned || ends || (meeting_q && unit_done) || sharing_q;

    if (take_head) ray_q <= head;
    if (take_spawned) begin
      ray_q.start   <= spawned_ray_i;
      ray_q.z       <= CoordW'(($signed(spawned_ray_i.oz) + $signed(PlaceW'(Half))) >>> PlaceFracW);
      ray_q.in_room <= 1'b0;
      ray_q.touched <= 1'b0;
    end
    if (launched_q) begin
      ray_q.decision <= decision;
      ray_q.exit_x   <= exit_x;
      ray_q.exit_y   <= exit_y;
      ray_q.slope_x  <= slope_x;
      ray_q.slope_y  <= slope_y;
    end
    if (take_head) of_q <= turn;
    if (idle) begins_q <= take_spawned;
    if (idle || running_q) begin
      todo_q        <= todo;
      last_q        <= last;
      along_y_q     <= along_y;
      beyond_q      <= beyond;
      leaves_q      <= leaves;
    end else begin
      todo_q <= todo_q & ~first;
    end

    read_q           <= scanning_q && !ends && (todo_q != 0);
    read_z_q         <= z;
    read_occupied_q  <= occupied_i[z];
    judge_q          <= scanning_q && !ends && read_q;
    judge_z_q        <= read_z_q;
    judge_occupied_q <= read_occupied_q;
    if (judged) begin
      ray_q.in_room <= in_room;
      if (touches) begin
        ray_q.touched <= 1'b1;
        ray_q.vx      <= x_i;
        ray_q.vy      <= y_i;
        ray_q.vz      <= judge_z_q;
        ray_q.face    <= face;
      end
    end

    if (ends) begin
      rescued_q <= rescued;
      hx_q      <= flees ? ray_q.vx : x_i;
      hy_q      <= flees ? ray_q.vy : y_i;
      hz_q      <= flees ? ray_q.vz : judge_z_q;
    end
    if (flees && !ray_q.in_room) begin
      answer_q.start    <= ray_q.start;
      answer_q.ended    <= {1'b1, {(rc2_pkg::EndW - 1) {1'b0}}};
      answer_q.mirrored <= 1'b0;
      answer_q.cleared  <= 1'b0;
    end
    if (sharing_q) begin
      answer_q.start           <= ray_q.start;
      answer_q.ended           <= ended;
      answer_q.ex              <= ex;
      answer_q.ey              <= ey;
      answer_q.ez              <= ez;
      answer_q.mirrored        <= send_mirrored;
      answer_q.mirrored_weight <= mirrored_weight;
      answer_q.cleared         <= send_cleared;
      answer_q.cleared_inside  <= start.in_glass ^ met.glass;
      answer_q.cleared_weight  <= cleared_weight;
      answer_q.cx              <= met.glass ? bx : start.dx;
      answer_q.cy              <= met.glass ? by : start.dy;
      answer_q.cz              <= met.glass ? bz : start.dz;
    end
    if (first_child_q) begin
      answer_q.mx       <= bx;
      answer_q.my       <= by;
      answer_q.mz       <= bz;
      answer_q.mirrored <= answer_q.mirrored && !begins_mirrored;
    end
    if (second_child_q) answer_q.cleared <= answer_q.cleared && !begins_cleared;
  end

  // Contract: one thing at a time; a ray that has begun here has room to go on.
  always_ff @(posedge clk_i) begin
    if (rst_ni && !clear_i) begin
      assert (!(launch_o && !launch_room_i));
      assert (!(scanning_q && passing_q) && !(meeting_q && bending_q) && !(sharing_q && answering_q));
    end
  end

  assign probe_o = take_spawned || take_head;
  assign plane_o = judged && seen;
  assign busy_o = !idle;
endmodule
