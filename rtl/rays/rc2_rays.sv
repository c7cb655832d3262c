// SPDX-License-Identifier: Apache-2.0
//
// What a cell has for rays (docs/render.md, thesis 1.3.2): what its voxels do with light, its engine, its
// part of the network, and its pixel's home. start_i begins a trace of the rays that the host has put
// into the homes; the cell is busy until all that it holds has gone. Two cycles a hop at least.

module rc2_rays (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              clear_i,  // forget the rays and the hits
    input  logic                              start_i,
    input  logic [      rc2_pkg::CoordW-1:0] x_i,
    input  logic [      rc2_pkg::CoordW-1:0] y_i,
    input  rc2_pkg::limits_t                 limits_i,
    // the column
    input  logic [           rc2_pkg::N-1:0] occupied_i,
    input  logic [           rc2_pkg::N-1:0] solid_i,
    output logic [      rc2_pkg::CoordW-1:0] addr_o,
    output logic                             reads_o,  // addr_o is to be read
    input  rc2_pkg::claim_t                  owner_i,  // of the address in the cycle before
    // HEAD and RAY words as they leave the row's pipe
    input  logic                             word_i,
    input  logic [       rc2_pkg::KindW-1:0] kind_i,
    input  logic [       rc2_pkg::RestW-1:0] rest_i,
    output logic                             ready_o,
    // readback
    input  logic                             read_i,
    output logic                             read_done_o,
    input  logic                             read_done_taken_i,
    output logic                             data_valid_o,
    output rc2_pkg::data_t                   data_o,
    input  logic                             data_ready_i,
    // links, by the way that a message goes: E, W, N, S from the lowest
    input  logic [     4*rc2_pkg::LinkW-1:0] link_i,
    output logic [ 4*rc2_pkg::LinkRoomW-1:0] room_o,
    output logic [     4*rc2_pkg::LinkW-1:0] link_o,
    input  logic [ 4*rc2_pkg::LinkRoomW-1:0] room_i,
    output logic                             busy_o
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned RestW = rc2_pkg::RestW;

  // ---- Loading -----------------------------------------------------------------------------------
  logic [CoordW-1:0] seek_addr, probe_addr;
  rc2_pkg::optics_t optics;
  rc2_ray_surface u_surface (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .word_i     (word_i),
      .kind_i     (kind_i),
      .rest_i     (rest_i),
      .ready_o    (ready_o),
      .addr_o     (seek_addr),
      .owner_i    (owner_i),
      .read_addr_i(probe_addr),
      .optics_o   (optics)
  );
  logic working;
  assign addr_o  = working ? probe_addr : seek_addr;
  assign reads_o = working || !ready_o;

  logic [rc2_pkg::SortW-1:0] sort;
  logic is_ray, first;
  logic [3*PlaceW-1:0] origin_q;
  rc2_pkg::start_t first_ray;
  assign sort = rest_i[RestW-1-:rc2_pkg::SortW];
  assign is_ray = word_i && (kind_i == rc2_pkg::KindRay);
  assign first = is_ray && (sort == rc2_pkg::SortDirection);
  always_ff @(posedge clk_i) begin
    if (is_ray && sort == rc2_pkg::SortOrigin) origin_q <= rest_i[3*PlaceW-1:0];
  end
  always_comb begin
    first_ray.home_x = x_i;
    first_ray.home_y = y_i;
    first_ray.node = rc2_pkg::NodeW'(1);
    first_ray.in_glass = 1'b0;
    first_ray.weight = {1'b1, {(rc2_pkg::WeightW - 1) {1'b0}}};
    {first_ray.ox, first_ray.oy, first_ray.oz} = origin_q;
    {first_ray.dx, first_ray.dy, first_ray.dz} = rest_i[3*DirW-1:0];
  end

  // ---- Tracing -----------------------------------------------------------------------------------
  logic running_q, net_busy, reading;
  logic [7:0] waits, pass, pop;
  logic [8*rc2_pkg::MessageW-1:0] heads;
  logic [4*rc2_pkg::RayW-1:0] ray;
  logic [3:0] launch;
  rc2_pkg::start_t spawned_ray, spawn_ray, home_ray;
  rc2_pkg::answer_t answer_ray;
  logic spawned, spawned_taken, launch_room, spawn_room, spawn;
  logic answer, answer_taken, home, home_taken, plane;
  logic [8:0] work;
  logic [4:0] arrived, arrived_taken;
  logic [5*rc2_pkg::MessageW-1:0] answers;
  logic [2:0] hops;
  rc2_ray_engine u_engine (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .clear_i        (clear_i),
      .x_i            (x_i),
      .y_i            (y_i),
      .limits_i       (limits_i),
      .occupied_i     (occupied_i),
      .solid_i        (solid_i),
      .addr_o         (probe_addr),
      .owner_i        (owner_i),
      .optics_i       (optics),
      .waits_i        (waits),
      .heads_i        (heads),
      .pass_o         (pass),
      .pop_o          (pop),
      .spawned_i      (spawned),
      .spawned_ray_i  (spawned_ray),
      .spawned_taken_o(spawned_taken),
      .launch_room_i  (launch_room),
      .launch_o       (launch),
      .ray_o          (ray),
      .spawn_room_i   (spawn_room),
      .spawn_o        (spawn),
      .spawn_ray_o    (spawn_ray),
      .answer_o       (answer),
      .answer_ray_o   (answer_ray),
      .answer_taken_i (answer_taken),
      .plane_o        (plane),
      .work_o         (work),
      .busy_o         (working)
  );
  rc2_ray_net u_net (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .clear_i        (clear_i),
      .x_i            (x_i),
      .y_i            (y_i),
      .limits_i       (limits_i),
      .link_i         (link_i),
      .room_o         (room_o),
      .link_o         (link_o),
      .room_i         (room_i),
      .waits_o        (waits),
      .heads_o        (heads),
      .pass_i         (pass),
      .pop_i          (pop),
      .ray_i          (ray),
      .spawned_o      (spawned),
      .spawned_ray_o  (spawned_ray),
      .spawned_taken_i(spawned_taken),
      .launch_room_o  (launch_room),
      .launch_i       (launch),
      .spawn_room_o   (spawn_room),
      .spawn_i        (spawn),
      .spawn_ray_i    (spawn_ray),
      .answer_i       (answer),
      .answer_ray_i   (answer_ray),
      .answer_taken_o (answer_taken),
      .home_i         (home),
      .home_ray_i     (home_ray),
      .home_taken_o   (home_taken),
      .arrived_o      (arrived),
      .answers_o      (answers),
      .arrived_taken_i(arrived_taken),
      .hops_o         (hops),
      .busy_o         (net_busy)
  );
  rc2_ray_home u_home (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .clear_i          (clear_i),
      .run_i            (running_q),
      .first_i          (first),
      .first_ray_i      (first_ray),
      .waits_o          (home),
      .ray_o            (home_ray),
      .taken_i          (home_taken),
      .arrived_i        (arrived),
      .answers_i        (answers),
      .arrived_taken_o  (arrived_taken),
      .plane_i          (plane),
      .run_on_i         (spawn),
      .hops_i           (hops),
      .work_i           (work),
      .read_i           (read_i),
      .read_done_o      (read_done_o),
      .read_done_taken_i(read_done_taken_i),
      .data_valid_o     (data_valid_o),
      .data_o           (data_o),
      .data_ready_i     (data_ready_i),
      .busy_o           (reading)
  );
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) running_q <= 1'b0;
    else if (start_i) running_q <= 1'b1;
  end
  assign busy_o = working || net_busy || reading || !ready_o;
endmodule
