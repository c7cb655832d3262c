// SPDX-License-Identifier: Apache-2.0
//
// rc2_ymed equals Y_med = (2w+1)*L / 2(k+1) (thesis 4.3.1) with a real division, rounded down and up.

module ymed_formula (
    input logic [   rc2_pkg::CoordW-1:0] offset_i,
    input logic [   rc2_pkg::CountW-1:0] step_i,
    input logic [rc2_pkg::DistanceW-1:0] distance_i
);
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned WideW = rc2_pkg::CoordW + 1 + DistanceW;

  logic [DistanceW-1:0] rounded_down, rounded_up;
  rc2_ymed u_ymed (
      .offset_i  (offset_i),
      .step_i    (step_i),
      .distance_i(distance_i),
      .floor_o   (rounded_down),
      .ceil_o    (rounded_up)
  );
  logic [WideW-1:0] dividend, divisor;
  assign dividend = WideW'({offset_i, 1'b1}) * WideW'(distance_i);
  assign divisor = WideW'({step_i, 1'b0});
  always_comb begin
    assume (step_i != 0 && step_i <= rc2_pkg::CountW'(rc2_pkg::N));
    assume (rc2_pkg::CountW'(offset_i) < step_i);
    assume (distance_i <= DistanceW'(rc2_pkg::LMAX));
    assert (WideW'(rounded_down) == dividend / divisor);
    assert (WideW'(rounded_up) == (dividend + divisor - 1'b1) / divisor);
  end
endmodule
