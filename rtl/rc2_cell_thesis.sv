// SPDX-License-Identifier: Apache-2.0
//
// One cell (thesis 1.3): a column of voxels, a stage of its row's facet pipe with the dexel unit,
// and the beam engine with eight neighbours. A hop of a beam takes three cycles without waiting:
// output buffer, input buffer, queue (P = 3).
//
// Every port that leaves the cell comes from a register or depends on the cell's own state and
// inputs only; no ready depends on a neighbour's ready. Coordinates are ports, so that the whole
// array is one module, and the cell calls no function: with rtl/rc2.vlt that lets Verilator share
// one body among all cells. A waveform shows what the tracing marks let through: of 256 cells one
// wants the story, not every wire.

module rc2_cell_thesis (
    /*verilator tracing_off*/
    input  logic                               clk_i,
    input  logic                               rst_ni,
    input  logic           [rc2_pkg::CoordW-1:0] x_i,
    input  logic           [rc2_pkg::CoordW-1:0] y_i,
    input  logic                               clear_i,
    input  logic                               start_i,
    input  rc2_pkg::light_t                    light_i,
    // row pipe: from the west, to the east
    /*verilator tracing_on*/
    input  logic                               word_valid_i,
    input  logic           [rc2_pkg::RowWordW-1:0] word_i,
    /*verilator tracing_off*/
    output logic                               word_ready_o,
    output logic                               word_valid_o,
    output logic           [rc2_pkg::RowWordW-1:0] word_o,
    input  logic                               word_ready_i,
    // links, bit d for direction d: E NE N NW W SW S SE. An input of direction d comes from there.
    /*verilator tracing_on*/
    input  logic           [               7:0] link_valid_i,
    output logic           [               7:0] link_ready_o,
    /*verilator tracing_off*/
    input  rc2_pkg::beam_t                     link0_i,
    input  rc2_pkg::beam_t                     link1_i,
    input  rc2_pkg::beam_t                     link2_i,
    input  rc2_pkg::beam_t                     link3_i,
    input  rc2_pkg::beam_t                     link4_i,
    input  rc2_pkg::beam_t                     link5_i,
    input  rc2_pkg::beam_t                     link6_i,
    input  rc2_pkg::beam_t                     link7_i,
    /*verilator tracing_on*/
    output logic           [               7:0] link_valid_o,
    input  logic           [               7:0] link_ready_i,
    /*verilator tracing_off*/
    output rc2_pkg::beam_t                     link0_o,
    output rc2_pkg::beam_t                     link1_o,
    output rc2_pkg::beam_t                     link2_o,
    output rc2_pkg::beam_t                     link3_o,
    output rc2_pkg::beam_t                     link4_o,
    output rc2_pkg::beam_t                     link5_o,
    output rc2_pkg::beam_t                     link6_o,
    output rc2_pkg::beam_t                     link7_o,
    // targets on their way home
    input  logic           [rc2_pkg::HomeW-1:0] home_i,
    output logic           [rc2_pkg::HomeW-1:0] home_o,
    /*verilator tracing_on*/
    output logic                               busy_o
    /*verilator tracing_off*/
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned ExtentW = rc2_pkg::ExtentW;

  logic [rc2_pkg::ValueW-1:0] visits_q;
  logic [rc2_pkg::QueueW-1:0] deepest;
  logic [15:0] signature;
  logic [rc2_pkg::N-1:0] occupied, stops;

  rc2_limits u_limits ();

  // ---- The column ----------------------------------------------------------------------------------
  logic voxels_busy, fill;
  logic [CoordW-1:0] light_addr, fill_z;
  logic [rc2_pkg::HomeW-1:0] arrived;
  // No rays in thesis mode.
  logic ray_word, ray_read, ray_read_taken;
  logic [rc2_pkg::KindW-1:0] ray_kind;
  logic [rc2_pkg::RestW-1:0] ray_rest;
  logic [rc2_pkg::N-1:0] ray_solid;
  rc2_pkg::claim_t ray_owner;
  /*verilator tracing_on*/
  rc2_voxels u_voxels (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .x_i         (x_i),
      .y_i         (y_i),
      .clear_i     (clear_i),
      .prepare_i   (1'b0),
      .accurate_i  (1'b0),
      .source_i    (light_i),
      .word_valid_i(word_valid_i),
      .word_i      (word_i),
      .word_ready_o(word_ready_o),
      .word_valid_o(word_valid_o),
      .word_o      (word_o),
      .word_ready_i(word_ready_i),
      .occupied_o  (occupied),
      .fill_o      (fill),
      .fill_z_o    (fill_z),
      .stops_o     (stops),
      .light_addr_o(light_addr),
      .light_i     (arrived),
      .ends_i      ('0),
      .visits_i    (visits_q),
      .history_i   ({signature, deepest}),
      .ray_word_o           (ray_word),
      .ray_kind_o           (ray_kind),
      .ray_rest_o           (ray_rest),
      .ray_ready_i          (1'b1),
      .ray_reads_i          (1'b0),
      .ray_addr_i           ('0),
      .owner_o              (ray_owner),
      .solid_o              (ray_solid),
      .ray_read_o           (ray_read),
      .ray_read_done_i      (1'b0),
      .ray_read_done_taken_o(ray_read_taken),
      .ray_data_valid_i     (1'b0),
      .ray_data_i           ('0),
      .busy_o      (voxels_busy)
  );
  /*verilator tracing_off*/

  // ---- Light: links -> queue -> links, column ----------------------------------------------------
  logic arrival_valid, arrival_take, router_busy;
  rc2_pkg::beam_t arrival;
  rc2_pkg::split_t split;
  logic [7:0] send, writable;
  rc2_router u_router (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .x_i            (x_i),
      .y_i            (y_i),
      .start_i        (start_i),
      .light_i        (light_i),
      .link_valid_i   (link_valid_i),
      .link_ready_o   (link_ready_o),
      .link0_i        (link0_i),
      .link1_i        (link1_i),
      .link2_i        (link2_i),
      .link3_i        (link3_i),
      .link4_i        (link4_i),
      .link5_i        (link5_i),
      .link6_i        (link6_i),
      .link7_i        (link7_i),
      .link_valid_o   (link_valid_o),
      .link_ready_i   (link_ready_i),
      .link0_o        (link0_o),
      .link1_o        (link1_o),
      .link2_o        (link2_o),
      .link3_o        (link3_o),
      .link4_o        (link4_o),
      .link5_o        (link5_o),
      .link6_o        (link6_o),
      .link7_o        (link7_o),
      .arrival_valid_o(arrival_valid),
      .arrival_o      (arrival),
      .arrival_take_i (arrival_take),
      .writable_o     (writable),
      .split_i        (split),
      .send_i         (send),
      .busy_o         (router_busy)
  );

  /*verilator tracing_on*/
  logic absorb, served;
  /*verilator tracing_off*/
  logic finished, tally_busy;
  /*verilator tracing_on*/
  logic [CoordW-1:0] absorb_z;
  /*verilator tracing_off*/
  logic [ExtentW-1:0] served_u, served_v, kept_u, kept_v;
  /*verilator tracing_on*/
  logic [rc2_pkg::QueueW-1:0] queued;
  rc2_diffuser u_diffuser (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .x_i       (x_i),
      .y_i       (y_i),
      .light_i   (light_i),
      .occupied_i(occupied),
      .valid_i   (arrival_valid),
      .beam_i    (arrival),
      .take_o    (arrival_take),
      .writable_i(writable),
      .split_o   (split),
      .send_o    (send),
      .absorb_o  (absorb),
      .absorb_z_o(absorb_z),
      .served_u_o(served_u),
      .served_v_o(served_v),
      .kept_u_o  (kept_u),
      .kept_v_o  (kept_v),
      .served_o  (served),
      .finished_o(finished),
      .queue_o   (queued)
  );

  /*verilator tracing_off*/
  logic [rc2_pkg::HomeW-1:0] area;
  rc2_tally u_tally (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .served_i  (served),
      .served_u_i(served_u),
      .served_v_i(served_v),
      .kept_u_i  (kept_u),
      .kept_v_i  (kept_v),
      .area_o    (area),
      .home_i    (home_i),
      .home_o    (home_o),
      .busy_o    (tally_busy)
  );

  // Beams served and the deepest queue, for whoever wants to know where the time went.
  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) visits_q <= '0;
    else if (finished) visits_q <= visits_q + 1'b1;
  end
  rc2_history #(
      .Width(rc2_pkg::QueueW)
  ) u_history (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .start_i    (start_i),
      .depth_i    (queued),
      .deepest_o  (deepest),
      .signature_o(signature)
  );

  // ---- Targets that arrive -------------------------------------------------------------------------
  logic arrivals_busy;
  rc2_arrivals u_arrivals (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .start_i    (start_i),
      .absorb_i   (absorb),
      .absorb_z_i (absorb_z),
      .area_i     (area),
      .read_addr_i(light_addr),
      .count_o    (arrived),
      .busy_o     (arrivals_busy)
  );

  assign busy_o = voxels_busy || router_busy || (queued != 0) || tally_busy || arrivals_busy;

  // Contract: light finds no loading under way.
  always_ff @(posedge clk_i) if (rst_ni) assert (!(start_i && busy_o));
endmodule
