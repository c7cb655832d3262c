// SPDX-License-Identifier: Apache-2.0
//
// The cell's column of voxels with what loads it and reads it back: a stage of the row's facet pipe,
// the dexel unit (thesis 3.4), the fill unit and the memories. A packet's word takes one cycle in the
// stage; what the dexel and the fill unit take is said there. Before an accurate light the column
// looks up where it will stop (rc2_prepare).

module rc2_voxels (
    /*verilator tracing_off*/
    input  logic                               clk_i,
    input  logic                               rst_ni,
    input  logic           [rc2_pkg::CoordW-1:0] x_i,
    input  logic           [rc2_pkg::CoordW-1:0] y_i,
    input  logic                               clear_i,
    input  logic                               prepare_i,
    input  logic                               accurate_i,  // rule of the light
    input  rc2_pkg::light_t                    source_i,
    // row pipe: from the west, to the east
    input  logic                               word_valid_i,
    input  logic           [rc2_pkg::RowWordW-1:0] word_i,
    output logic                               word_ready_o,
    output logic                               word_valid_o,
    output logic           [rc2_pkg::RowWordW-1:0] word_o,
    input  logic                               word_ready_i,
    // to and from the light
    output logic           [     rc2_pkg::N-1:0] occupied_o,
    output logic                               fill_o,    // voxel fill_z_o is occupied from now on
    output logic           [rc2_pkg::CoordW-1:0] fill_z_o,
    output logic           [     rc2_pkg::N-1:0] stops_o,
    output logic           [rc2_pkg::CoordW-1:0] light_addr_o,
    input  logic           [ rc2_pkg::HomeW-1:0] light_i,  // of the address in the cycle before
    input  logic           [ rc2_pkg::HomeW-1:0] ends_i,
    input  logic           [rc2_pkg::ValueW-1:0] visits_i,
    input  logic [rc2_pkg::HistoryW-1:0] history_i,
    // to and from the rays: HEAD and RAY words, the owner of an address, readback
    output logic                               ray_word_o,
    output logic           [ rc2_pkg::KindW-1:0] ray_kind_o,
    output logic           [ rc2_pkg::RestW-1:0] ray_rest_o,
    input  logic                               ray_ready_i,
    input  logic                               ray_reads_i,
    input  logic           [rc2_pkg::CoordW-1:0] ray_addr_i,
    output rc2_pkg::claim_t                    owner_o,  // of the address in the cycle before
    output logic           [     rc2_pkg::N-1:0] solid_o,
    output logic                               ray_read_o,
    input  logic                               ray_read_done_i,
    output logic                               ray_read_done_taken_o,
    input  logic                               ray_data_valid_i,
    input  rc2_pkg::data_t                     ray_data_i,
    output logic                               busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned RestW = rc2_pkg::RestW;
  localparam int unsigned NormalW = rc2_pkg::NormalW;
  localparam int unsigned GapPartW = NormalW + 2;  // of a gap's coefficient, at most one: its low bits
  localparam int unsigned RowPayloadW = rc2_pkg::RowPayloadW;

  /*verilator tracing_on*/
  logic [N-1:0] occupied;
  /*verilator tracing_off*/
  assign occupied_o = occupied;

  // ---- Loading: row pipe -> dexel -> column ------------------------------------------------------
  logic stage_valid, unit_waits, unit_valid, unit_ready, stage_busy;
  logic [rc2_pkg::KindW-1:0] unit_kind;
  logic [RestW-1:0] unit_rest;
  logic [rc2_pkg::LeadW-1:0] unit_lead;
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
      .unit_lead_o (unit_lead),
      .unit_ready_i(unit_ready),
      .next_valid_o(stage_valid),
      .next_word_o (stage_word),
      .next_ready_i(word_ready_i),
      .busy_o      (stage_busy)
  );

  logic is_read, is_end, is_ray, is_packet, dexel_ready, fill_ready, fill_busy;
  logic [rc2_pkg::LayerW-1:0] dexel_layer;
  logic [CoordW-1:0] dexel_z0, core_lo, core_hi;
  /*verilator tracing_on*/
  logic dexel_valid;
  logic [rc2_pkg::FacetW-1:0] dexel_facet;
  logic [CoordW-1:0] dexel_lo, dexel_hi;
  /*verilator tracing_off*/
  assign is_read = (unit_kind == rc2_pkg::KindRead);
  assign is_end = (unit_kind == rc2_pkg::KindEnd);
  assign is_ray = (unit_kind == rc2_pkg::KindRay);
  assign is_packet = !is_read && !is_end && !is_ray;
  rc2_dexel u_dexel (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .valid_i  (unit_waits && is_packet),
      .kind_i   (unit_kind),
      .rest_i   (unit_rest),
      .ready_o  (dexel_ready),
      .take_i   (unit_valid && is_packet && dexel_ready && ray_ready_i),
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
  logic [CoordW-1:0] fill_z, fill_addr;
  rc2_pkg::claim_t fill_owner, owner;
  rc2_pkg::plane_t word_plane, fill_plane, plane;
  logic show, flip, guard;
  logic [N-1:0] guarded, solid;
  // What the gap rises by in a voxel, rounded (sw/machine/plane.h): a is the lead of the cells; of b,
  // the lead of the rows, the host has put a copy into the rest.
  assign word_plane.x = NormalW'((unit_lead[GapPartW-1:0] + GapPartW'(2)) >> 2);
  assign word_plane.z = NormalW'((unit_rest[rc2_pkg::DistW+:GapPartW] + GapPartW'(2)) >> 2);
  assign {word_plane.surface, word_plane.y} =
      unit_rest[rc2_pkg::DistW+rc2_pkg::GapValueW+:rc2_pkg::SurfaceW+NormalW];
  rc2_fill u_fill (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .valid_i      (dexel_valid && unit_valid && ray_ready_i),
      .facet_i      (dexel_facet),
      .layer_i      (dexel_layer),
      .plane_i      (word_plane),
      .z0_i         (dexel_z0),
      .lo_i         (dexel_lo),
      .hi_i         (dexel_hi),
      .core_lo_i    (core_lo),
      .core_hi_i    (core_hi),
      .gap_c_i      (unit_rest[rc2_pkg::DistW+:rc2_pkg::GapValueW]),
      .gap_d_i      (unit_rest[rc2_pkg::GapValueW-1:0]),
      .ready_o      (fill_ready),
      .occupied_i   (occupied),
      .guard_i      (guarded),
      .read_addr_o  (fill_addr),
      .read_owner_i (owner),
      .write_o      (fill),
      .guard_o      (guard),
      .show_o       (show),
      .flip_o       (flip),
      .write_addr_o (fill_z),
      .write_owner_o(fill_owner),
      .write_plane_o(fill_plane),
      .busy_o       (fill_busy)
  );

  assign fill_o = fill;
  assign fill_z_o = fill_z;

  // ---- The column and its readback -----------------------------------------------------------------
  logic read, of_rays, column_done, read_done, column_valid, data_valid, column_busy, preparing;
  logic [CoordW-1:0] prepare_addr;
  rc2_pkg::data_t column_data, data;
  assign read = unit_valid && is_read && !fill_busy;
  assign of_rays = rc2_pkg::RAYS && (unit_rest[2:0] == rc2_pkg::ReadHits);
  assign ray_read_o = read && of_rays;
  assign ray_read_done_taken_o = unit_valid && is_read && ray_read_done_i;
  assign read_done = of_rays ? ray_read_done_i : column_done;
  assign data_valid = column_valid || ray_data_valid_i;
  assign data = ray_data_valid_i ? ray_data_i : column_data;
  assign owner_o = owner;
  assign solid_o = solid;
  rc2_column u_column (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .clear_i          (clear_i),
      .occupied_o       (occupied),
      .guard_o          (guarded),
      .solid_o          (solid),
      .owner_o          (owner),
      .owner_addr_i     (preparing ? prepare_addr : ray_reads_i ? ray_addr_i : fill_addr),
      .fill_i           (fill),
      .fill_z_i         (fill_z),
      .fill_owner_i     (fill_owner),
      .plane_o          (plane),
      .fill_plane_i     (fill_plane),
      .guard_i          (guard),
      .show_i           (show),
      .flip_i           (flip),
      .end_i            (unit_valid && is_end && !fill_busy),
      .light_addr_o     (light_addr_o),
      .light_i          (light_i),
      .ends_i           (ends_i),
      .visits_i         (visits_i),
      .history_i        (history_i),
      .read_i           (read && !of_rays),
      .read_what_i      (unit_rest[2:0]),
      .read_done_o      (column_done),
      .read_done_taken_i(unit_valid && is_read && column_done),
      .data_valid_o     (column_valid),
      .data_o           (column_data),
      .data_ready_i     (word_ready_i),
      .busy_o           (column_busy)
  );

  // A READ word waits in the stage while the column's own words go east, then follows them.
  assign unit_ready = is_read ? read_done : is_end ? !fill_busy :
                      (is_ray || dexel_ready) && ray_ready_i;
  assign ray_word_o = unit_valid && unit_ready && (is_ray || unit_kind == rc2_pkg::KindHead);
  assign ray_kind_o = unit_kind;
  assign ray_rest_o = unit_rest;
  assign word_valid_o = data_valid || stage_valid;
  assign word_o = data_valid ?
      {rc2_pkg::KindData, {(RowPayloadW - rc2_pkg::DataW) {1'b0}}, data} :
      stage_word;

  // ---- Where light stops ---------------------------------------------------------------------------
  if (rc2_pkg::LAYERS && !rc2_pkg::THESIS) begin : g_prepare
    logic [N-1:0] stops;
    rc2_prepare u_prepare (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .start_i   (prepare_i),
        .x_i       (x_i),
        .y_i       (y_i),
        .light_i   (source_i),
        .occupied_i(occupied),
        .guard_i   (guarded),
        .solid_i   (solid),
        .addr_o    (prepare_addr),
        .owner_i   (owner),
        .plane_i   (plane),
        .stops_o   (stops),
        .busy_o    (preparing)
    );
    assign stops_o = accurate_i ? stops : occupied;
  end else begin : g_occupied
    assign prepare_addr = '0;
    assign preparing = 1'b0;
    assign stops_o = occupied;
  end

  assign busy_o = stage_busy || fill_busy || column_busy || preparing;

  // Contract: the row pipe carries one word at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(data_valid && stage_valid));
      assert (!(clear_i && busy_o));
    end
  end
endmodule
