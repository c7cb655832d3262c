// SPDX-License-Identifier: Apache-2.0
//
// The last stage of a ray that goes no further: its new rays begin here if there is room, the mirrored one
// first, a cycle each; then it is answered, with those for which there was none. It waits for the answer
// to leave, and for nothing else (docs/render.md has why). From the cycle in which a hit is taken the
// answer is there after 3; the next may be taken in the one after it has left. Thesis 1.3.2.

module rc2_ray_answer (
    input  logic                             clk_i,
    input  logic                             rst_ni,
    input  logic [     rc2_pkg::CoordW-1:0] x_i,
    input  logic [     rc2_pkg::CoordW-1:0] y_i,
    input  logic                             hit_i,
    input  rc2_pkg::answer_t                hit_ray_i,
    output logic                             free_o,
    // new rays
    input  logic                             spawn_room_i,
    output logic                             spawn_o,
    output rc2_pkg::start_t                 spawn_ray_o,
    // the answer
    output logic                             answer_o,
    output rc2_pkg::answer_t                answer_ray_o,
    input  logic                             answer_taken_i
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned NodeW = rc2_pkg::NodeW;

  logic mirrored_q, cleared_q, answering_q;
  assign free_o = !(mirrored_q || cleared_q || answering_q);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      mirrored_q  <= 1'b0;
      cleared_q   <= 1'b0;
      answering_q <= 1'b0;
    end else begin
      mirrored_q  <= hit_i && free_o;
      cleared_q   <= mirrored_q;
      answering_q <= cleared_q || (answering_q && !answer_taken_i);
    end
  end

  // ---- New rays: where the hit is, which may have been in another cell ---------------------------------
  rc2_pkg::answer_t answer_q;
  rc2_pkg::start_t sender;
  logic [PlaceW-1:0] place_x, place_y;
  logic is_here, begins_mirrored, begins_cleared;
  assign sender = answer_q.start;
  assign place_x = answer_q.ex + (PlaceW'(1) << (PlaceFracW - 1));
  assign place_y = answer_q.ey + (PlaceW'(1) << (PlaceFracW - 1));
  assign is_here = (place_x[PlaceFracW+:CoordW] == x_i) && (place_y[PlaceFracW+:CoordW] == y_i);
  assign begins_mirrored = mirrored_q && answer_q.mirrored && is_here && spawn_room_i;
  assign begins_cleared = cleared_q && answer_q.cleared && is_here && spawn_room_i;
  assign spawn_o = begins_mirrored || begins_cleared;
  always_comb begin
    spawn_ray_o = sender;
    spawn_ray_o.node = {sender.node[NodeW-2:0], cleared_q};
    spawn_ray_o.in_glass = cleared_q ? answer_q.cleared_inside : sender.in_glass;
    spawn_ray_o.weight = cleared_q ? answer_q.cleared_weight : answer_q.mirrored_weight;
    spawn_ray_o.ox = answer_q.ex;
    spawn_ray_o.oy = answer_q.ey;
    spawn_ray_o.oz = answer_q.ez;
    spawn_ray_o.dx = cleared_q ? answer_q.cx : answer_q.mx;
    spawn_ray_o.dy = cleared_q ? answer_q.cy : answer_q.my;
    spawn_ray_o.dz = cleared_q ? answer_q.cz : answer_q.mz;
  end

  always_ff @(posedge clk_i) begin
    if (hit_i && free_o) answer_q <= hit_ray_i;
    if (begins_mirrored) answer_q.mirrored <= 1'b0;
    if (begins_cleared) answer_q.cleared <= 1'b0;
  end
  assign answer_o = answering_q;
  assign answer_ray_o = answer_q;

  // Contract: one thing at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(mirrored_q && cleared_q) && !(answering_q && (mirrored_q || cleared_q)));
      assert (!(answer_taken_i && !answering_q));
    end
  end
endmodule
