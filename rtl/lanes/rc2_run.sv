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

  logic [N-1:0] above, start;
  logic [N:0] free, stop;
  assign above = stops_i & ({N{1'b1}} << from_i);
  assign start = above & (~above + 1'b1);
  // Adding the run's first bit carries through the run to the first free voxel.
  assign free = {1'b0, above} + {1'b0, start};
  assign stop = free & ~{1'b0, above};
  assign found_o = (above != 0);
  always_comb begin
    first_o = '0;
    end_o   = '0;
    for (int i = 0; i < N; i++) if (start[i]) first_o = first_o | CountW'(i);
    for (int i = 0; i <= N; i++) if (stop[i] && found_o) end_o = end_o | CountW'(i);
  end
endmodule
