// SPDX-License-Identifier: Apache-2.0
//
// rc2_place against the definition of a digital ray (thesis 4.3.1): after k steps the ray of target j is at
// the integer o nearest to j*k/L, ties down: (2o-1)*L < 2*j*k <= (2o+1)*L. The slope is k times 1/L, which
// the host rounds down, to a fraction.

module place_ray (
    input logic        [   rc2_pkg::CountW-1:0] step_i,
    input logic        [rc2_pkg::DistanceW-1:0] distance_i,
    input logic signed [  rc2_pkg::TargetW-1:0] target_i
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned OffW = rc2_pkg::OffW;
  localparam int unsigned SlopeF = rc2_pkg::SlopeF;
  localparam int unsigned SlopeW = rc2_pkg::SlopeW;
  // As rc2_pace adds it up: the inverse has CoordW bits more than the slope.
  localparam int unsigned SumW = SlopeW + CoordW;
  localparam int unsigned WideW = TargetW + OffW + 2;

  logic [SumW-1:0] one, inverse, sum;
  assign one = SumW'(1) << (SlopeF + CoordW);
  assign inverse = (distance_i == 1) ? one - 1'b1 : one / SumW'(distance_i);
  assign sum = SumW'(step_i) * inverse;
  logic signed [OffW-1:0] offset;
  rc2_place u_place (
      .target_i(target_i),
      .slope_i (sum[CoordW+:SlopeW]),
      .offset_o(offset)
  );
  logic signed [WideW-1:0] far, twice, way;
  assign far = $signed(WideW'(distance_i));
  assign twice = WideW'(offset) <<< 1;
  assign way = (WideW'(target_i) * $signed(WideW'(step_i))) <<< 1;
  always_comb begin
    assume (step_i != 0 && step_i < CountW'(rc2_pkg::N));
    assume (distance_i != 0 && distance_i <= rc2_pkg::DistanceW'(rc2_pkg::LMAX));
    assume (-far <= WideW'(target_i) && WideW'(target_i) <= far);
    assert ((twice - 2'sd1) * far < way && way <= (twice + 2'sd1) * far);
  end
endmodule
