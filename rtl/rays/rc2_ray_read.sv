// SPDX-License-Identifier: Apache-2.0
//
// The stage that reads a ray's column, a voxel a cycle, until the ray passes or goes no further
// (docs/render.md, thesis 1.3.2): the address of the first in the cycle in which the ray is taken, then
// planes and verdict (rc2_ray_face). m voxels take m + 1 cycles after that one; in the last the ray goes
// on, and the next may be taken. One that goes no further waits for its next stage, a cycle at least.

module rc2_ray_read (
    input  logic                          clk_i,
    input  logic                          rst_ni,
    input  logic [  rc2_pkg::CoordW-1:0] x_i,
    input  logic [  rc2_pkg::CoordW-1:0] y_i,
    // the column
    input  logic [       rc2_pkg::N-1:0] occupied_i,
    output logic [  rc2_pkg::CoordW-1:0] addr_o,
    input  rc2_pkg::claim_t              owner_i,   // of the address in the cycle before
    input  rc2_pkg::optics_t             optics_i,
    // a ray that has something to pass, or leaves the cube
    input  logic                          take_i,
    input  logic [                   8:0] from_i,    // where it waits, one bit
    input  rc2_pkg::ray_t                ray_i,
    input  logic [       rc2_pkg::N-1:0] todo_i,    // rc2_ray_run
    input  logic [  rc2_pkg::CoordW-1:0] last_i,
    input  logic                          along_y_i,
    input  logic                          leaves_i,  // by the top or bottom
    input  logic                          beyond_i,  // that or by a side
    output logic                          early_o,   // it may be free in this cycle
    output logic                          free_o,    // it is
    output logic [                   8:0] held_o,    // it has that one
    // it goes on
    output logic [                   3:0] blocks_o,  // if at all, then in this cycle, by its quadrant
    output logic [                   8:0] pass_o,
    output rc2_pkg::ray_t                ray_o,
    output logic [  rc2_pkg::CoordW-1:0] z_o,
    output logic                          along_y_o,
    // it goes no further
    output logic [                   7:0] ends_o,    // it leaves its queue
    output logic                          stop_o,
    output rc2_pkg::stop_t               stop_ray_o,
    input  logic                          stop_taken_i,
    output logic                          plane_o,   // a ray is held against a facet
    output logic                          busy_o,
    output logic                          work_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned DirW = rc2_pkg::DirW;

  logic reading_q, ended_q, slips_q;
  rc2_pkg::ray_t ray_q;
  rc2_pkg::start_t start, new_start;
  logic [8:0] from_q;
  logic [N-1:0] todo_q;
  logic [CoordW-1:0] last_q;
  logic along_y_q, leaves_q, beyond_q;
  assign start = ray_q.start;
  assign new_start = ray_i.start;

  // ---- The next voxel -----------------------------------------------------------------------------
  logic [N-1:0] todo;
  logic any;
  logic [CoordW-1:0] first, z, read_z_q, judge_z_q;
  logic down, fetch, read_q, judge_q, read_occupied_q, judge_occupied_q;
  assign todo = (todo_q != 0) ? todo_q : todo_i;
  assign down = (todo_q != 0) ? start.dz[DirW-1] : new_start.dz[DirW-1];
  rc2_first #(
      .Width(N)
  ) u_first (
      .bits_i (todo),
      .found_o(any),
      .index_o(first)
  );
  assign z = down ? CoordW'(N - 1) - first : first;
  assign addr_o = z;

  // ---- Planes and verdict ---------------------------------------------------------------------------
  rc2_pkg::face_t face;
  logic [2:0] axis;
  logic seen, reached, in_room, touches;
  assign axis = (leaves_q || read_z_q != last_q) ? 3'b100 : along_y_q ? 3'b010 : 3'b001;
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
      .axis_i   (axis),
      .owner_i  (owner_i),
      .optics_i (optics_i),
      .face_o   (face),
      .seen_o   (seen),
      .reached_o(reached),
      .in_room_o(in_room),
      .touches_o(touches)
  );
  logic judged, stops, slips, last, passes, ends;
  assign judged = judge_q && judge_occupied_q;
  assign stops = judged && reached;
  assign slips = judge_q && !judge_occupied_q && ray_q.touched;
  assign last = judge_q && !read_q && (todo_q == 0);
  assign passes = last && !stops && !slips && !beyond_q;
  assign ends = judge_q && (stops || slips || (last && beyond_q));

  // The ray, as the voxel leaves it.
  rc2_pkg::ray_t changed;
  always_comb begin
    changed = ray_q;
    if (judged) begin
      changed.in_room = in_room;
      if (touches) begin
        changed.touched = 1'b1;
        {changed.vx, changed.vy, changed.vz} = {x_i, y_i, judge_z_q};
        changed.face = face;
      end
    end
  end

  // ---- To whom it goes -------------------------------------------------------------------------------
  logic flees, leaves;
  assign early_o = (!reading_q && !ended_q) || last || ended_q;
  assign free_o = (!reading_q && !ended_q) || passes || leaves;
  assign held_o = from_q & {9{reading_q}};
  assign blocks_o = (4'd1 << {start.dy[DirW-1], start.dx[DirW-1]}) & {4{last}};
  assign pass_o = from_q & {9{passes}};
  assign ray_o = changed;
  assign z_o = last_q;
  assign along_y_o = along_y_q;
  // One that leaves the cube and passes nothing has ended when it is taken.
  assign ends_o = (from_q[7:0] & {8{ends}}) | (from_i[7:0] & {8{take_i && todo_i == 0}});
  assign stop_o = ended_q;
  assign leaves = ended_q && stop_taken_i;
  logic [CoordW-1:0] stopped_z_q;
  logic fled_q;
  assign flees = fled_q && ray_q.in_room;
  always_comb begin
    stop_ray_o.start = ray_q.start;
    stop_ray_o.escaped = fled_q && !ray_q.in_room;
    stop_ray_o.rescued = slips_q || flees;
    stop_ray_o.hx = fled_q ? ray_q.vx : x_i;
    stop_ray_o.hy = fled_q ? ray_q.vy : y_i;
    stop_ray_o.hz = fled_q ? ray_q.vz : stopped_z_q;
    stop_ray_o.vx = ray_q.vx;
    stop_ray_o.vy = ray_q.vy;
    stop_ray_o.vz = ray_q.vz;
    stop_ray_o.face = ray_q.face;
  end

  // ---- Registers -------------------------------------------------------------------------------------
  assign fetch = take_i || (reading_q && !ends);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      reading_q <= 1'b0;
      ended_q   <= 1'b0;
      read_q    <= 1'b0;
      judge_q   <= 1'b0;
      todo_q    <= '0;
    end else begin
      reading_q <= (take_i && todo_i != 0) || (reading_q && !passes && !ends);
      ended_q   <= (take_i && todo_i == 0) || ends || (ended_q && !leaves);
      read_q    <= fetch && (take_i || todo_q != 0) && any;
      judge_q   <= read_q && !ends;
      todo_q    <= (fetch && (take_i || todo_q != 0)) ? todo & ~(N'(1) << first) : '0;
    end
    if (take_i) begin
      ray_q     <= ray_i;
      from_q    <= from_i;
      last_q    <= last_i;
      along_y_q <= along_y_i;
      leaves_q  <= leaves_i;
      beyond_q  <= beyond_i;
    end else if (judged) begin
      ray_q <= changed;
    end
    read_z_q         <= z;
    read_occupied_q  <= occupied_i[z];
    judge_z_q        <= read_z_q;
    judge_occupied_q <= read_occupied_q;
    if (take_i || ends) begin
      slips_q     <= slips && !take_i;
      fled_q      <= take_i || !(stops || slips);
      stopped_z_q <= judge_z_q;
    end
  end

  assign plane_o = judged && seen;
  assign busy_o = reading_q || ended_q;
  assign work_o = reading_q || leaves;

  // Contract: one ray at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(take_i && !free_o));
      assert (!(reading_q && ended_q));
      assert (!(judge_q && !reading_q));
    end
  end
endmodule
