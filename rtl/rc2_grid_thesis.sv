// SPDX-License-Identifier: Apache-2.0
//
// n x n cells in thesis mode, each linked to its eight neighbours. Around them lies a border of ties,
// so that every cell is connected by the same lines.

module rc2_grid_thesis (
    input  logic                                clk_i,
    input  logic                                rst_ni,
    input  logic                                clear_i,
    input  logic                                start_i,
    input  rc2_pkg::light_t                     light_i,
    // row pipes, row y at bit y: into the west ends, out of the east ends
    input  logic           [rc2_pkg::N-1:0] west_valid_i,
    input  logic           [rc2_pkg::N*rc2_pkg::RowWordW-1:0] west_word_i,
    output logic           [rc2_pkg::N-1:0] west_ready_o,
    output logic           [rc2_pkg::N-1:0] east_valid_o,
    output logic           [rc2_pkg::N*rc2_pkg::RowWordW-1:0] east_word_o,
    input  logic           [rc2_pkg::N-1:0] east_ready_i,
    // of each row
    output logic           [rc2_pkg::N*rc2_pkg::HomeW-1:0] home_o,  // targets come home
    output logic           [rc2_pkg::N-1:0] busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam int unsigned RowWordW = rc2_pkg::RowWordW;

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
        rc2_cell_thesis u_cell (
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

  for (genvar y = 0; y < N; y++) begin : g_row
    logic [N-1:0] cells_busy;
    for (genvar x = 0; x < N; x++) begin : g_busy
      assign cells_busy[x] = g[y+1].c[x+1].busy;
    end
    assign west_ready_o[y] = g[y+1].c[1].wr;
    assign east_valid_o[y] = g[y+1].c[N].wv;
    assign east_word_o[y*RowWordW+:RowWordW] = g[y+1].c[N].w;
    assign home_o[y*HomeW+:HomeW] = g[y+1].c[1].home;
    assign busy_o[y] = (cells_busy != 0);
  end
endmodule
