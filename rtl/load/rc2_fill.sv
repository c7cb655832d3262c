// SPDX-License-Identifier: Apache-2.0
//
// Writes a dexel into the column, one voxel per cycle (thesis 3.9, Afficher_Voxel). Where facets
// overlap the lowest facet number owns the voxel, whatever the order of arrival: the owner is read
// one cycle before it is written. A dexel of m voxels keeps the unit for m cycles, and the last
// write falls in the cycle after them.

module rc2_fill (
    input  logic                       clk_i,
    input  logic                       rst_ni,
    input  logic                       valid_i,
    input  logic [rc2_pkg::FacetW-1:0] facet_i,
    input  logic [rc2_pkg::CoordW-1:0] lo_i,
    input  logic [rc2_pkg::CoordW-1:0] hi_i,
    output logic                       ready_o,
    // the column's memory
    input  logic [     rc2_pkg::N-1:0] occupied_i,
    output logic [rc2_pkg::CoordW-1:0] read_addr_o,
    input  logic [rc2_pkg::FacetW-1:0] read_owner_i,
    output logic                       write_o,
    output logic [rc2_pkg::CoordW-1:0] write_addr_o,
    output logic [rc2_pkg::FacetW-1:0] write_owner_o,
    output logic                       busy_o
);
  logic walking_q, writing_q;
  logic [rc2_pkg::CoordW-1:0] z_q, end_q, written_z_q;
  logic [rc2_pkg::FacetW-1:0] facet_q, written_facet_q;

  assign ready_o = !walking_q;
  assign busy_o = walking_q || writing_q;
  assign read_addr_o = z_q;
  assign write_addr_o = written_z_q;
  assign write_owner_o = written_facet_q;
  assign write_o = writing_q && (!occupied_i[written_z_q] || written_facet_q < read_owner_i);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      walking_q <= 1'b0;
      writing_q <= 1'b0;
    end else begin
      writing_q <= walking_q;
      if (walking_q) walking_q <= (z_q != end_q);
      else walking_q <= valid_i;
    end
    if (ready_o) begin
      facet_q <= facet_i;
      z_q     <= lo_i;
      end_q   <= hi_i;
    end else begin
      z_q <= z_q + 1'b1;
    end
    written_z_q     <= z_q;
    written_facet_q <= facet_q;
  end

  // Contract: never past the dexel's end.
  always_ff @(posedge clk_i) begin
    if (rst_ni && walking_q) assert (z_q <= end_q);
  end
endmodule
