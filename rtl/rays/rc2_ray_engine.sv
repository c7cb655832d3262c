// SPDX-License-Identifier: Apache-2.0
//
// What a cell does with rays, in stages that work side by side (docs/render.md, thesis 1.3.2):
//
//   begins --> launch --+
//                       v
//   queues ---------> look ----------------------------------> network
//                       |                                    |
//                       +--> read --> hit (meet, bend) --> answer
//
// A ray that passes nothing never waits for arithmetic. Every stage waits for those behind it only, the
// last for its answer to leave. How long each takes: its own file.

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
    output logic                             plane_o,  // a ray is held against a facet
    output logic [                      3:0] work_o,   // of its stages: look, read, launch, meet
    output logic                             busy_o
);
  // ---- What waits: queues by their heads, and the ray that begins here ------------------------------
  logic begins, launch_busy, launch_ready;
  logic [8:0] waits, held;
  rc2_pkg::ray_t begins_ray;
  assign begins = launch_ready && launch_room_i && !held[8];
  assign waits = {begins, waits_i} & ~held;

  logic look_takes, look_leaves, look_beyond, look_along_y, read_early, read_free, read_last, read_along_y;
  logic [8:0] look_pass, turn, read_pass;
  logic [7:0] ends;
  logic [rc2_pkg::N-1:0] todo;
  logic [rc2_pkg::CoordW-1:0] look_z, read_z;
  rc2_pkg::ray_t look_ray, read_ray;
  rc2_ray_look u_look (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni && !clear_i),
      .x_i       (x_i),
      .y_i       (y_i),
      .occupied_i(occupied_i),
      .solid_i   (solid_i),
      .waits_i   (waits),
      .heads_i   (heads_i),
      .begins_i  (begins_ray),
      .early_i   (read_early),
      .free_i    (read_free),
      .last_i    (read_last),
      .take_o    (look_takes),
      .todo_o    (todo),
      .leaves_o  (look_leaves),
      .beyond_o  (look_beyond),
      .pass_o    (look_pass),
      .turn_o    (turn),
      .ray_o     (look_ray),
      .z_o       (look_z),
      .along_y_o (look_along_y),
      .work_o    (work_o[0])
  );

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
      .take_i      (look_takes),
      .from_i      (turn),
      .ray_i       (look_ray),
      .todo_i      (todo),
      .last_i      (look_z),
      .along_y_i   (look_along_y),
      .leaves_i    (look_leaves),
      .beyond_i    (look_beyond),
      .early_o     (read_early),
      .free_o      (read_free),
      .held_o      (held),
      .last_o      (read_last),
      .pass_o      (read_pass),
      .ray_o       (read_ray),
      .z_o         (read_z),
      .along_y_o   (read_along_y),
      .ends_o      (ends),
      .stop_o      (stops),
      .stop_ray_o  (stop_ray),
      .stop_taken_i(stop_taken),
      .plane_o     (plane_o),
      .busy_o      (read_busy),
      .work_o      (work_o[1])
  );

  // ---- To the network ------------------------------------------------------------------------------
  rc2_ray_step u_step (
      .ray_i    (read_last ? read_ray : look_ray),
      .z_i      (read_last ? read_z : look_z),
      .along_y_i(read_last ? read_along_y : look_along_y),
      .ray_o    (ray_o)
  );
  assign {launch_o, pass_o} = look_pass | read_pass;
  assign pop_o = ends;

  // ---- A ray that begins ---------------------------------------------------------------------------
  logic launch_leaves;
  assign launch_leaves = work_o[0] && turn[8];
  assign spawned_taken_o = spawned_i && (!launch_busy || launch_leaves);
  rc2_ray_launch u_launch (
      .clk_i  (clk_i),
      .rst_ni (rst_ni && !clear_i),
      .take_i (spawned_taken_o),
      .begin_i(spawned_ray_i),
      .busy_o (launch_busy),
      .ready_o(launch_ready),
      .ray_o  (begins_ray),
      .leave_i(launch_leaves),
      .work_o (work_o[2])
  );

  // ---- A ray that goes no further ------------------------------------------------------------------
  logic hit, answer_free, hit_busy;
  rc2_pkg::answer_t hit_ray;
  rc2_ray_hit u_hit (
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
      .work_o      (work_o[3])
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

  // Contract: a ray that has begun here has room to go on; each ray goes one way.
  always_ff @(posedge clk_i) begin
    if (rst_ni && !clear_i) begin
      assert (!(launch_o && !launch_room_i));
      assert ((look_pass & read_pass) == 0 && (look_pass == 0 || read_pass == 0));
      assert ((pass_o & pop_o) == 0);
    end
  end
endmodule
