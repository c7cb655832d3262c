// SPDX-License-Identifier: Apache-2.0
//
// What a cell does with rays, in stages that work side by side (docs/render.md, thesis 1.3.2):
//
//   begins --> launch (2) --+
//                           v
//   queues -----------> look (4) ----------------------------------> network
//                           |                                      |
//                           +--> read --> hit (2: meet, bend) --> answer
//
// A look for each quadrant, with its own way into the network. A ray that passes nothing waits for no
// arithmetic, only for its look's turn. Every stage waits for those behind it only, the last for its answer
// to leave. How long each takes: its own file.

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
    output logic [                      7:0] pass_o,  // the head goes on, as its quadrant's ray_o
    output logic [                      7:0] pop_o,   // the head has ended
    // rays that begin here
    input  logic                             spawned_i,
    input  rc2_pkg::start_t                  spawned_ray_i,
    output logic                             spawned_taken_o,
    input  logic                             launch_room_i,
    output logic [                      3:0] launch_o,  // it goes on, as its quadrant's ray_o
    output logic [    4*rc2_pkg::RayW-1:0] ray_o,
    // new rays, and the answer
    input  logic                             spawn_room_i,
    output logic                             spawn_o,
    output rc2_pkg::start_t                  spawn_ray_o,
    output logic                             answer_o,
    output rc2_pkg::answer_t                 answer_ray_o,
    input  logic                             answer_taken_i,
    // what happens
    output logic                             plane_o,  // a ray is held against a facet
    output logic [                      8:0] work_o,   // of its units: 4 look, 1 read, 2 launch, 2 meet
    output logic                             busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned MessageW = rc2_pkg::MessageW;
  localparam int unsigned RayW = rc2_pkg::RayW;
  localparam int unsigned DirW = rc2_pkg::DirW;

  // ---- The ray that begins here has its turn in its quadrant --------------------------------------------
  logic begins, launch_busy, launch_ready;
  logic [3:0] begins_in;
  logic [8:0] held;
  rc2_pkg::ray_t begins_ray;
  rc2_pkg::start_t start;
  assign begins = launch_ready && launch_room_i && !held[8];
  assign start = begins_ray.start;
  assign begins_in = (4'd1 << {start.dy[DirW-1], start.dx[DirW-1]}) & {4{begins}};

  // ---- Looks, by quadrant, and the way on to the network ------------------------------------------------
  logic read_early, read_free, read_along_y;
  logic [8:0] read_pass;
  logic [CoordW-1:0] read_z;
  rc2_pkg::ray_t read_ray;
  logic [3:0] wants, turn, takes, blocks, look_leaves, look_beyond, look_along_y, look_launches, look_work;
  logic [8:0] from;
  logic [4*N-1:0] look_todo;
  logic [4*CoordW-1:0] look_z;
  logic [4*RayW-1:0] look_ray;
  rc2_rotate #(
      .Ways(4)
  ) u_turn (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni && !clear_i),
      .request_i(wants),
      .take_i   (read_free),
      .grant_o  (turn)
  );
  assign takes = turn & {4{read_free}};
  logic [3:0] begins_from;
  assign from[8] = (begins_from != 0);
  for (genvar q = 0; q < 4; q++) begin : g_quadrant
    logic [2:0] waits, pass, seen;
    assign waits = {begins_in[q], waits_i[2*q+:2] & ~held[2*q+:2]};
    rc2_ray_look u_look (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni && !clear_i),
        .x_i       (x_i),
        .y_i       (y_i),
        .occupied_i(occupied_i),
        .solid_i   (solid_i),
        .waits_i   (waits),
        .heads_i   (heads_i[2*q*MessageW+:2*MessageW]),
        .begins_i  (begins_ray),
        .early_i   (read_early),
        .given_i   (takes[q]),
        .blocks_i  (blocks[q]),
        .wants_o   (wants[q]),
        .todo_o    (look_todo[q*N+:N]),
        .leaves_o  (look_leaves[q]),
        .beyond_o  (look_beyond[q]),
        .pass_o    (pass),
        .turn_o    (seen),
        .ray_o     (look_ray[q*RayW+:RayW]),
        .z_o       (look_z[q*CoordW+:CoordW]),
        .along_y_o (look_along_y[q]),
        .work_o    (look_work[q])
    );
    assign {begins_from[q], from[2*q+:2]} = seen & {3{turn[q]}};
    assign look_launches[q] = look_work[q] && seen[2];
    rc2_ray_step u_step (
        .ray_i    (blocks[q] ? read_ray : look_ray[q*RayW+:RayW]),
        .z_i      (blocks[q] ? read_z : look_z[q*CoordW+:CoordW]),
        .along_y_i(blocks[q] ? read_along_y : look_along_y[q]),
        .ray_o    (ray_o[q*RayW+:RayW])
    );
    assign pass_o[2*q+:2] = pass[1:0] | read_pass[2*q+:2];
    assign launch_o[q] = pass[2] || (read_pass[8] && blocks[q]);
  end
  assign work_o[3:0] = look_work;

  // ---- The reader, and what it is given -------------------------------------------------------------------
  logic [N-1:0] todo;
  logic [CoordW-1:0] last_z;
  logic [RayW-1:0] to_read;
  always_comb begin
    todo = '0;
    last_z = '0;
    to_read = '0;
    for (int q = 0; q < 4; q++) begin
      todo = todo | (look_todo[q*N+:N] & {N{turn[q]}});
      last_z = last_z | (look_z[q*CoordW+:CoordW] & {CoordW{turn[q]}});
      to_read = to_read | (look_ray[q*RayW+:RayW] & {RayW{turn[q]}});
    end
  end
  logic stops, stop_taken, read_busy;
  rc2_pkg::stop_t stop_ray;
  rc2_ray_read u_read (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni && !clear_i),
      .x_i         (x_i),
      .y_i         (y_i),
      .occupied_i  (occupied_i),
      .addr_o      (addr_o),
      .owner_i     (owner_i),
      .optics_i    (optics_i),
      .take_i      (takes != 0),
      .from_i      (from),
      .ray_i       (to_read),
      .todo_i      (todo),
      .last_i      (last_z),
      .along_y_i   ((look_along_y & turn) != 0),
      .leaves_i    ((look_leaves & turn) != 0),
      .beyond_i    ((look_beyond & turn) != 0),
      .early_o     (read_early),
      .free_o      (read_free),
      .held_o      (held),
      .blocks_o    (blocks),
      .pass_o      (read_pass),
      .ray_o       (read_ray),
      .z_o         (read_z),
      .along_y_o   (read_along_y),
      .ends_o      (pop_o),
      .stop_o      (stops),
      .stop_ray_o  (stop_ray),
      .stop_taken_i(stop_taken),
      .plane_o     (plane_o),
      .busy_o      (read_busy),
      .work_o      (work_o[4])
  );

  // ---- A ray that begins ---------------------------------------------------------------------------
  rc2_ray_launches u_launches (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni && !clear_i),
      .begin_i    (spawned_i),
      .begin_ray_i(spawned_ray_i),
      .taken_o    (spawned_taken_o),
      .busy_o     (launch_busy),
      .ready_o    (launch_ready),
      .ray_o      (begins_ray),
      .leave_i    (look_launches != 0),
      .work_o     (work_o[6:5])
  );

  // ---- A ray that goes no further ------------------------------------------------------------------
  logic hit, answer_free, hit_busy;
  rc2_pkg::answer_t hit_ray;
  rc2_ray_hits u_hits (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni && !clear_i),
      .limits_i    (limits_i),
      .stop_i      (stops),
      .stop_ray_i  (stop_ray),
      .taken_o     (stop_taken),
      .answer_o    (hit),
      .answer_ray_o(hit_ray),
      .free_i      (answer_free),
      .busy_o      (hit_busy),
      .work_o      (work_o[8:7])
  );
  rc2_ray_answer u_answer (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni && !clear_i),
      .x_i           (x_i),
      .y_i           (y_i),
      .hit_i         (hit),
      .hit_ray_i     (hit_ray),
      .free_o        (answer_free),
      .spawn_room_i  (spawn_room_i),
      .spawn_o       (spawn_o),
      .spawn_ray_o   (spawn_ray_o),
      .answer_o      (answer_o),
      .answer_ray_o  (answer_ray_o),
      .answer_taken_i(answer_taken_i)
  );
  assign busy_o = (waits_i != 0) || launch_busy || read_busy || hit_busy || !answer_free;

  // Contract: a ray that has begun here has room to go on; one ray of a quadrant goes on, and none that ends.
  always_ff @(posedge clk_i) begin
    if (rst_ni && !clear_i) begin
      assert (launch_o == 0 || launch_room_i);
      assert ((launch_o & (launch_o - 1'b1)) == 0);
      assert ((pass_o & pop_o) == 0);
      for (int q = 0; q < 4; q++) assert (2'(pass_o[2*q]) + 2'(pass_o[2*q+1]) + 2'(launch_o[q]) <= 2'd1);
    end
  end
endmodule
