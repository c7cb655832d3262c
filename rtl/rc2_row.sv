// SPDX-License-Identifier: Apache-2.0
//
// One row of cells with light in lanes and its row pipe (thesis 1.3): words go in at the west end and
// out at the east end, targets come home to the west. What a cell says to those of the next rows is
// one vector (SpokenW) and one of what they have room for (RoomW), however long the row is. Wires
// only: it takes no cycle of its own.
//
// All rows are one module without parameters, so that a large array can be Verilated by rows: one
// row once, and n calls of it (sim/rtl.cmake). Verilator 5.006 then writes no ports that are structs.

module rc2_row (
    input  logic                                clk_i,
    input  logic                                rst_ni,
    input  logic           [rc2_pkg::CoordW-1:0] y_i,
    input  logic                                clear_i,
    input  logic                                prepare_i,
    input  logic                                start_i,
    input  logic                                accurate_i,
    input  logic           [rc2_pkg::LightW-1:0] light_i,
    input  logic                                ray_clear_i,
    input  logic                                ray_start_i,
    input  logic           [rc2_pkg::LimitsW-1:0] limits_i,
    // row pipe: into the west end, out of the east end
    input  logic                                west_valid_i,
    input  logic           [rc2_pkg::RowWordW-1:0] west_word_i,
    output logic                                west_ready_o,
    output logic                                east_valid_o,
    output logic           [rc2_pkg::RowWordW-1:0] east_word_o,
    input  logic                                east_ready_i,
    output logic           [rc2_pkg::HomeW-1:0] home_o,  // targets come home
    output logic           [rc2_pkg::HomeW-1:0] skipped_o,  // those of them that were skipped
    output logic                                busy_o,
    // what all cells hear, those of each column, and those of this row (rc2_pace, rc2_axis)
    input  logic           [rc2_pkg::PaceW-1:0] pace_i,
    input  logic           [rc2_pkg::N*rc2_pkg::CutW-1:0] x_cut_i,
    input  logic           [rc2_pkg::N*rc2_pkg::ClassW-1:0] x_come_i,
    input  logic           [rc2_pkg::N*rc2_pkg::WeightsW-1:0] x_all_i,
    input  logic           [rc2_pkg::N*rc2_pkg::WeightsW-1:0] x_kept_i,
    input  logic           [rc2_pkg::CutW-1:0] y_cut_i,
    input  logic           [rc2_pkg::ClassW-1:0] y_come_i,
    input  logic           [rc2_pkg::WeightsW-1:0] y_all_i,
    input  logic           [rc2_pkg::WeightsW-1:0] y_kept_i,
    // what the cells of the rows beside this one say and have room for, and those of this row to them
    input  logic           [rc2_pkg::N*rc2_pkg::SpokenW-1:0] north_i,
    input  logic           [rc2_pkg::N*rc2_pkg::SpokenW-1:0] south_i,
    input  logic           [rc2_pkg::N*rc2_pkg::RoomW-1:0] north_room_i,
    input  logic           [rc2_pkg::N*rc2_pkg::RoomW-1:0] south_room_i,
    output logic           [rc2_pkg::N*rc2_pkg::SpokenW-1:0] spoken_o,
    output logic           [rc2_pkg::N*rc2_pkg::RoomW-1:0] room_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned ClassW = rc2_pkg::ClassW;
  localparam int unsigned CutW = rc2_pkg::CutW;
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam int unsigned LinkRoomW = rc2_pkg::LinkRoomW;
  localparam int unsigned LinkW = rc2_pkg::LinkW;
  localparam int unsigned MatrixW = rc2_pkg::MatrixW;
  localparam int unsigned ReachW = rc2_pkg::ReachW;
  localparam int unsigned RoomW = rc2_pkg::RoomW;
  localparam int unsigned RowWordW = rc2_pkg::RowWordW;
  localparam int unsigned SpokenW = rc2_pkg::SpokenW;
  localparam int unsigned WeightsW = rc2_pkg::WeightsW;

  // ---- What the rows beside say: b[0] is that to the south, b[1] that to the north; column x is
  // c[x+1], 0 and n+1 are the border ------------------------------------------------------------
  for (genvar k = 0; k < 2; k++) begin : b
    for (genvar x = 0; x < N + 2; x++) begin : c
      /*verilator tracing_off*/  // the cells' ports show the same
      logic [7:0] v, r;  // side lane: valid out, room out
      rc2_pkg::lane_t s, d;  // straight, diagonal
      logic [MatrixW-1:0] zy, zd;
      logic [3:0] quadrants;
      logic [ReachW-1:0] reach;
      logic [LinkW-1:0] ray2, ray3;  // by the way that a message goes: N S
      logic [4*LinkRoomW-1:0] ray_room;
      /*verilator tracing_on*/
      if (x == 0 || x == N + 1) begin : t
        assign {reach, v, s, d, zy, zd, quadrants, ray2, ray3} = rc2_pkg::Silence;
        assign {r, ray_room} = '0;
      end else begin : n
        assign {reach, v, s, d, zy, zd, quadrants, ray2, ray3} =
            (k == 0) ? south_i[(x-1)*SpokenW+:SpokenW] : north_i[(x-1)*SpokenW+:SpokenW];
        assign {r, ray_room} = (k == 0) ? south_room_i[(x-1)*RoomW+:RoomW] : north_room_i[(x-1)*RoomW+:RoomW];
      end
    end
  end

  // ---- The cells: c[x+1] likewise -------------------------------------------------------------
  for (genvar x = 0; x < N + 2; x++) begin : c
    /*verilator tracing_off*/  // the cells' ports show the same
    logic [7:0] v, r;  // side lane: valid out, room out
    rc2_pkg::lane_t s, d;  // straight, diagonal
    logic [MatrixW-1:0] zy, zd;
    logic [3:0] quadrants;
    logic [ReachW-1:0] reach;
    logic [LinkW-1:0] ray2, ray3;  // by the way that a message goes: N S
    logic [4*LinkRoomW-1:0] ray_room;
    logic [MatrixW-1:0] zx;
    logic [LinkW-1:0] ray0, ray1;  // E W
    logic [HomeW-1:0] home, skipped;
    logic wv, wr, busy;  // word to the east, ready to the west
    logic [RowWordW-1:0] w;
    /*verilator tracing_on*/

    if (x == 0 || x == N + 1) begin : t
      assign {reach, v, s, d, zy, zd, quadrants, ray2, ray3} = rc2_pkg::Silence;
      assign {r, ray_room} = '0;
      assign zx = '0;
      assign ray0 = '0;
      assign ray1 = '0;
      assign home = '0;
      assign skipped = '0;
      assign busy = 1'b0;
      assign wv = (x == 0) ? west_valid_i : 1'b0;
      assign w = (x == 0) ? west_word_i : '0;
      assign wr = (x == 0) ? 1'b0 : east_ready_i;
    end else begin : n
      assign spoken_o[(x-1)*SpokenW+:SpokenW] = {reach, v, s, d, zy, zd, quadrants, ray2, ray3};
      assign room_o[(x-1)*RoomW+:RoomW] = {r, ray_room};
      rc2_cell u_cell (
          .clk_i       (clk_i),
          .rst_ni      (rst_ni),
          .x_i         (CoordW'(x - 1)),
          .y_i         (y_i),
          .clear_i     (clear_i),
          .prepare_i   (prepare_i),
          .start_i     (start_i),
          .accurate_i  (accurate_i),
          .light_i     (light_i),
          .ray_clear_i (ray_clear_i),
          .ray_start_i (ray_start_i),
          .limits_i    (limits_i),
          .word_valid_i(c[x-1].wv),
          .word_i      (c[x-1].w),
          .word_ready_o(wr),
          .word_valid_o(wv),
          .word_o      (w),
          .word_ready_i(c[x+1].wr),
          .pace_i      (pace_i),
          .x_cut_i     (x_cut_i[(x-1)*CutW+:CutW]),
          .y_cut_i     (y_cut_i),
          .x_come_i    (x_come_i[(x-1)*ClassW+:ClassW]),
          .y_come_i    (y_come_i),
          .x_all_i     (x_all_i[(x-1)*WeightsW+:WeightsW]),
          .x_kept_i    (x_kept_i[(x-1)*WeightsW+:WeightsW]),
          .y_all_i     (y_all_i),
          .y_kept_i    (y_kept_i),
          // What the neighbour in direction d sends in the opposite direction.
          .side_valid_i({
            b[0].c[x+1].v[3],
            b[0].c[x].v[2],
            b[0].c[x-1].v[1],
            c[x-1].v[0],
            b[1].c[x-1].v[7],
            b[1].c[x].v[6],
            b[1].c[x+1].v[5],
            c[x+1].v[4]
          }),
          .side_room_o (r),
          .side0_i     (c[x+1].s),
          .side1_i     (b[1].c[x+1].d),
          .side2_i     (b[1].c[x].s),
          .side3_i     (b[1].c[x-1].d),
          .side4_i     (c[x-1].s),
          .side5_i     (b[0].c[x-1].d),
          .side6_i     (b[0].c[x].s),
          .side7_i     (b[0].c[x+1].d),
          .side_valid_o(v),
          .side_room_i ({
            b[0].c[x+1].r[3],
            b[0].c[x].r[2],
            b[0].c[x-1].r[1],
            c[x-1].r[0],
            b[1].c[x-1].r[7],
            b[1].c[x].r[6],
            b[1].c[x+1].r[5],
            c[x+1].r[4]
          }),
          .straight_o  (s),
          .diagonal_o  (d),
          .z0_i        (c[x+1].zx),
          .z1_i        (b[1].c[x+1].zd),
          .z2_i        (b[1].c[x].zy),
          .z3_i        (b[1].c[x-1].zd),
          .z4_i        (c[x-1].zx),
          .z5_i        (b[0].c[x-1].zd),
          .z6_i        (b[0].c[x].zy),
          .z7_i        (b[0].c[x+1].zd),
          .z_x_o       (zx),
          .z_y_o       (zy),
          .z_xy_o      (zd),
          .quadrants_e_i({c[x+1].quadrants[3], c[x+1].quadrants[0]}),
          .quadrants_n_i({b[1].c[x].quadrants[1], b[1].c[x].quadrants[0]}),
          .quadrants_w_i({c[x-1].quadrants[2], c[x-1].quadrants[1]}),
          .quadrants_s_i({b[0].c[x].quadrants[3], b[0].c[x].quadrants[2]}),
          .quadrants_o (quadrants),
          .reach0_i    (c[x+1].reach),
          .reach1_i    (b[1].c[x+1].reach),
          .reach2_i    (b[1].c[x].reach),
          .reach3_i    (b[1].c[x-1].reach),
          .reach4_i    (c[x-1].reach),
          .reach5_i    (b[0].c[x-1].reach),
          .reach6_i    (b[0].c[x].reach),
          .reach7_i    (b[0].c[x+1].reach),
          .reach_o     (reach),
          .ray0_i      (c[x-1].ray0),
          .ray1_i      (c[x+1].ray1),
          .ray2_i      (b[0].c[x].ray2),
          .ray3_i      (b[1].c[x].ray3),
          .ray_room_o  (ray_room),
          .ray0_o      (ray0),
          .ray1_o      (ray1),
          .ray2_o      (ray2),
          .ray3_o      (ray3),
          .ray_room_i  ({
            b[0].c[x].ray_room[3*LinkRoomW+:LinkRoomW],
            b[1].c[x].ray_room[2*LinkRoomW+:LinkRoomW],
            c[x-1].ray_room[LinkRoomW+:LinkRoomW],
            c[x+1].ray_room[0+:LinkRoomW]
          }),
          .home_i      (c[x+1].home),
          .home_o      (home),
          .skipped_i   (c[x+1].skipped),
          .skipped_o   (skipped),
          .busy_o      (busy)
      );
    end
  end

  logic [N-1:0] cells_busy;
  for (genvar x = 0; x < N; x++) begin : g_busy
    assign cells_busy[x] = c[x+1].busy;
  end
  assign busy_o = (cells_busy != 0);
  assign west_ready_o = c[1].wr;
  assign east_valid_o = c[N].wv;
  assign east_word_o = c[N].w;
  assign home_o = c[1].home;
  assign skipped_o = c[1].skipped;
endmodule
