// SPDX-License-Identifier: Apache-2.0
//
// rc2_extent counts the targets of the parts that it is asked for. The parts follow each other and cover
// min .. max (proved of rc2_split_axis); an empty one is not asked for.

module extent_counts (
    input logic signed [rc2_pkg::TargetW-1:0] min_i,
    input logic signed [rc2_pkg::TargetW-1:0] max_i,
    input logic signed [rc2_pkg::TargetW-1:0] low_end,
    input logic signed [rc2_pkg::TargetW-1:0] mid_end,
    input logic        [                 2:0] part,
    input logic        [                 2:0] served,
    input logic        [                 2:0] kept
);
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned ExtentW = rc2_pkg::ExtentW;
  localparam int unsigned WideW = TargetW + 2;

  logic [ExtentW-1:0] served_targets, kept_targets;
  logic signed [TargetW-1:0] far;
  assign far = $signed(TargetW'(rc2_pkg::LMAX));
  rc2_extent u_extent (
      .min_i     (min_i),
      .max_i     (max_i),
      .low_max_i (low_end),
      .high_min_i(mid_end + 1'b1),
      .mid_min_i (low_end + 1'b1),
      .mid_max_i (mid_end),
      .served_i  (served & part),
      .kept_i    (kept & served & part),
      .served_o  (served_targets),
      .kept_o    (kept_targets)
  );
  logic signed [WideW-1:0] low, middle, high, wide_min, wide_max, wide_low, wide_mid;
  assign wide_min = {{2{min_i[TargetW-1]}}, min_i};
  assign wide_max = {{2{max_i[TargetW-1]}}, max_i};
  assign wide_low = {{2{low_end[TargetW-1]}}, low_end};
  assign wide_mid = {{2{mid_end[TargetW-1]}}, mid_end};
  assign low = wide_low - wide_min + 2'sd1;
  assign middle = wide_mid - wide_low;
  assign high = wide_max - wide_mid;
  logic [WideW-1:0] want_served, want_kept;
  assign want_served = ((served[0] && part[0]) ? low : '0) + ((served[1] && part[1]) ? middle : '0) +
                       ((served[2] && part[2]) ? high : '0);
  assign want_kept = ((kept[0] && served[0] && part[0]) ? low : '0) +
                     ((kept[1] && served[1] && part[1]) ? middle : '0) +
                     ((kept[2] && served[2] && part[2]) ? high : '0);
  always_comb begin
    assume (-far <= min_i && max_i <= far);
    assume (wide_min - 2'sd1 <= wide_low && low_end <= mid_end && mid_end <= max_i);
    assert (WideW'(served_targets) == want_served);
    assert (WideW'(kept_targets) == want_kept);
  end
endmodule
