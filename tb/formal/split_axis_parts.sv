// SPDX-License-Identifier: Apache-2.0
//
// rc2_split_axis parts an interval: any one target of it is in exactly one of low, middle and high, and in
// that which Y_med says; no target outside is in any.

module split_axis_parts (
    input logic signed [  rc2_pkg::TargetW-1:0] min_i,
    input logic signed [  rc2_pkg::TargetW-1:0] max_i,
    input logic                                 negative_i,
    input logic                                 zero_i,
    input logic        [rc2_pkg::DistanceW-1:0] floor_i,
    input logic                                 exact_i,
    input logic signed [  rc2_pkg::TargetW-1:0] target
);
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned TargetW = rc2_pkg::TargetW;

  logic [DistanceW-1:0] rounded_up;
  assign rounded_up = floor_i + DistanceW'(!exact_i);
  logic [2:0] part;
  logic signed [TargetW-1:0] low_max, mid_min, mid_max, high_min, far;
  rc2_split_axis u_split (
      .valid_i   (1'b1),
      .min_i     (min_i),
      .max_i     (max_i),
      .negative_i(negative_i),
      .zero_i    (zero_i),
      .floor_i   (floor_i),
      .ceil_i    (rounded_up),
      .part_o    (part),
      .low_max_o (low_max),
      .mid_min_o (mid_min),
      .mid_max_o (mid_max),
      .high_min_o(high_min)
  );

  logic in_low, in_mid, in_high, goes_low, goes_high;
  assign in_low = part[0] && min_i <= target && target <= low_max;
  assign in_mid = part[1] && mid_min <= target && target <= mid_max;
  assign in_high = part[2] && high_min <= target && target <= max_i;
  assign goes_low = (negative_i || zero_i) && target <= -$signed({1'b0, rounded_up});
  assign goes_high = !negative_i && target > $signed({1'b0, floor_i});
  assign far = $signed(TargetW'(rc2_pkg::LMAX));
  // At offset 0 Y_med is at most L/2; elsewhere all targets are on the cell's side of the light.
  always_comb begin
    assume (!(negative_i && zero_i));
    assume (-far <= min_i && min_i <= max_i && max_i <= far);
    assume (floor_i <= DistanceW'(rc2_pkg::LMAX) && rounded_up <= DistanceW'(rc2_pkg::LMAX) && rounded_up != 0);
    if (min_i <= target && target <= max_i) begin
      assert (in_low == goes_low);
      assert (in_high == goes_high);
      assert (in_mid == (!goes_low && !goes_high));
    end else begin
      assert (!in_low && !in_mid && !in_high);
    end
  end
endmodule
