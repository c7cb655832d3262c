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

module rc2_cell (
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
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned ExtentW = rc2_pkg::ExtentW;
  localparam int unsigned RestW = rc2_pkg::RestW;
  localparam int unsigned RowPayloadW = rc2_pkg::RowPayloadW;

  /*verilator tracing_on*/
  logic [N-1:0] occupied;
  /*verilator tracing_off*/

  // ---- Loading: row pipe -> dexel -> column ------------------------------------------------------
  logic stage_valid, unit_waits, unit_valid, unit_ready, stage_busy;
  logic [rc2_pkg::KindW-1:0] unit_kind;
  logic [RestW-1:0] unit_rest;
  logic [rc2_pkg::RowWordW-1:0] stage_word;
  rc2_facet_stage #(
      .PayloadW(RowPayloadW)
  ) u_stage (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .valid_i     (word_valid_i),
      .word_i      (word_i),
      .ready_o     (word_ready_o),
      .unit_waits_o(unit_waits),
      .unit_valid_o(unit_valid),
      .unit_word_o ({unit_kind, unit_rest}),
      .unit_ready_i(unit_ready),
      .next_valid_o(stage_valid),
      .next_word_o (stage_word),
      .next_ready_i(word_ready_i),
      .busy_o      (stage_busy)
  );

  logic is_read, is_end, dexel_ready, fill_ready, fill_busy;
  logic [rc2_pkg::LayerW-1:0] dexel_layer;
  logic [CoordW-1:0] dexel_z0, core_lo, core_hi;
  /*verilator tracing_on*/
  logic dexel_valid;
  logic [rc2_pkg::FacetW-1:0] dexel_facet;
  logic [CoordW-1:0] dexel_lo, dexel_hi;
  /*verilator tracing_off*/
  assign is_read = (unit_kind == rc2_pkg::KindRead);
  assign is_end = (unit_kind == rc2_pkg::KindEnd);
  rc2_dexel u_dexel (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .valid_i  (unit_waits && !is_read && !is_end),
      .kind_i   (unit_kind),
      .rest_i   (unit_rest),
      .ready_o  (dexel_ready),
      .take_i   (unit_valid && !is_read && !is_end && dexel_ready),
      .valid_o  (dexel_valid),
      .facet_o  (dexel_facet),
      .layer_o  (dexel_layer),
      .z0_o     (dexel_z0),
      .lo_o     (dexel_lo),
      .hi_o     (dexel_hi),
      .core_lo_o(core_lo),
      .core_hi_o(core_hi),
      .ready_i  (fill_ready)
  );

  logic fill;
  logic [CoordW-1:0] fill_z, owner_addr;
  rc2_pkg::claim_t fill_owner, owner;
  logic show, flip, thin;
  logic [rc2_pkg::FacingW-1:0] fill_facing, facing;
  rc2_fill u_fill (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .valid_i      (dexel_valid && unit_valid),
      .facet_i      (dexel_facet),
      .layer_i      (dexel_layer),
      .facing_i     (unit_rest[rc2_pkg::DistW+rc2_pkg::GapValueW+:rc2_pkg::FacingW]),
      .z0_i         (dexel_z0),
      .lo_i         (dexel_lo),
      .hi_i         (dexel_hi),
      .core_lo_i    (core_lo),
      .core_hi_i    (core_hi),
      .gap_c_i      (unit_rest[rc2_pkg::DistW+:rc2_pkg::GapValueW]),
      .gap_d_i      (unit_rest[rc2_pkg::GapValueW-1:0]),
      .ready_o      (fill_ready),
      .occupied_i   (occupied),
      .read_addr_o  (owner_addr),
      .read_owner_i (owner),
      .read_facing_i(facing),
      .write_o      (fill),
      .write_facing_o(fill_facing),
      .show_o       (show),
      .flip_o       (flip),
      .thin_o       (thin),
      .write_addr_o (fill_z),
      .write_owner_o(fill_owner),
      .busy_o       (fill_busy)
  );

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
  logic [rc2_pkg::QueueW-1:0] queue;
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
      .queue_o   (queue)
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
  logic [rc2_pkg::ValueW-1:0] visits_q;
  logic [rc2_pkg::QueueW-1:0] deepest_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) begin
      visits_q  <= '0;
      deepest_q <= '0;
    end else begin
      if (finished) visits_q <= visits_q + 1'b1;
      if (queue > deepest_q) deepest_q <= queue;
    end
  end

  // ---- The column and its readback -----------------------------------------------------------------
  logic read, read_done, data_valid, column_busy;
  rc2_pkg::data_t data;
  assign read = unit_valid && is_read && !fill_busy;
  rc2_column u_column (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .clear_i          (clear_i),
      .start_i          (start_i),
      .occupied_o       (occupied),
      .owner_o          (owner),
      .owner_addr_i     (owner_addr),
      .fill_i           (fill),
      .fill_z_i         (fill_z),
      .fill_owner_i     (fill_owner),
      .facing_o         (facing),
      .fill_facing_i    (fill_facing),
      .show_i           (show),
      .flip_i           (flip),
      .thin_i           (thin),
      .end_i            (unit_valid && is_end && !fill_busy),
      .absorb_i         (absorb),
      .absorb_z_i       (absorb_z),
      .area_i           (area),
      .visits_i         (visits_q),
      .deepest_i        (deepest_q),
      .read_i           (read),
      .read_what_i      (unit_rest[1:0]),
      .read_done_o      (read_done),
      .read_done_taken_i(unit_valid && is_read && read_done),
      .data_valid_o     (data_valid),
      .data_o           (data),
      .data_ready_i     (word_ready_i),
      .busy_o           (column_busy)
  );

  // A READ word waits in the stage while the column's own words go east, then follows them.
  assign unit_ready = is_read ? read_done : is_end ? !fill_busy : dexel_ready;
  assign word_valid_o = data_valid || stage_valid;
  assign word_o = data_valid ?
      {rc2_pkg::KindData, {(RowPayloadW - rc2_pkg::DataW) {1'b0}}, data} :
      stage_word;

  assign busy_o = stage_busy || fill_busy || router_busy || (queue != 0) ||
                  tally_busy || column_busy;

  // Contract: the row pipe carries one word at a time; light finds no loading under way.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(data_valid && stage_valid));
      assert (!(start_i && busy_o));
      assert (!(clear_i && busy_o));
    end
  end
endmodule
