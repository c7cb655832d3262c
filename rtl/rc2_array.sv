// SPDX-License-Identifier: Apache-2.0
//
// n x n cells (thesis 1.3). On the west side vertical pipes feed the rows, pipe k of R the rows y =
// k, k+R, ..; on the east side the collectors bring the readback down to row 0. Between them the
// cells, in thesis mode or with light in lanes.
//
// busy_o follows the cells by two cycles (one register per row, one for all rows). light_busy_o: the
// pace of the light in lanes has not yet come to rest.

module rc2_array (
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
    // facet packets and READ words from the host, one stream for each feeder
    input  logic           [  rc2_pkg::FEEDERS-1:0] word_valid_i,
    input  logic           [rc2_pkg::FEEDERS*rc2_pkg::HostWordW-1:0] word_i,
    output logic           [  rc2_pkg::FEEDERS-1:0] word_ready_o,
    // readback to the host
    output logic                                word_valid_o,
    output logic           [ rc2_pkg::RowWordW-1:0] word_o,
    input  logic                                word_ready_i,
    output logic           [    rc2_pkg::HomeW-1:0] home_o,  // targets come home in this cycle
    output logic           [    rc2_pkg::HomeW-1:0] skipped_o,  // those of them that were skipped
    output logic                                light_busy_o,
    output logic                                busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned R = rc2_pkg::FEEDERS;
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam int unsigned RowWordW = rc2_pkg::RowWordW;
  localparam int unsigned HostWordW = rc2_pkg::HostWordW;

  // ---- The cells ---------------------------------------------------------------------------------
  logic [N-1:0] west_valid, west_ready, east_valid, east_ready, cells_busy;
  logic [N*RowWordW-1:0] west_word, east_word;
  logic [N*HomeW-1:0] home, skipped;
  if (rc2_pkg::THESIS) begin : m
    rc2_grid_thesis u_grid (
        .clk_i       (clk_i),
        .rst_ni      (rst_ni),
        .clear_i     (clear_i),
        .start_i     (start_i),
        .light_i     (light_i),
        .west_valid_i(west_valid),
        .west_word_i (west_word),
        .west_ready_o(west_ready),
        .east_valid_o(east_valid),
        .east_word_o (east_word),
        .east_ready_i(east_ready),
        .home_o      (home),
        .busy_o      (cells_busy)
    );
    assign skipped = '0;
    assign light_busy_o = 1'b0;
  end else begin : l
    rc2_grid u_grid (
        .clk_i       (clk_i),
        .rst_ni      (rst_ni),
        .clear_i     (clear_i),
        .prepare_i   (prepare_i),
        .start_i     (start_i),
        .accurate_i  (accurate_i),
        .light_i     (light_i),
        .ray_clear_i (ray_clear_i),
        .ray_start_i (ray_start_i),
        .limits_i    (limits_i),
        .west_valid_i(west_valid),
        .west_word_i (west_word),
        .west_ready_o(west_ready),
        .east_valid_o(east_valid),
        .east_word_o (east_word),
        .east_ready_i(east_ready),
        .home_o      (home),
        .skipped_o   (skipped),
        .busy_o      (cells_busy),
        .idle_i      (!busy_o),
        .pace_busy_o (light_busy_o)
    );
  end

  // f[y+1]: the feeder, the collector, the target count and the busy flag of row y.
  for (genvar y = 0; y < N + 2; y++) begin : f
    /*verilator tracing_off*/  // as above
    logic unit_waits, unit_valid, row_ready, ready, next_valid, feeding, collecting;
    logic [RowWordW-1:0] unit_word;
    logic [rc2_pkg::LeadW-1:0] unit_lead;
    logic [HostWordW-1:0] next_word;
    logic back_valid, above_ready;
    logic [RowWordW-1:0] back_word;
    logic [HomeW-1:0] home_q, skipped_q;
    logic busy_q;
    /*verilator tracing_on*/

    if (y == 0) begin : host
      assign above_ready = word_ready_i;  // the host takes what row 0 gives
    end else if (y == N + 1) begin : top
      // The end of all rows: a READ word waits above row n-1 for ever.
      assign home_q = '0;
      assign skipped_q = '0;
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
          .unit_lead_o (unit_lead),
          .unit_ready_i(west_ready[y-1]),
          .next_valid_o(next_valid),
          .next_word_o (next_word),
          .next_ready_i(after_ready),
          .busy_o      (feeding)
      );
      rc2_collector u_collector (
          .clk_i        (clk_i),
          .rst_ni       (rst_ni),
          .row_valid_i  (east_valid[y-1]),
          .row_word_i   (east_word[(y-1)*RowWordW+:RowWordW]),
          .row_ready_o  (row_ready),
          .above_valid_i(f[y+1].back_valid),
          .above_word_i (f[y+1].back_word),
          .above_ready_o(above_ready),
          .valid_o      (back_valid),
          .word_o       (back_word),
          .ready_i      (f[y-1].above_ready),
          .busy_o       (collecting)
      );
      assign west_valid[y-1] = unit_valid;
      assign west_word[(y-1)*RowWordW+:RowWordW] = unit_word;
      assign east_ready[y-1] = row_ready;
      always_ff @(posedge clk_i) begin
        if (!rst_ni) begin
          home_q    <= '0;
          skipped_q <= '0;
          busy_q    <= 1'b0;
        end else begin
          home_q    <= f[y+1].home_q + home[(y-1)*HomeW+:HomeW];
          skipped_q <= f[y+1].skipped_q + skipped[(y-1)*HomeW+:HomeW];
          busy_q <= feeding || collecting || cells_busy[y-1];
        end
      end
    end
  end

  assign word_valid_o = f[1].back_valid;
  assign word_o = f[1].back_word;
  assign home_o = f[1].home_q;
  assign skipped_o = f[1].skipped_q;

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
