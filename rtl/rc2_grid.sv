// SPDX-License-Identifier: Apache-2.0
//
// n x n cells with light in lanes, each linked to its eight neighbours, and what they share: the
// pace of the light, and for each column and row the classes of its targets (rc2_axis). Around the
// cells lies a border of ties, so that every cell is connected by the same lines.

module rc2_grid (
    input  logic                                clk_i,
    input  logic                                rst_ni,
    input  logic                                clear_i,
    input  logic                                prepare_i,
    input  logic                                start_i,
    input  logic                                accurate_i,
    input  rc2_pkg::light_t                     light_i,
    input  logic                                ray_clear_i,
    input  logic                                ray_start_i,
    input  rc2_pkg::limits_t                    limits_i,
    // row pipes, row y at bit y: into the west ends, out of the east ends
    input  logic           [rc2_pkg::N-1:0] west_valid_i,
    input  logic           [rc2_pkg::N*rc2_pkg::RowWordW-1:0] west_word_i,
    output logic           [rc2_pkg::N-1:0] west_ready_o,
    output logic           [rc2_pkg::N-1:0] east_valid_o,
    output logic           [rc2_pkg::N*rc2_pkg::RowWordW-1:0] east_word_o,
    input  logic           [rc2_pkg::N-1:0] east_ready_i,
    // of each row
    output logic           [rc2_pkg::N*rc2_pkg::HomeW-1:0] home_o,  // targets come home
    output logic           [rc2_pkg::N*rc2_pkg::HomeW-1:0] skipped_o,  // those of them that were skipped
    output logic           [rc2_pkg::N-1:0] busy_o,
    input  logic                                idle_i,  // no cell was busy two cycles ago
    output logic                                pace_busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam int unsigned RowWordW = rc2_pkg::RowWordW;
  localparam int unsigned M = rc2_pkg::ClassM;
  localparam int unsigned ClassW = rc2_pkg::ClassW;
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned MatrixW = rc2_pkg::MatrixW;
  localparam int unsigned ReachW = rc2_pkg::ReachW;
  localparam int unsigned WeightsW = rc2_pkg::WeightsW;
  localparam int unsigned LinkW = rc2_pkg::LinkW;
  localparam int unsigned LinkRoomW = rc2_pkg::LinkRoomW;

  // ---- What the cells share ------------------------------------------------------------------
  rc2_pkg::pace_t pace;
  logic tick;
  logic [rc2_pkg::RatioW-1:0] ratio;
  rc2_pace u_pace (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(start_i),
      .light_i(light_i),
      .pace_o (pace),
      .tick_o (tick),
      .ratio_o(ratio),
      .idle_i (idle_i),
      .busy_o (pace_busy_o)
  );

  // a[0] along x, a[1] along y; p[i+1] is the unit of coordinate i.
  for (genvar k = 0; k < 2; k++) begin : a
    logic [CoordW-1:0] light;
    assign light = (k == 0) ? light_i.xs : light_i.ys;
    for (genvar i = 0; i < N + 2; i++) begin : p
      rc2_pkg::cut_t cut;
      logic [ClassW-1:0] come, down_count, up_count;
      logic [DistanceW-1:0] down_inner, up_inner, down_first;
      logic [M*DistanceW-1:0] leaving;
      logic [WeightsW-1:0] all, kept;
      if (i == 0 || i == N + 1) begin : t
        assign cut = '0;
        assign come = '0;
        assign down_count = '0;
        assign up_count = '0;
        assign down_inner = '0;
        assign up_inner = '0;
        assign down_first = '0;
        assign leaving = '0;
        assign all = '0;
        assign kept = '0;
      end else begin : n
        rc2_axis u_axis (
            .clk_i        (clk_i),
            .start_i      (start_i),
            .tick_i       (tick),
            .at_i         (CoordW'(i - 1)),
            .light_i      (light),
            .distance_i   (light_i.distance),
            .ratio_i      (ratio),
            .cut_o        (cut),
            .come_o       (come),
            .down_count_o (down_count),
            .up_count_o   (up_count),
            .down_inner_o (down_inner),
            .up_inner_o   (up_inner),
            .down_first_o (down_first),
            .leaving_o    (leaving),
            .below_count_i(p[i-1].up_count),
            .below_inner_i(p[i-1].up_inner),
            .below_i      (p[i-1].leaving),
            .above_count_i(p[i+1].down_count),
            .above_inner_i(p[i+1].down_inner),
            .above_first_i(p[i+1].down_first),
            .above_i      (p[i+1].leaving),
            .weights_o    (all),
            .kept_o       (kept)
        );
      end
    end
  end

  // ---- Cells: g[y+1].c[x+1] is cell (x,y); rows and columns 0 and n+1 are the border ---------
  for (genvar y = 0; y < N + 2; y++) begin : g
    for (genvar x = 0; x < N + 2; x++) begin : c
      /*verilator tracing_off*/  // the cells' ports show the same
      logic [7:0] v, r;  // side lane: valid out, room out
      rc2_pkg::lane_t s, d;  // straight, diagonal
      logic [MatrixW-1:0] zx, zy, zd;
      logic [HomeW-1:0] home, skipped;
      logic [3:0] quadrants;
      logic [ReachW-1:0] reach;
      logic [LinkW-1:0] ray0, ray1, ray2, ray3;  // by the way that a message goes: E W N S
      logic [4*LinkRoomW-1:0] ray_room;
      logic wv, wr, busy;  // word to the east, ready to the west
      logic [RowWordW-1:0] w;
      /*verilator tracing_on*/

      if (x == 0 || x == N + 1 || y == 0 || y == N + 1) begin : t
        assign v = 8'd0;
        assign r = 8'd0;
        assign s = '0;
        assign d = '0;
        assign zx = '0;
        assign zy = '0;
        assign zd = '0;
        assign home = '0;
        assign skipped = '0;
        assign quadrants = '0;
        assign reach = rc2_pkg::NoReach;
        assign busy = 1'b0;
        assign ray0 = '0;
        assign ray1 = '0;
        assign ray2 = '0;
        assign ray3 = '0;
        assign ray_room = '0;
        if (x == 0 && y >= 1 && y <= N) begin : feed  // row y-1 starts here
          assign wv = west_valid_i[y-1];
          assign w = west_word_i[(y-1)*RowWordW+:RowWordW];
        end else begin : still
          assign wv = 1'b0;
          assign w = '0;
        end
        if (x == N + 1 && y >= 1 && y <= N) begin : collect
          assign wr = east_ready_i[y-1];
        end else begin : closed
          assign wr = 1'b0;
        end
      end else begin : n
        rc2_cell u_cell (
            .clk_i       (clk_i),
            .rst_ni      (rst_ni),
            .x_i         (CoordW'(x - 1)),
            .y_i         (CoordW'(y - 1)),
            .clear_i     (clear_i),
            .prepare_i   (prepare_i),
            .start_i     (start_i),
            .accurate_i  (accurate_i),
            .light_i     (light_i),
            .ray_clear_i (ray_clear_i),
            .ray_start_i (ray_start_i),
            .limits_i    (limits_i),
            .word_valid_i(g[y].c[x-1].wv),
            .word_i      (g[y].c[x-1].w),
            .word_ready_o(wr),
            .word_valid_o(wv),
            .word_o      (w),
            .word_ready_i(g[y].c[x+1].wr),
            .pace_i      (pace),
            .x_cut_i     (a[0].p[x].cut),
            .y_cut_i     (a[1].p[y].cut),
            .x_come_i    (a[0].p[x].come),
            .y_come_i    (a[1].p[y].come),
            .x_all_i     (a[0].p[x].all),
            .x_kept_i    (a[0].p[x].kept),
            .y_all_i     (a[1].p[y].all),
            .y_kept_i    (a[1].p[y].kept),
            // What the neighbour in direction d sends in the opposite direction.
            .side_valid_i({
              g[y-1].c[x+1].v[3],
              g[y-1].c[x].v[2],
              g[y-1].c[x-1].v[1],
              g[y].c[x-1].v[0],
              g[y+1].c[x-1].v[7],
              g[y+1].c[x].v[6],
              g[y+1].c[x+1].v[5],
              g[y].c[x+1].v[4]
            }),
            .side_room_o (r),
            .side0_i     (g[y].c[x+1].s),
            .side1_i     (g[y+1].c[x+1].d),
            .side2_i     (g[y+1].c[x].s),
            .side3_i     (g[y+1].c[x-1].d),
            .side4_i     (g[y].c[x-1].s),
            .side5_i     (g[y-1].c[x-1].d),
            .side6_i     (g[y-1].c[x].s),
            .side7_i     (g[y-1].c[x+1].d),
            .side_valid_o(v),
            .side_room_i ({
              g[y-1].c[x+1].r[3],
              g[y-1].c[x].r[2],
              g[y-1].c[x-1].r[1],
              g[y].c[x-1].r[0],
              g[y+1].c[x-1].r[7],
              g[y+1].c[x].r[6],
              g[y+1].c[x+1].r[5],
              g[y].c[x+1].r[4]
            }),
            .straight_o  (s),
            .diagonal_o  (d),
            .z0_i        (g[y].c[x+1].zx),
            .z1_i        (g[y+1].c[x+1].zd),
            .z2_i        (g[y+1].c[x].zy),
            .z3_i        (g[y+1].c[x-1].zd),
            .z4_i        (g[y].c[x-1].zx),
            .z5_i        (g[y-1].c[x-1].zd),
            .z6_i        (g[y-1].c[x].zy),
            .z7_i        (g[y-1].c[x+1].zd),
            .z_x_o       (zx),
            .z_y_o       (zy),
            .z_xy_o      (zd),
            .quadrants_e_i({g[y].c[x+1].quadrants[3], g[y].c[x+1].quadrants[0]}),
            .quadrants_n_i({g[y+1].c[x].quadrants[1], g[y+1].c[x].quadrants[0]}),
            .quadrants_w_i({g[y].c[x-1].quadrants[2], g[y].c[x-1].quadrants[1]}),
            .quadrants_s_i({g[y-1].c[x].quadrants[3], g[y-1].c[x].quadrants[2]}),
            .quadrants_o (quadrants),
            .reach0_i    (g[y].c[x+1].reach),
            .reach1_i    (g[y+1].c[x+1].reach),
            .reach2_i    (g[y+1].c[x].reach),
            .reach3_i    (g[y+1].c[x-1].reach),
            .reach4_i    (g[y].c[x-1].reach),
            .reach5_i    (g[y-1].c[x-1].reach),
            .reach6_i    (g[y-1].c[x].reach),
            .reach7_i    (g[y-1].c[x+1].reach),
            .reach_o     (reach),
            .ray0_i      (g[y].c[x-1].ray0),
            .ray1_i      (g[y].c[x+1].ray1),
            .ray2_i      (g[y-1].c[x].ray2),
            .ray3_i      (g[y+1].c[x].ray3),
            .ray_room_o  (ray_room),
            .ray0_o      (ray0),
            .ray1_o      (ray1),
            .ray2_o      (ray2),
            .ray3_o      (ray3),
            .ray_room_i  ({
              g[y-1].c[x].ray_room[3*LinkRoomW+:LinkRoomW],
              g[y+1].c[x].ray_room[2*LinkRoomW+:LinkRoomW],
              g[y].c[x-1].ray_room[LinkRoomW+:LinkRoomW],
              g[y].c[x+1].ray_room[0+:LinkRoomW]
            }),
            .home_i      (g[y].c[x+1].home),
            .home_o      (home),
            .skipped_i   (g[y].c[x+1].skipped),
            .skipped_o   (skipped),
            .busy_o      (busy)
        );
      end
    end
  end

  for (genvar y = 0; y < N; y++) begin : g_row
    logic [N-1:0] cells_busy;
    for (genvar x = 0; x < N; x++) begin : g_busy
      assign cells_busy[x] = g[y+1].c[x+1].busy;
    end
    assign west_ready_o[y] = g[y+1].c[1].wr;
    assign east_valid_o[y] = g[y+1].c[N].wv;
    assign east_word_o[y*RowWordW+:RowWordW] = g[y+1].c[N].w;
    assign home_o[y*HomeW+:HomeW] = g[y+1].c[1].home;
    assign skipped_o[y*HomeW+:HomeW] = g[y+1].c[1].skipped;
    assign busy_o[y] = (cells_busy != 0);
  end
endmodule
