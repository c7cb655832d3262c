// SPDX-License-Identifier: Apache-2.0
//
// rc2_run finds the first maximal interval of stops from a voxel on: `z` is any one voxel.

module run_maximal (
    input logic [     rc2_pkg::N-1:0] stops_i,
    input logic [rc2_pkg::CountW-1:0] from_i,
    input logic [rc2_pkg::CountW-1:0] z
);
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam logic [CountW-1:0] Top = CountW'(rc2_pkg::N);

  logic found;
  logic [CountW-1:0] first, end_of;
  rc2_run u_run (
      .stops_i(stops_i),
      .from_i (from_i),
      .found_o(found),
      .first_o(first),
      .end_o  (end_of)
  );
  always_comb begin
    assume (from_i <= Top && z < Top);
    if (found) begin
      assert (from_i <= first && first < end_of && end_of <= Top);
      assert (end_of == Top || !stops_i[end_of]);
      if (from_i <= z && z < end_of) assert (stops_i[z] == (first <= z));
    end else begin
      assert (z < from_i || !stops_i[z]);
    end
  end
endmodule
