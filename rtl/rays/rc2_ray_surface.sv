// SPDX-License-Identifier: Apache-2.0
//
// What the owner of each voxel of a column does with light that rays bring: the words RAY of a facet
// come to the cells of its box, and each cell gives them to those voxels of the box that the facet owns,
// a voxel a cycle. ready_o is low meanwhile.

module rc2_ray_surface (
    input  logic                           clk_i,
    input  logic                           rst_ni,
    // HEAD and RAY words as they leave the row's pipe
    input  logic                           word_i,
    input  logic [  rc2_pkg::KindW-1:0] kind_i,
    input  logic [  rc2_pkg::RestW-1:0] rest_i,
    output logic                           ready_o,
    // the owner's memory: what it holds of the address in the cycle before
    output logic [ rc2_pkg::CoordW-1:0] addr_o,
    input  rc2_pkg::claim_t             owner_i,
    // what it is all for
    input  logic [ rc2_pkg::CoordW-1:0] read_addr_i,
    output rc2_pkg::optics_t            optics_o  // of the address in the cycle before
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned SlopeFormW = rc2_pkg::SlopeFormW;
  localparam int unsigned NormalRestW = 2 + 3 * SlopeFormW;
  localparam int unsigned RestW = rc2_pkg::RestW;

  logic is_head, is_ray, starts;
  logic [rc2_pkg::SortW-1:0] sort;
  assign is_head = word_i && (kind_i == rc2_pkg::KindHead);
  assign is_ray = word_i && (kind_i == rc2_pkg::KindRay);
  assign sort = rest_i[RestW-1-:rc2_pkg::SortW];
  assign starts = is_ray && (sort == rc2_pkg::SortShares);

  logic seeking_q, judging_q;
  logic [rc2_pkg::FacetW-1:0] facet_q;
  logic [CoordW-1:0] z_q, end_q, judged_z_q;
  logic [NormalRestW-1:0] normal_q;
  logic [rc2_pkg::SharesRestW-1:0] shares_q;
  logic [rc2_pkg::OpticsW-1:0] optics;
  logic [CoordW-1:0] head_z0, head_span;
  assign {head_span, head_z0} = rest_i[2*CoordW-1:0];
  assign ready_o = !seeking_q && !judging_q;
  assign addr_o = z_q;

  rc2_ram #(
      .Width(rc2_pkg::OpticsW),
      .Depth(rc2_pkg::N)
  ) u_optics (
      .clk_i       (clk_i),
      .write_i     (judging_q && owner_i.facet == facet_q),
      .write_addr_i(judged_z_q),
      .write_data_i({normal_q, shares_q}),
      .read_addr_i (read_addr_i),
      .read_data_o (optics)
  );
  assign optics_o = optics;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seeking_q <= 1'b0;
      judging_q <= 1'b0;
    end else begin
      seeking_q <= starts || (seeking_q && z_q != end_q);
      judging_q <= seeking_q;
    end
    if (is_head) begin
      facet_q <= rest_i[2*CoordW+:rc2_pkg::FacetW];
      z_q     <= head_z0;
      end_q   <= head_z0 + head_span;
    end else if (seeking_q) begin
      z_q <= z_q + 1'b1;
    end
    if (is_ray && sort == rc2_pkg::SortNormal) normal_q <= rest_i[NormalRestW-1:0];
    if (starts) shares_q <= rest_i[rc2_pkg::SharesRestW-1:0];
    judged_z_q <= z_q;
  end

  // Contract: one facet after another.
  always_ff @(posedge clk_i) begin
    if (rst_ni && word_i) assert (ready_o);
  end
endmodule
