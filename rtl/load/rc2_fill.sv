// SPDX-License-Identifier: Apache-2.0
//
// Writes a dexel into the column, one voxel per cycle (thesis 3.9, Afficher_Voxel). Where facets
// overlap the best claim owns the voxel (rc2_pkg::claim_t), whatever the order of arrival: the
// owner is read one cycle before it is written.
//
// A guard claims likewise, but what is occupied it leaves alone. Packets of the other layers walk as
// well, but write nothing into the owner's memory: the voxel that the walk has just left is marked as
// shown; a packet of the layer "inside" flips the parity from the dexel's low end up, in one step.
//
// The gap at the dexel's low end is gap_c * lo + gap_d, added up bit by bit. A dexel lo..hi keeps
// the unit for bits(lo) + hi - lo + 1 cycles, and the last write falls in the cycle after them.

module rc2_fill (
    input  logic                         clk_i,
    input  logic                         rst_ni,
    input  logic                         valid_i,
    input  logic [  rc2_pkg::FacetW-1:0] facet_i,
    input  logic [  rc2_pkg::LayerW-1:0] layer_i,
    input  rc2_pkg::plane_t              plane_i,
    input  logic [  rc2_pkg::CoordW-1:0] z0_i,         // the others count from here
    input  logic [  rc2_pkg::CoordW-1:0] lo_i,
    input  logic [  rc2_pkg::CoordW-1:0] hi_i,
    input  logic [  rc2_pkg::CoordW-1:0] core_lo_i,
    input  logic [  rc2_pkg::CoordW-1:0] core_hi_i,
    input  logic [rc2_pkg::GapValueW-1:0] gap_c_i,
    input  logic [rc2_pkg::GapValueW-1:0] gap_d_i,
    output logic                         ready_o,
    // the column's memory
    input  logic [       rc2_pkg::N-1:0] occupied_i,
    input  logic [       rc2_pkg::N-1:0] guard_i,
    output logic [  rc2_pkg::CoordW-1:0] read_addr_o,
    input  rc2_pkg::claim_t              read_owner_i,
    output logic                         write_o,      // the owner of an occupied voxel
    output logic                         guard_o,      // the owner of a guard
    output logic                         show_o,
    output logic                         flip_o,
    output logic [  rc2_pkg::CoordW-1:0] write_addr_o,
    output rc2_pkg::claim_t              write_owner_o,
    output rc2_pkg::plane_t              write_plane_o,
    output logic                         busy_o
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned GapW = rc2_pkg::GapW;
  localparam int unsigned GapValueW = rc2_pkg::GapValueW;

  logic seeking_q, walking_q, writing_q;
  logic [rc2_pkg::FacetW-1:0] facet_q;
  logic [rc2_pkg::LayerW-1:0] layer_q, written_layer_q;
  rc2_pkg::plane_t plane_q, written_plane_q;
  logic [CoordW-1:0] z0_q, z_q, end_q, core_lo_q, core_hi_q;
  logic [CoordW-1:0] to_seek_q;  // bits of lo that the gap still lacks
  logic [GapValueW-1:0] gap_q, step_q, shifted_step_q;
  logic [CoordW-1:0] written_z_q;
  rc2_pkg::claim_t written_q;

  assign ready_o = !seeking_q && !walking_q;
  assign busy_o = !ready_o || writing_q;
  assign read_addr_o = z0_q + z_q;
  assign write_addr_o = written_z_q;
  assign write_owner_o = written_q;
  assign write_o = writing_q && (written_layer_q == rc2_pkg::LayerArmour) &&
                   (!occupied_i[written_z_q] || written_q < read_owner_i);
  assign guard_o = writing_q && (written_layer_q == rc2_pkg::LayerGuard) &&
                   !occupied_i[written_z_q] && (!guard_i[written_z_q] || written_q < read_owner_i);
  assign write_plane_o = written_plane_q;
  assign show_o = writing_q && (written_layer_q == rc2_pkg::LayerShown);
  assign flip_o = writing_q && (written_layer_q == rc2_pkg::LayerInside);

  logic seeks;
  assign seeks = (layer_i == rc2_pkg::LayerArmour || layer_i == rc2_pkg::LayerGuard) && (lo_i != 0);

  logic [CoordW-1:0] to_seek_next;
  logic [GapValueW-1:0] added;
  assign to_seek_next = to_seek_q >> 1;
  assign added = seeking_q ? (to_seek_q[0] ? shifted_step_q : '0) : step_q;

  logic [GapW-1:0] gap;
  rc2_pkg::claim_t claim;
  assign gap = gap_q[GapValueW-1-:GapW];
  assign claim.not_core = (z_q < core_lo_q) || (z_q > core_hi_q);
  assign claim.distance = gap[GapW-1] ? ~gap[GapW-2:0] : gap[GapW-2:0];
  assign claim.facet = facet_q;
  assign claim.behind = gap[GapW-1];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seeking_q <= 1'b0;
      walking_q <= 1'b0;
      writing_q <= 1'b0;
    end else begin
      writing_q <= walking_q;
      if (ready_o) begin
        seeking_q <= valid_i && seeks;
        walking_q <= valid_i && !seeks;
      end else if (seeking_q) begin
        seeking_q <= (to_seek_next != 0);
        walking_q <= (to_seek_next == 0);
      end else begin
        walking_q <= (z_q != end_q);
      end
    end
    if (ready_o) begin
      facet_q        <= facet_i;
      z0_q           <= z0_i;
      z_q            <= lo_i;
      end_q          <= (layer_i == rc2_pkg::LayerInside) ? lo_i : hi_i;
      layer_q        <= layer_i;
      plane_q        <= plane_i;
      core_lo_q      <= core_lo_i;
      core_hi_q      <= core_hi_i;
      to_seek_q      <= lo_i;
      gap_q          <= gap_d_i;
      step_q         <= gap_c_i;
      shifted_step_q <= gap_c_i;
    end else begin
      if (walking_q) z_q <= z_q + 1'b1;
      to_seek_q      <= to_seek_next;
      gap_q          <= gap_q + added;
      shifted_step_q <= shifted_step_q << 1;
    end
    written_z_q <= z0_q + z_q;
    written_q   <= claim;
    written_layer_q  <= layer_q;
    written_plane_q  <= plane_q;
  end

  // Contract: never past the dexel's end.
  always_ff @(posedge clk_i) begin
    if (rst_ni && walking_q) assert (z_q <= end_q);
    if (rst_ni) assert (!(seeking_q && walking_q));
  end
endmodule
