// SPDX-License-Identifier: Apache-2.0
//
// rc2_stops answers a beam's question right: of the targets min .. end that it speaks of, those from
// free_min to free_max are the ones whose rays are at a free voxel after k steps. `target` is any one of
// them, its voxel that of the definition of a ray. At any time after k is set, whatever was asked before.

module stops_answer (
    input logic                               clk_i,
    input logic                               ask_i,
    input logic signed [rc2_pkg::TargetW-1:0] min_i,
    input logic signed [rc2_pkg::TargetW-1:0] max_i
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned StopW = rc2_pkg::StopW;
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned RatioW = rc2_pkg::RatioW;
  localparam int unsigned SlopeW = rc2_pkg::SlopeW;
  localparam int unsigned WideW = TargetW + CoordW + 4;
  localparam int unsigned LongW = SlopeW + CoordW + 1;

  logic rst_ni = 1'b0;
  logic set_q = 1'b0, known_before_q = 1'b0;  // k is set in the second cycle after the reset
  always_ff @(posedge clk_i) begin
    rst_ni <= 1'b1;
    known_before_q <= rst_ni;
    set_q <= rst_ni && !known_before_q;
  end

  (* anyconst *) logic [rc2_pkg::CountW-1:0] step;
  (* anyconst *) logic [DistanceW-1:0] distance;
  (* anyconst *) logic [CoordW-1:0] zs;
  (* anyconst *) logic [N-1:0] stops;
  (* anyconst *) logic signed [TargetW-1:0] target;

  // L/2k rounded up (less than two units too large), k/L as rc2_pace adds it up.
  logic [RatioW+DistanceW-1:0] dividend;
  logic [LongW-1:0] one, inverse, sum;
  assign dividend = (RatioW + DistanceW)'(distance) << rc2_pkg::RatioF;
  assign one = LongW'(1) << SlopeW;
  assign inverse = (distance == 1) ? one - 1'b1 : one / LongW'(distance);
  assign sum = inverse * LongW'(step);
  logic known, busy;
  logic signed [StopW-1:0] clip_min, clip_max, free_min, free_max, last;
  rc2_stops u_stops (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .start_i   (1'b0),
      .set_i     (set_q),
      .step_i    (step),
      .ratio_i   (RatioW'((dividend + (RatioW + DistanceW)'({step, 1'b0}) - 1'b1) / (RatioW + DistanceW)'({step, 1'b0}))),
      .slope_i   (sum[CoordW+:SlopeW]),
      .zs_i      (zs),
      .distance_i(distance),
      .stops_i   (stops),
      .beyond_i  (1'b1),
      .low_i     ('0),
      .high_i    (CoordW'(N - 1)),
      .clip_min_o(clip_min),
      .clip_max_o(clip_max),
      .ask_i     (ask_i),
      .min_i     (min_i),
      .max_i     (max_i),
      .known_o   (known),
      .free_min_o(free_min),
      .free_max_o(free_max),
      .end_o     (last),
      .mark_i    (1'b0),
      .busy_o    (busy)
  );

  // ---- Where the target's ray is ---------------------------------------------------------------
  logic signed [WideW-1:0] far, way, wide_target;
  logic [N-1:0] at;  // one voxel, or none where it is out of the cube
  assign far = $signed(WideW'(distance));
  assign wide_target = WideW'(target);
  assign way = (wide_target * $signed(WideW'(step))) <<< 1;
  for (genvar z = 0; z < N; z++) begin : g_voxel
    logic signed [WideW-1:0] twice;
    assign twice = ($signed(WideW'(z)) - $signed(WideW'(zs))) <<< 1;
    assign at[z] = (twice - 2'sd1) * far < way && way <= (twice + 2'sd1) * far;
  end

  logic signed [StopW-1:0] asked, wide_min, wide_max;
  assign asked = StopW'(target);
  assign wide_min = StopW'(min_i);
  assign wide_max = StopW'(max_i);
  always_comb begin
    assume (step != 0 && step < rc2_pkg::CountW'(N));
    assume (distance != 0 && distance <= DistanceW'(rc2_pkg::LMAX));
    assume (-far <= wide_target && wide_target <= far);
    // What is asked lies in the cube: rc2_side_lane clips it.
    assume (!ask_i || (clip_min <= wide_min && wide_min <= wide_max && wide_max <= clip_max));
    if (ask_i && known && known_before_q && !set_q) begin
      assert (last >= wide_min && last <= wide_max);
      if (wide_min <= asked && asked <= last)
        assert ((free_min <= asked && asked <= free_max) == ((stops & at) == 0));
    end
  end
endmodule
