// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_ray_net: rays of each quadrant from both sides, on each way out, begun and
// ended; answers and starts on every way; every queue full; every end that a ray can have.

module ray_net_points (
    input logic                              clk_i,
    input logic                              rst_ni,
    input logic                              clear_i,
    input rc2_pkg::limits_t                  limits_i,
    input logic [     4*rc2_pkg::LinkW-1:0] link_o,
    input logic [ 4*rc2_pkg::LinkRoomW-1:0] room_o,
    input logic [                       7:0] pass_i,
    input logic [                       7:0] pop_i,
    input logic [    4*rc2_pkg::RayW-1:0] ray_i,
    input logic                              spawned_o,
    input logic                              launch_room_o,
    input logic [                       3:0] launch_i,
    input logic                              spawn_room_o,
    input logic                              spawn_i,
    input logic                              answer_i,
    input rc2_pkg::answer_t                  answer_ray_i,
    input logic                              answer_taken_o,
    input logic                              home_i,
    input logic                              home_taken_o,
    input logic [                       4:0] arrived_o,
    input logic [                       4:0] arrived_taken_i
);
  localparam int unsigned LinkW = rc2_pkg::LinkW;
  localparam int unsigned MessageW = rc2_pkg::MessageW;
  localparam int unsigned LinkRoomW = rc2_pkg::LinkRoomW;
  logic runs;
  assign runs = rst_ni && !clear_i;

  // ---- Rays --------------------------------------------------------------------------------------
  for (genvar k = 0; k < 8; k++) begin : g_queue  // quadrant and axis
    always_ff @(posedge clk_i) begin
      if (runs) begin
        ray_passes : cover (pass_i[k]);
        ray_ends : cover (pop_i[k]);
      end
    end
  end
  for (genvar q = 0; q < 4; q++) begin : g_quadrant
    rc2_pkg::ray_t ray;
    assign ray = ray_i[q*rc2_pkg::RayW+:rc2_pkg::RayW];
    always_ff @(posedge clk_i) begin
      if (runs) begin
        begins_along_x : cover (launch_i[q] && !ray.along_y);
        begins_along_y : cover (launch_i[q] && ray.along_y);
      end
    end
  end

  // ---- Ways: E W N S -----------------------------------------------------------------------------
  for (genvar w = 0; w < 4; w++) begin : g_way
    localparam int unsigned Low = w < 2 ? w : (w == 2) ? 0 : 2;  // the two quadrants that go this way
    localparam int unsigned High = w < 2 ? w + 2 : Low + 1;
    logic [LinkRoomW-1:0] kind, room;
    assign kind = link_o[w*LinkW+MessageW+:LinkRoomW];
    assign room = room_o[w*LinkRoomW+:LinkRoomW];
    always_ff @(posedge clk_i) begin
      if (runs) begin
        ray_of_either_quadrant_leaves : cover (kind[Low]);
        ray_of_the_other_leaves : cover (kind[High]);
        answer_leaves : cover (kind[4]);
        start_leaves : cover (kind[5]);
        answer_comes_home : cover (arrived_taken_i[w]);
        either_queue_is_full : cover (!room[Low]);
        the_other_is_full : cover (!room[High]);
        queue_of_answers_is_full : cover (!room[4]);
        queue_of_starts_is_full : cover (!room[5]);
      end
    end
  end

  // ---- Rays that begin, answers, the home --------------------------------------------------------------
  logic ended;
  rc2_pkg::end_t how;
  assign ended = answer_i && answer_taken_o;
  assign how = answer_ray_i.ended;
  always_ff @(posedge clk_i) begin
    if (runs) begin
      runs_on : cover (spawn_i);
      no_room_to_begin : cover (!spawn_room_o);
      begun_ray_waits_for_the_one_before : cover (spawned_o && !launch_room_o);
      own_answer_waits : cover (answer_i && !answer_taken_o);
      own_answer_is_home : cover (arrived_taken_i[4]);
      home_sends : cover (home_taken_o);
      home_waits : cover (home_i && !home_taken_o);
      fewer_places_than_built : cover (launch_i != 0 && limits_i.places < rc2_pkg::RayCountW'(rc2_pkg::RAYQ));
      all_places : cover (launch_i != 0 && limits_i.places == rc2_pkg::RayCountW'(rc2_pkg::RAYQ));
      escapes : cover (ended && how.escaped);
      hits : cover (ended && !how.escaped && !how.rescued);
      is_rescued : cover (ended && how.rescued);
      sees_an_inner_side : cover (ended && how.back);
      one_child_too_light : cover (ended && how.too_light == 2'd1);
      two_children_too_light : cover (ended && how.too_light == 2'd2);
      one_child_too_deep : cover (ended && how.too_deep == 2'd1);
      two_children_too_deep : cover (ended && how.too_deep == 2'd2);
      mirrored_goes_home : cover (ended && answer_ray_i.mirrored && !answer_ray_i.cleared);
      cleared_goes_home : cover (ended && !answer_ray_i.mirrored && answer_ray_i.cleared);
      both_go_home : cover (ended && answer_ray_i.mirrored && answer_ray_i.cleared);
    end
  end
endmodule

bind rc2_ray_net ray_net_points u_points (.*);
