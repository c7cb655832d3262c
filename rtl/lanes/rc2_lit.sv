// SPDX-License-Identifier: Apache-2.0
//
// Which voxels of a column light has reached: a bit each, right for L at least as large as the
// number of steps (a smaller L leaves voxels between two rays, which a run of marks covers).

module rc2_lit (
    input  logic                       clk_i,
    input  logic                       start_i,
    input  logic [rc2_pkg::N-1:0] occupied_i,
    input  logic [rc2_pkg::N-1:0] marks_i,      // of side beams
    input  logic                       reached_i,    // by a z lane
    input  logic [rc2_pkg::CoordW-1:0] z_i,
    input  logic [rc2_pkg::CoordW-1:0] read_addr_i,
    output logic                       lit_o         // of the address in the cycle before
);
  localparam int unsigned N = rc2_pkg::N;
  logic [N-1:0] lit_q, reached;
  always_comb begin
    reached = '0;
    for (int i = 0; i < N; i++) reached[i] = reached_i && (z_i == rc2_pkg::CoordW'(i));
  end
  always_ff @(posedge clk_i) begin
    if (start_i) lit_q <= '0;
    else lit_q <= lit_q | (occupied_i & (marks_i | reached));
    lit_o <= lit_q[read_addr_i];
  end
endmodule
