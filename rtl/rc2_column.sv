// SPDX-License-Identifier: Apache-2.0
//
// The voxel and illumination memories of one column (thesis 1.3), and their readback.
//
// occupied, lit: one register bit a voxel, all readable at once and cleared in one cycle, so
// neither memory needs clearing: an owner means something where occupied, a count where lit.
// Claim of the owner, and count: RAM words. A count takes a new arrival every cycle, also at the same voxel: the
// sum written in the cycle before is bypassed, as the RAM still shows the old one.
//
// Layers (rc2_pkg::LAYERS): shown, inside and guard, one register bit a voxel each, the parity of the
// object under way, and the owner's plane beside its claim. Guards, too, have an owner.
//
// Readback: while read_i asks, one word per occupied voxel in order of z (or one word that says
// there is none), a word every second cycle, then read_done_o for one accepted cycle.

module rc2_column (
    input  logic                       clk_i,
    input  logic                       rst_ni,
    input  logic                       clear_i,         // forget all voxels
    output logic [     rc2_pkg::N-1:0] occupied_o,
    output logic [     rc2_pkg::N-1:0] guard_o,
    output logic [     rc2_pkg::N-1:0] solid_o,
    // loading
    output rc2_pkg::claim_t            owner_o,         // of the address in the cycle before
    input  logic [rc2_pkg::CoordW-1:0] owner_addr_i,
    input  logic                       fill_i,
    input  logic [rc2_pkg::CoordW-1:0] fill_z_i,
    input  rc2_pkg::claim_t            fill_owner_i,
    // the other layers: what becomes of voxel fill_z_i
    output rc2_pkg::plane_t            plane_o,         // of the owner, as owner_o
    input  rc2_pkg::plane_t            fill_plane_i,
    input  logic                       guard_i,
    input  logic                       show_i,
    input  logic                       flip_i,
    input  logic                       end_i,           // of an object
    // light: what arrived at the voxel of the address in the cycle before
    output logic [rc2_pkg::CoordW-1:0] light_addr_o,
    input  logic [ rc2_pkg::HomeW-1:0] light_i,
    // counters
    input  logic [ rc2_pkg::HomeW-1:0] ends_i,
    input  logic [rc2_pkg::ValueW-1:0] visits_i,
    input  logic [rc2_pkg::HistoryW-1:0] history_i,
    // readback
    input  logic                       read_i,
    input  logic [                2:0] read_what_i,
    output logic                       read_done_o,
    input  logic                       read_done_taken_i,
    output logic                       data_valid_o,
    output rc2_pkg::data_t             data_o,
    input  logic                       data_ready_i,
    output logic                       busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned ValueW = rc2_pkg::ValueW;

  logic [N-1:0] occupied_q;
  assign occupied_o = occupied_q;

  // ---- Readback: which word ----------------------------------------------------------------------
  logic reading_q, fetched_q, done_q, any;
  logic [N-1:0] todo_q, rest;
  logic [CoordW-1:0] first_z;
  rc2_first #(
      .Width(N)
  ) u_first (
      .bits_i (todo_q),
      .found_o(any),
      .index_o(first_z)
  );
  assign rest = todo_q & ~(N'(1) << first_z);

  // ---- Owner ---------------------------------------------------------------------------------------
  rc2_ram #(
      .Width(rc2_pkg::ClaimW),
      .Depth(N)
  ) u_owner (
      .clk_i       (clk_i),
      .write_i     (fill_i || guard_i),
      .write_addr_i(fill_z_i),
      .write_data_i(fill_owner_i),
      .read_addr_i (reading_q ? first_z : owner_addr_i),
      .read_data_o (owner_o)
  );

  // ---- Layers ----------------------------------------------------------------------------------------
  logic [N-1:0] shown, solid, guarded;
  assign guard_o = guarded;
  assign solid_o = solid;
  if (rc2_pkg::LAYERS) begin : g_layers
    logic [N-1:0] shown_q, solid_q, guard_q, parity_q;
    rc2_ram #(
        .Width(rc2_pkg::OwnerPlaneW),
        .Depth(N)
    ) u_plane (
        .clk_i       (clk_i),
        .write_i     (fill_i || guard_i),
        .write_addr_i(fill_z_i),
        .write_data_i(fill_plane_i),
        .read_addr_i (owner_addr_i),
        .read_data_o (plane_o)
    );
    assign shown = shown_q;
    assign solid = solid_q;
    assign guarded = guard_q & ~occupied_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni || clear_i) begin
        shown_q  <= '0;
        solid_q  <= '0;
        guard_q  <= '0;
        parity_q <= '0;
      end else begin
        if (show_i) shown_q[fill_z_i] <= 1'b1;
        if (guard_i) guard_q[fill_z_i] <= 1'b1;
        if (flip_i) parity_q <= parity_q ^ ({N{1'b1}} << fill_z_i);
        if (end_i) begin
          solid_q  <= solid_q | parity_q;
          parity_q <= '0;
        end
      end
    end
  end else begin : g_armour
    assign shown = '0;
    assign solid = '0;
    assign guarded = '0;
    assign plane_o = '0;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) occupied_q <= '0;
    else if (fill_i) occupied_q[fill_z_i] <= 1'b1;
  end

  // ---- Readback: the words -----------------------------------------------------------------------
  logic sent;
  logic [N-1:0] wanted;
  always_comb begin
    case (read_what_i)
      rc2_pkg::ReadCounters: wanted = N'(3);
      rc2_pkg::ReadEnds: wanted = N'(1);
      rc2_pkg::ReadLayers: wanted = occupied_q | shown | solid | guarded;
      default: wanted = occupied_q;
    endcase
  end
  assign sent = fetched_q && data_ready_i;
  assign data_valid_o = fetched_q;
  assign read_done_o = done_q;

  always_comb begin
    data_o.last  = (rest == 0);
    data_o.empty = !any;
    data_o.z     = first_z;
    case (read_what_i)
      rc2_pkg::ReadVoxels: data_o.value = ValueW'(owner_o);
      rc2_pkg::ReadLayers:
      data_o.value = ValueW'({guarded[first_z], solid[first_z], shown[first_z], occupied_q[first_z]});
      rc2_pkg::ReadLight:  data_o.value = ValueW'(light_i);
      rc2_pkg::ReadEnds:   data_o.value = ValueW'(ends_i);
      default:             data_o.value = (first_z == 0) ? visits_i : ValueW'(history_i);
    endcase
    // What no voxel has written is unknown, and nothing unknown may leave the machine.
    if (!any) data_o.value = '0;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      reading_q <= 1'b0;
      fetched_q <= 1'b0;
      done_q    <= 1'b0;
    end else begin
      if (read_i && !reading_q && !done_q) reading_q <= 1'b1;
      if (reading_q) fetched_q <= !sent;
      if (sent && data_o.last) begin
        reading_q <= 1'b0;
        fetched_q <= 1'b0;
        done_q    <= 1'b1;
      end
      if (read_done_taken_i) done_q <= 1'b0;
    end
    if (read_i && !reading_q) begin
      todo_q <= wanted;
    end else if (sent) begin
      todo_q <= rest;
    end
  end

  assign light_addr_o = first_z;
  assign busy_o = reading_q || done_q;

  // Contract: loading and readback never meet.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(fill_i && reading_q));
      assert (!(end_i && (fill_i || guard_i || flip_i)));
      assert (!(clear_i && fill_i));
    end
  end
endmodule
