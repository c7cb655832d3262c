// SPDX-License-Identifier: Apache-2.0
//
// A 2 x 2 array with light in lanes, from any free voxel, with any L and any voxels occupied: the light ends,
// nothing moves afterwards, and then the voxel in which the ray of any one target ends is lit. Cycles from
// reset up to one by which every light has ended are therefore complete. Without rc2_counts, whose division
// is too much for a solver.

module lanes_light_ends #(
    parameter int unsigned Cycles = 1
) (
    input logic clk_i
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned SlopeW = rc2_pkg::SlopeW;
  localparam logic [7:0] Start = 8'd6;  // rc2_pace wants the light steady for four cycles before

  logic rst_ni = 1'b0;
  logic [7:0] cycle_q = 8'd0;
  always_ff @(posedge clk_i) begin
    rst_ni  <= 1'b1;
    cycle_q <= cycle_q + 1'b1;
  end

  (* anyconst *) rc2_pkg::light_t light;
  logic [N-1:0] busy, rows_busy_q;
  logic any_busy_q, pace_busy;
  rc2_grid u_grid (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .clear_i     (1'b0),
      .prepare_i   (1'b0),
      .start_i     (cycle_q == Start),
      .accurate_i  (1'b0),
      .light_i     (light),
      .ray_clear_i (1'b0),
      .ray_start_i (1'b0),
      .limits_i    ('0),
      .west_valid_i('0),
      .west_word_i ('0),
      .east_ready_i('1),
      .busy_o      (busy),
      .idle_i      (!any_busy_q),
      .pace_busy_o (pace_busy)
  );
  // As rc2_array tells the pace.
  always_ff @(posedge clk_i) begin
    rows_busy_q <= rst_ni ? busy : '0;
    any_busy_q  <= rst_ni && rows_busy_q != 0;
  end
  logic [SlopeW:0] one;
  assign one = (SlopeW + 1)'(1) << SlopeW;
  always_comb begin
    assume (light.fa != 0 && light.fa <= rc2_pkg::QueueW'(rc2_pkg::FAMAX));
    assume (light.distance != 0 && light.distance <= rc2_pkg::DistanceW'(rc2_pkg::LMAX));
    assume (light.xs < N && light.ys < N && light.zs < N);
    // As the host gives it (docs/host-port.md).
    if (light.distance == 1) assume (light.inverse == '1);
    else assume ((SlopeW + 1)'(light.inverse) == one / (SlopeW + 1)'(light.distance));
  end

  // ---- The end ---------------------------------------------------------------------------------
  // Marks are made two cycles after the last beam was served.
  logic started_q, ended_q;
  logic [1:0] quiet_q;
  always_ff @(posedge clk_i) begin
    started_q <= rst_ni && (started_q || cycle_q == Start);
    if (!rst_ni || !started_q || pace_busy || busy != 0) quiet_q <= 2'd0;
    else if (quiet_q != 2'd3) quiet_q <= quiet_q + 1'b1;
    ended_q <= rst_ni && (ended_q || quiet_q == 2'd3);
  end
  always_comb begin
    if (ended_q) assert (!pace_busy && busy == 0);
    if (cycle_q == 8'(Cycles)) assert (ended_q);
  end

  // ---- Any one target ----------------------------------------------------------------------------
  // Voxels as {y, x, z}.
  (* hierconn *) wire [1:0]
      \u_grid.g[1].n.u_row.c[1].n.u_cell.u_voxels.occupied , \u_grid.g[1].n.u_row.c[2].n.u_cell.u_voxels.occupied ,
      \u_grid.g[2].n.u_row.c[1].n.u_cell.u_voxels.occupied , \u_grid.g[2].n.u_row.c[2].n.u_cell.u_voxels.occupied ,
      \u_grid.g[1].n.u_row.c[1].n.u_cell.u_lit.lit_q , \u_grid.g[1].n.u_row.c[2].n.u_cell.u_lit.lit_q ,
      \u_grid.g[2].n.u_row.c[1].n.u_cell.u_lit.lit_q , \u_grid.g[2].n.u_row.c[2].n.u_cell.u_lit.lit_q ;
  logic [7:0] occupied, lit;
  assign occupied = {
      \u_grid.g[2].n.u_row.c[2].n.u_cell.u_voxels.occupied , \u_grid.g[2].n.u_row.c[1].n.u_cell.u_voxels.occupied ,
      \u_grid.g[1].n.u_row.c[2].n.u_cell.u_voxels.occupied , \u_grid.g[1].n.u_row.c[1].n.u_cell.u_voxels.occupied };
  assign lit = {
      \u_grid.g[2].n.u_row.c[2].n.u_cell.u_lit.lit_q , \u_grid.g[2].n.u_row.c[1].n.u_cell.u_lit.lit_q ,
      \u_grid.g[1].n.u_row.c[2].n.u_cell.u_lit.lit_q , \u_grid.g[1].n.u_row.c[1].n.u_cell.u_lit.lit_q };
  always_comb assume (!occupied[{light.ys, light.xs, light.zs}]);

  localparam int unsigned WideW = rc2_pkg::TargetW + 1;
  (* anyconst *) logic signed [WideW-1:0] x;
  (* anyconst *) logic signed [WideW-1:0] y;
  (* anyconst *) logic signed [WideW-1:0] z;
  logic signed [WideW-1:0] far;
  assign far = $signed({2'b00, light.distance});
  // After one step a ray has moved along an axis where its target is more than L/2 away, ties down.
  logic [2:0] up, down, at, voxel;
  assign up = {(y <<< 1) > far, (x <<< 1) > far, (z <<< 1) > far};
  assign down = {(y <<< 1) <= -far, (x <<< 1) <= -far, (z <<< 1) <= -far};
  assign at = {light.ys, light.xs, light.zs};
  assign voxel = (at | up) & ~down;
  logic in_cube;
  assign in_cube = (at & up) == 0 && (~at & down) == 0;
  always_comb begin
    assume (-far <= x && x <= far && -far <= y && y <= far && -far <= z && z <= far);
    assume (x == far || x == -far || y == far || y == -far || z == far || z == -far);
    if (ended_q && in_cube && occupied[voxel]) assert (lit[voxel]);
    if (ended_q) assert ((lit & ~occupied) == 0);
  end
endmodule
