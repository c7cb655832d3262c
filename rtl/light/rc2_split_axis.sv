// SPDX-License-Identifier: Apache-2.0
//
// Splits a beam's interval of targets along one axis where the digital rays part (thesis 4.3.1.3,
// 4.3.3): a low part to the cell one below, a middle part straight on, a high part to the cell one
// above. Only a cell in line with the source has all three; elsewhere rays only move outward.
// Combinational.

module rc2_split_axis (
    input  logic                                  valid_i,     // min <= max: an interval is there
    input  logic signed [   rc2_pkg::TargetW-1:0] min_i,
    input  logic signed [   rc2_pkg::TargetW-1:0] max_i,
    input  logic                                  negative_i,  // the cell's offset is < 0
    input  logic                                  zero_i,      // the cell's offset is 0
    input  logic        [rc2_pkg::DistanceW-1:0] floor_i,     // Y_med of |offset|, down and up
    input  logic        [rc2_pkg::DistanceW-1:0] ceil_i,
    output logic        [                    2:0] part_o,      // {high, middle, low} not empty
    output logic signed [   rc2_pkg::TargetW-1:0] low_max_o,
    output logic signed [   rc2_pkg::TargetW-1:0] mid_min_o,
    output logic signed [   rc2_pkg::TargetW-1:0] mid_max_o,
    output logic signed [   rc2_pkg::TargetW-1:0] high_min_o
);
  localparam int unsigned TargetW = rc2_pkg::TargetW;

  // Targets up to `down` go low, targets above `up` go high.
  logic signed [TargetW-1:0] up, down;
  logic low_side, high_side;
  assign up = $signed({1'b0, floor_i});
  assign down = -$signed({1'b0, ceil_i});
  assign low_side = negative_i || zero_i;
  assign high_side = !negative_i;

  logic low, middle, high;
  assign low  = low_side && (min_i <= down);
  assign high = high_side && (max_i > up);

  assign low_max_o = (max_i < down) ? max_i : down;
  assign high_min_o = (min_i > up) ? min_i : up + 1'b1;
  assign mid_min_o = low ? down + 1'b1 : min_i;
  assign mid_max_o = high ? up : max_i;
  assign middle = (mid_min_o <= mid_max_o);
  assign part_o = {high, middle, low};

  // Contract: the parts follow each other without gap or overlap and cover the interval.
  always_comb begin
    if (valid_i) begin
      assert (part_o != 0);
      if (low && middle) assert (mid_min_o == low_max_o + 1'b1);
      if (middle && high) assert (high_min_o == mid_max_o + 1'b1);
      if (low && high) assert (middle);
      if (!low) assert ((middle ? mid_min_o : high_min_o) == min_i);
      if (!high) assert ((middle ? mid_max_o : low_max_o) == max_i);
    end
  end
endmodule
