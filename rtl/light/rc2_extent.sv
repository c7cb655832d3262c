// SPDX-License-Identifier: Apache-2.0
//
// Number of targets of a beam along one axis in the parts that are served and in those that are
// kept in the cube. Combinational.

module rc2_extent (
    input  logic signed [rc2_pkg::TargetW-1:0] min_i,
    input  logic signed [rc2_pkg::TargetW-1:0] max_i,
    input  logic signed [rc2_pkg::TargetW-1:0] low_max_i,
    input  logic signed [rc2_pkg::TargetW-1:0] high_min_i,
    input  logic signed [rc2_pkg::TargetW-1:0] mid_min_i,
    input  logic signed [rc2_pkg::TargetW-1:0] mid_max_i,
    input  logic        [                 2:0] served_i,  // {high, middle, low}
    input  logic        [                 2:0] kept_i,
    output logic        [rc2_pkg::ExtentW-1:0] served_o,
    output logic        [rc2_pkg::ExtentW-1:0] kept_o
);
  localparam int unsigned ExtentW = rc2_pkg::ExtentW;

  // Differences of targets, as counts: the low ExtentW bits of a non-negative number.
  logic [ExtentW-1:0] low, middle, high;
  assign low = ExtentW'(low_max_i) - ExtentW'(min_i) + 1'b1;
  assign middle = ExtentW'(mid_max_i) - ExtentW'(mid_min_i) + 1'b1;
  assign high = ExtentW'(max_i) - ExtentW'(high_min_i) + 1'b1;

  assign served_o = (served_i[0] ? low : '0) + (served_i[1] ? middle : '0) +
                    (served_i[2] ? high : '0);
  assign kept_o = (kept_i[0] ? low : '0) + (kept_i[1] ? middle : '0) + (kept_i[2] ? high : '0);

  // Contract: what is kept was served.
  always_comb assert ((kept_i & ~served_i) == 0);
endmodule
