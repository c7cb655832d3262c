// SPDX-License-Identifier: Apache-2.0
//
// rc2_ratio and rc2_border together: the last target whose ray is at offset w or below after k steps is
// (2w+1)*L / 2k with a real division, rounded down; the division of a negative number is that of its
// size, rounded up. The ratio of k = 1 and 2, which rc2_pace shifts out of L, is exact.

module border_formula (
    input logic clk_i
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned RatioW = rc2_pkg::RatioW;
  localparam int unsigned RatioF = rc2_pkg::RatioF;
  localparam int unsigned StopW = rc2_pkg::StopW;
  localparam int unsigned OddW = CoordW + 2;
  localparam int unsigned WideW = OddW + DistanceW;

  (* anyconst *) logic [CountW-1:0] step;
  (* anyconst *) logic [DistanceW-1:0] distance;
  (* anyconst *) logic signed [OddW-1:0] odd;
  logic [RatioW-1:0] looked_up, ratio;
  rc2_ratio u_ratio (
      .clk_i     (clk_i),
      .step_i    (step),
      .distance_i(distance),
      .ratio_o   (looked_up)
  );
  assign ratio = (step == CountW'(1)) ? RatioW'(distance) << (RatioF - 1) :
                 (step == CountW'(2)) ? RatioW'(distance) << (RatioF - 2) : looked_up;
  logic signed [StopW-1:0] last;
  rc2_border u_border (
      .odd_i  (odd),
      .ratio_i(ratio),
      .last_o (last)
  );

  logic known_q = 1'b0;  // of the step in the cycle before
  always_ff @(posedge clk_i) known_q <= 1'b1;
  logic [OddW-1:0] size;
  logic [WideW-1:0] dividend, divisor, rounded_down, rounded_up;
  assign size = odd[OddW-1] ? $unsigned(-odd) : $unsigned(odd);
  assign dividend = WideW'(size) * WideW'(distance);
  assign divisor = WideW'({step, 1'b0});
  assign rounded_down = dividend / divisor;
  assign rounded_up = (dividend + divisor - 1'b1) / divisor;
  always_comb begin
    assume (step != 0 && step <= CountW'(rc2_pkg::N));
    assume (distance != 0 && distance <= DistanceW'(rc2_pkg::LMAX));
    assume (odd[0] && WideW'(size) < divisor);
    if (known_q) assert (last == (odd[OddW-1] ? -$signed(StopW'(rounded_up)) : $signed(StopW'(rounded_down))));
  end
endmodule
