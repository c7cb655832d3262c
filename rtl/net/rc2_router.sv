// SPDX-License-Identifier: Apache-2.0
//
// The cell's side of its eight links (thesis 1.3, 4.4.1): an input buffer and an output buffer for
// each direction, a rotating choice of one arrival per cycle for the queue (the light of this
// column is a ninth input), and the children of the beam that is served on their way out.
//
// No message is lost: an input buffer keeps its beam until the queue takes it, an output buffer
// until the neighbour's input buffer is empty.

module rc2_router (
    input  logic                               clk_i,
    input  logic                               rst_ni,
    input  logic           [rc2_pkg::CoordW-1:0] x_i,
    input  logic           [rc2_pkg::CoordW-1:0] y_i,
    input  logic                               start_i,
    input  rc2_pkg::light_t                    light_i,
    // links
    input  logic           [               7:0] link_valid_i,
    output logic           [               7:0] link_ready_o,
    input  rc2_pkg::beam_t                     link0_i,
    input  rc2_pkg::beam_t                     link1_i,
    input  rc2_pkg::beam_t                     link2_i,
    input  rc2_pkg::beam_t                     link3_i,
    input  rc2_pkg::beam_t                     link4_i,
    input  rc2_pkg::beam_t                     link5_i,
    input  rc2_pkg::beam_t                     link6_i,
    input  rc2_pkg::beam_t                     link7_i,
    output logic           [               7:0] link_valid_o,
    input  logic           [               7:0] link_ready_i,
    output rc2_pkg::beam_t                     link0_o,
    output rc2_pkg::beam_t                     link1_o,
    output rc2_pkg::beam_t                     link2_o,
    output rc2_pkg::beam_t                     link3_o,
    output rc2_pkg::beam_t                     link4_o,
    output rc2_pkg::beam_t                     link5_o,
    output rc2_pkg::beam_t                     link6_o,
    output rc2_pkg::beam_t                     link7_o,
    // to the queue
    output logic                               arrival_valid_o,
    output rc2_pkg::beam_t                     arrival_o,
    input  logic                               arrival_take_i,
    // from the splitter
    output logic           [               7:0] writable_o,
    input  rc2_pkg::split_t                    split_i,
    input  logic           [               7:0] send_i,
    output logic                               busy_o
);
  localparam int unsigned BeamW = rc2_pkg::BeamW;

  // ---- Input buffers and the light ---------------------------------------------------------------
  logic [BeamW-1:0] incoming[0:7];
  assign incoming[0] = link0_i;
  assign incoming[1] = link1_i;
  assign incoming[2] = link2_i;
  assign incoming[3] = link3_i;
  assign incoming[4] = link4_i;
  assign incoming[5] = link5_i;
  assign incoming[6] = link6_i;
  assign incoming[7] = link7_i;

  logic [8:0] waiting, grant;
  logic [BeamW-1:0] candidate[0:8];
  for (genvar d = 0; d < 8; d++) begin : g_in
    logic [BeamW-1:0] beam;
    rc2_slot #(
        .Width(BeamW)
    ) u_slot (
        .clk_i  (clk_i),
        .rst_ni (rst_ni),
        .valid_i(link_valid_i[d]),
        .data_i (incoming[d]),
        .ready_o(link_ready_o[d]),
        .valid_o(waiting[d]),
        .data_o (beam),
        .take_i (arrival_take_i && grant[d])
    );
    assign candidate[d] = beam;
  end

  rc2_pkg::beam_t source_beam;
  rc2_source u_source (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(start_i),
      .x_i    (x_i),
      .y_i    (y_i),
      .light_i(light_i),
      .valid_o(waiting[8]),
      .beam_o (source_beam),
      .take_i (arrival_take_i && grant[8])
  );
  assign candidate[8] = source_beam;

  // ---- One arrival per cycle ---------------------------------------------------------------------
  // Every light begins with the same place in turn, so the same light takes the same cycles.
  rc2_rotate #(
      .Ways(9)
  ) u_rotate (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni && !start_i),
      .request_i(waiting),
      .take_i   (arrival_take_i),
      .grant_o  (grant)
  );
  assign arrival_valid_o = (waiting != 0);
  logic [BeamW-1:0] arrival;
  always_comb begin
    arrival = '0;
    for (int i = 0; i < 9; i++) if (grant[i]) arrival = arrival | candidate[i];
  end
  assign arrival_o = arrival;

  // ---- Output buffers ------------------------------------------------------------------------------
  for (genvar d = 0; d < 8; d++) begin : g_out
    rc2_pkg::beam_t beam;
    rc2_link #(
        .Dir(d)
    ) u_link (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .send_i    (send_i[d]),
        .split_i   (split_i),
        .writable_o(writable_o[d]),
        .valid_o   (link_valid_o[d]),
        .beam_o    (beam),
        .ready_i   (link_ready_i[d])
    );
  end
  assign link0_o = g_out[0].beam;
  assign link1_o = g_out[1].beam;
  assign link2_o = g_out[2].beam;
  assign link3_o = g_out[3].beam;
  assign link4_o = g_out[4].beam;
  assign link5_o = g_out[5].beam;
  assign link6_o = g_out[6].beam;
  assign link7_o = g_out[7].beam;

  assign busy_o = (waiting != 0) || (link_valid_o != 0);

  // Contract: only a beam that is there is taken.
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (!arrival_take_i || arrival_valid_o);
  end
endmodule
