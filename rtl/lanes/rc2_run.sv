// SPDX-License-Identifier: Apache-2.0
//
// The first run of stops in a column at or above voxel from_i. Combinational.

module rc2_run (
    input  logic [rc2_pkg::N-1:0] stops_i,
    input  logic [rc2_pkg::CountW-1:0] from_i,
    output logic                       found_o,
    output logic [rc2_pkg::CountW-1:0] first_o,  // its first voxel
    output logic [rc2_pkg::CountW-1:0] end_o     // the first voxel above it, rc2_pkg::N at the top
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CountW = rc2_pkg::CountW;

  localparam int unsigned CoordW = rc2_pkg::CoordW;
  logic [N-1:0] above, last;  // the last voxel of a run
  logic [CoordW-1:0] first;
  assign above = stops_i & ({N{1'b1}} << from_i);
  assign last = above & ~(stops_i >> 1);
  // Both at once: of the runs that are not yet over at from_i the first to begin is the first to end.
  rc2_first #(
      .Width(N)
  ) u_first (
      .bits_i (above),
      .found_o(found_o),
      .index_o(first)
  );
  logic ends;
  rc2_first #(
      .Width(N + 1)
  ) u_end (
      .bits_i ({last, 1'b0}),
      .found_o(ends),
      .index_o(end_o)
  );
  assign first_o = CountW'(first);

  // Contract: what begins ends.
  always_comb assert (ends == found_o);
endmodule
