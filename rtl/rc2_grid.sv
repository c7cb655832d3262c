// SPDX-License-Identifier: Apache-2.0
//
// n rows of n cells with light in lanes, each row linked to the next ones, and what the cells share:
// the pace of the light, and for each column and row the classes of its targets (rc2_axis). Around
// them lies a border of ties, so that every cell is connected by the same lines.

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
  localparam int unsigned CutW = rc2_pkg::CutW;
  localparam int unsigned RoomW = rc2_pkg::RoomW;
  localparam int unsigned SpokenW = rc2_pkg::SpokenW;
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned WeightsW = rc2_pkg::WeightsW;

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

  logic [N*CutW-1:0] x_cut;
  logic [N*ClassW-1:0] x_come;
  logic [N*WeightsW-1:0] x_all, x_kept;
  for (genvar x = 0; x < N; x++) begin : g_columns
    assign x_cut[x*CutW+:CutW] = a[0].p[x+1].cut;
    assign x_come[x*ClassW+:ClassW] = a[0].p[x+1].come;
    assign x_all[x*WeightsW+:WeightsW] = a[0].p[x+1].all;
    assign x_kept[x*WeightsW+:WeightsW] = a[0].p[x+1].kept;
  end

  // ---- Rows: g[y+1] is row y; 0 and n+1 are the border ---------------------------------------
  for (genvar y = 0; y < N + 2; y++) begin : g
    /*verilator tracing_off*/  // the cells' ports show the same
    logic [N*SpokenW-1:0] spoken;
    logic [N*RoomW-1:0] room;
    /*verilator tracing_on*/
    if (y == 0 || y == N + 1) begin : t
      assign spoken = {N{rc2_pkg::Silence}};
      assign room = '0;
    end else begin : n
      rc2_row u_row (
          .clk_i       (clk_i),
          .rst_ni      (rst_ni),
          .y_i         (CoordW'(y - 1)),
          .clear_i     (clear_i),
          .prepare_i   (prepare_i),
          .start_i     (start_i),
          .accurate_i  (accurate_i),
          .light_i     (light_i),
          .ray_clear_i (ray_clear_i),
          .ray_start_i (ray_start_i),
          .limits_i    (limits_i),
          .west_valid_i(west_valid_i[y-1]),
          .west_word_i (west_word_i[(y-1)*RowWordW+:RowWordW]),
          .west_ready_o(west_ready_o[y-1]),
          .east_valid_o(east_valid_o[y-1]),
          .east_word_o (east_word_o[(y-1)*RowWordW+:RowWordW]),
          .east_ready_i(east_ready_i[y-1]),
          .home_o      (home_o[(y-1)*HomeW+:HomeW]),
          .skipped_o   (skipped_o[(y-1)*HomeW+:HomeW]),
          .busy_o      (busy_o[y-1]),
          .pace_i      (pace),
          .x_cut_i     (x_cut),
          .x_come_i    (x_come),
          .x_all_i     (x_all),
          .x_kept_i    (x_kept),
          .y_cut_i     (a[1].p[y].cut),
          .y_come_i    (a[1].p[y].come),
          .y_all_i     (a[1].p[y].all),
          .y_kept_i    (a[1].p[y].kept),
          .north_i     (g[y+1].spoken),
          .south_i     (g[y-1].spoken),
          .north_room_i(g[y+1].room),
          .south_room_i(g[y-1].room),
          .spoken_o    (spoken),
          .room_o      (room)
      );
    end
  end
endmodule
