// SPDX-License-Identifier: Apache-2.0
//
// The stage that looks at a ray of its quadrant a cycle: the one that begins here first, then by turns the
// heads of its queues. One that passes nothing goes on in the same cycle; another goes to the reader, if it is
// given that. If not, it is left alone until the reader may be free, so that others pass it (docs/render.md,
// thesis 1.3.2).

module rc2_ray_look (
    input  logic                             clk_i,
    input  logic                             rst_ni,
    input  logic [     rc2_pkg::CoordW-1:0] x_i,
    input  logic [     rc2_pkg::CoordW-1:0] y_i,
    input  logic [          rc2_pkg::N-1:0] occupied_i,
    input  logic [          rc2_pkg::N-1:0] solid_i,
    // heads of its queues by the axis of the way in; 2 begins here
    input  logic [                      2:0] waits_i,
    input  logic [ 2*rc2_pkg::MessageW-1:0] heads_i,
    input  rc2_pkg::ray_t                   begins_i,
    // the reader, as rc2_ray_read has it
    input  logic                             early_i,
    input  logic                             given_i,   // it has the reader; only if wants_o
    input  logic                             blocks_i,  // what it may pass goes where rays of this quadrant go
    output logic                             wants_o,
    output logic [          rc2_pkg::N-1:0] todo_o,
    output logic                             leaves_o,
    output logic                             beyond_o,
    // the ray that is looked at
    output logic [                      2:0] pass_o,   // goes on
    output logic [                      2:0] turn_o,
    output rc2_pkg::ray_t                   ray_o,
    output logic [     rc2_pkg::CoordW-1:0] z_o,
    output logic                             along_y_o,
    output logic                             work_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned MessageW = rc2_pkg::MessageW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned DecisionW = rc2_pkg::DecisionW;

  // ---- Which ray ---------------------------------------------------------------------------------
  logic [2:0] to_read_q, may;
  logic [1:0] turn;
  logic [MessageW-1:0] bits;
  rc2_pkg::start_t start;
  assign may = waits_i & ~(to_read_q & {3{!early_i}});
  rc2_rotate #(
      .Ways(2)
  ) u_turn (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .request_i(may[1:0]),
      .take_i   (work_o && !may[2]),
      .grant_o  (turn)
  );
  assign turn_o = may[2] ? 3'b100 : {1'b0, turn};
  assign bits = (MessageW'(begins_i) & {MessageW{may[2]}}) |
                (heads_i[0+:MessageW] & {MessageW{turn_o[0]}}) |
                (heads_i[MessageW+:MessageW] & {MessageW{turn_o[1]}});
  assign ray_o = bits[rc2_pkg::RayW-1:0];
  assign start = ray_o.start;

  // ---- Its way through the column ----------------------------------------------------------------
  assign along_y_o = !ray_o.decision[DecisionW-1];
  rc2_ray_run u_run (
      .z_i     (ray_o.z),
      .down_i  (start.dz[DirW-1]),
      .exit_i  (along_y_o ? ray_o.exit_y : ray_o.exit_x),
      .worth_i (occupied_i | (solid_i ^ {N{start.in_glass}})),
      .todo_o  (todo_o),
      .last_o  (z_o),
      .leaves_o(leaves_o)
  );
  logic ends_cube, clear;
  assign ends_cube = along_y_o ? (start.dy[DirW-1] ? (y_i == 0) : (y_i == CoordW'(N - 1)))
                               : (start.dx[DirW-1] ? (x_i == 0) : (x_i == CoordW'(N - 1)));
  assign beyond_o = leaves_o || ends_cube;

  // ---- What becomes of it --------------------------------------------------------------------------
  assign clear = (todo_o == 0) && !beyond_o;
  assign wants_o = (turn_o != 0) && !clear;
  assign pass_o = turn_o & {3{clear && !blocks_i}};
  assign work_o = given_i || (pass_o != 0);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) to_read_q <= '0;
    else if (given_i) to_read_q <= to_read_q & ~turn_o;
    else if (wants_o) to_read_q <= to_read_q | turn_o;
  end

  // Contract: one ray; it is given the reader if it wants it.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert ((turn_o & (turn_o - 1'b1)) == 0);
      assert (!(given_i && !wants_o));
    end
  end
endmodule
