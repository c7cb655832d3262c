// SPDX-License-Identifier: Apache-2.0
//
// n x n cells (thesis 1.3). On the west side vertical pipes feed the rows, pipe k of R the rows y =
// k, k+R, ..; on the east side the collectors bring the readback down to row 0; each cell has its eight neighbours. Around the cells
// lies a border of ties, so that every cell is connected by the same lines.
//
// busy_o follows the cells by two cycles (one register per row, one for all rows).

module rc2_array (
    input  logic                                clk_i,
    input  logic                                rst_ni,
    input  logic                                clear_i,
    input  logic                                start_i,
    input  rc2_pkg::light_t                     light_i,
    // facet packets and READ words from the host, one stream for each feeder
    input  logic           [  rc2_pkg::FEEDERS-1:0] word_valid_i,
    input  logic           [rc2_pkg::FEEDERS*rc2_pkg::HostWordW-1:0] word_i,
    output logic           [  rc2_pkg::FEEDERS-1:0] word_ready_o,
    // readback to the host
    output logic                                word_valid_o,
    output logic           [ rc2_pkg::RowWordW-1:0] word_o,
    input  logic                                word_ready_i,
    output logic           [    rc2_pkg::HomeW-1:0] home_o,  // targets come home in this cycle
    output logic                                busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned R = rc2_pkg::FEEDERS;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam int unsigned RowWordW = rc2_pkg::RowWordW;
  localparam int unsigned HostWordW = rc2_pkg::HostWordW;

  // g[y+1].c[x+1] is cell (x,y); rows and columns 0 and n+1 are the border.
  for (genvar y = 0; y < N + 2; y++) begin : g
    for (genvar x = 0; x < N + 2; x++) begin : c
      /*verilator tracing_off*/  // the cells' ports show the same
      logic [7:0] v, r;  // link valid out, link ready out
      rc2_pkg::beam_t b0, b1, b2, b3, b4, b5, b6, b7;
      logic [HomeW-1:0] home;
      logic wv, wr, busy;  // word to the east, ready to the west
      logic [RowWordW-1:0] w;
      /*verilator tracing_on*/

      if (x == 0 || x == N + 1 || y == 0 || y == N + 1) begin : t
        assign v = 8'd0;
        assign r = 8'd0;
        assign b0 = '0;
        assign b1 = '0;
        assign b2 = '0;
        assign b3 = '0;
        assign b4 = '0;
        assign b5 = '0;
        assign b6 = '0;
        assign b7 = '0;
        assign home = '0;
        assign busy = 1'b0;
        if (x == 0 && y >= 1 && y <= N) begin : feed  // row y-1 starts here
          assign wv = f[y].unit_valid;
          assign w = f[y].unit_word;
        end else begin : still
          assign wv = 1'b0;
          assign w = '0;
        end
        if (x == N + 1 && y >= 1 && y <= N) begin : collect
          assign wr = f[y].row_ready;
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
            .start_i     (start_i),
            .light_i     (light_i),
            .word_valid_i(g[y].c[x-1].wv),
            .word_i      (g[y].c[x-1].w),
            .word_ready_o(wr),
            .word_valid_o(wv),
            .word_o      (w),
            .word_ready_i(g[y].c[x+1].wr),
            // What the neighbour in direction d sends in the opposite direction.
            .link_valid_i({
              g[y-1].c[x+1].v[3],
              g[y-1].c[x].v[2],
              g[y-1].c[x-1].v[1],
              g[y].c[x-1].v[0],
              g[y+1].c[x-1].v[7],
              g[y+1].c[x].v[6],
              g[y+1].c[x+1].v[5],
              g[y].c[x+1].v[4]
            }),
            .link_ready_o(r),
            .link0_i     (g[y].c[x+1].b4),
            .link1_i     (g[y+1].c[x+1].b5),
            .link2_i     (g[y+1].c[x].b6),
            .link3_i     (g[y+1].c[x-1].b7),
            .link4_i     (g[y].c[x-1].b0),
            .link5_i     (g[y-1].c[x-1].b1),
            .link6_i     (g[y-1].c[x].b2),
            .link7_i     (g[y-1].c[x+1].b3),
            .link_valid_o(v),
            .link_ready_i({
              g[y-1].c[x+1].r[3],
              g[y-1].c[x].r[2],
              g[y-1].c[x-1].r[1],
              g[y].c[x-1].r[0],
              g[y+1].c[x-1].r[7],
              g[y+1].c[x].r[6],
              g[y+1].c[x+1].r[5],
              g[y].c[x+1].r[4]
            }),
            .link0_o     (b0),
            .link1_o     (b1),
            .link2_o     (b2),
            .link3_o     (b3),
            .link4_o     (b4),
            .link5_o     (b5),
            .link6_o     (b6),
            .link7_o     (b7),
            .home_i      (g[y].c[x+1].home),
            .home_o      (home),
            .busy_o      (busy)
        );
      end
    end
  end

  // f[y+1]: the feeder, the collector, the target count and the busy flag of row y.
  for (genvar y = 0; y < N + 2; y++) begin : f
    /*verilator tracing_off*/  // as above
    logic unit_waits, unit_valid, row_ready, ready, next_valid, feeding, collecting;
    logic [RowWordW-1:0] unit_word;
    logic [HostWordW-1:0] next_word;
    logic back_valid, above_ready;
    logic [RowWordW-1:0] back_word;
    logic [HomeW-1:0] home_q;
    logic [N-1:0] cells_busy;
    logic busy_q;
    /*verilator tracing_on*/

    if (y == 0) begin : host
      assign above_ready = word_ready_i;  // the host takes what row 0 gives
    end else if (y == N + 1) begin : top
      // The end of all rows: a READ word waits above row n-1 for ever.
      assign home_q = '0;
      assign back_valid = 1'b1;
      assign back_word = {rc2_pkg::KindRead, {rc2_pkg::RowPayloadW{1'b0}}};
    end else begin : row
      logic before_valid, after_ready;
      logic [HostWordW-1:0] before_word;
      if (y <= R) begin : first
        assign before_valid = word_valid_i[y-1];
        assign before_word = word_i[(y-1)*HostWordW+:HostWordW];
        assign word_ready_o[y-1] = ready;
      end else begin : later
        assign before_valid = f[y-R].next_valid;
        assign before_word = f[y-R].next_word;
      end
      // Nothing goes beyond the last row of a pipe but READ and END words, which end there.
      if (y + R <= N) begin : inner
        assign after_ready = f[y+R].ready;
      end else begin : last
        assign after_ready = 1'b1;
      end
      rc2_facet_stage #(
          .PayloadW(rc2_pkg::HostPayloadW),
          .Stride  (R)
      ) u_feeder (
          .clk_i       (clk_i),
          .rst_ni      (rst_ni),
          .valid_i     (before_valid),
          .word_i      (before_word),
          .ready_o     (ready),
          .unit_waits_o(unit_waits),
          .unit_valid_o(unit_valid),
          .unit_word_o (unit_word),
          .unit_ready_i(g[y].c[1].wr),
          .next_valid_o(next_valid),
          .next_word_o (next_word),
          .next_ready_i(after_ready),
          .busy_o      (feeding)
      );
      rc2_collector u_collector (
          .clk_i        (clk_i),
          .rst_ni       (rst_ni),
          .row_valid_i  (g[y].c[N].wv),
          .row_word_i   (g[y].c[N].w),
          .row_ready_o  (row_ready),
          .above_valid_i(f[y+1].back_valid),
          .above_word_i (f[y+1].back_word),
          .above_ready_o(above_ready),
          .valid_o      (back_valid),
          .word_o       (back_word),
          .ready_i      (f[y-1].above_ready),
          .busy_o       (collecting)
      );
      for (genvar x = 0; x < N; x++) begin : b
        assign cells_busy[x] = g[y].c[x+1].busy;
      end
      always_ff @(posedge clk_i) begin
        if (!rst_ni) begin
          home_q <= '0;
          busy_q <= 1'b0;
        end else begin
          home_q <= f[y+1].home_q + g[y].c[1].home;
          busy_q <= feeding || collecting || (cells_busy != 0);
        end
      end
    end
  end

  assign word_valid_o = f[1].back_valid;
  assign word_o = f[1].back_word;
  assign home_o = f[1].home_q;

  logic [N-1:0] rows_busy;
  logic busy_q;
  for (genvar y = 0; y < N; y++) begin : b
    assign rows_busy[y] = f[y+1].busy_q;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) busy_q <= 1'b0;
    else busy_q <= (rows_busy != 0);
  end
  assign busy_o = busy_q;
endmodule
