// SPDX-License-Identifier: Apache-2.0
//
// The light's six first beams part the targets: any one point of the virtual cube's surface (thesis
// 4.3.4) is in exactly one of them, and no beam has more than the surface. Six beams are all there are,
// so as many cycles are complete.

module source_six (
    input logic clk_i
);
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned CoordW = rc2_pkg::CoordW;

  logic rst_ni = 1'b0;
  logic start = 1'b1;  // in the first cycle after the reset
  always_ff @(posedge clk_i) begin
    rst_ni <= 1'b1;
    start  <= !rst_ni;
  end

  (* anyconst *) rc2_pkg::light_t light;
  logic valid;
  rc2_pkg::beam_t beam;
  rc2_source u_source (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(start && rst_ni),
      .x_i    (light.xs),
      .y_i    (light.ys),
      .light_i(light),
      .valid_o(valid),
      .beam_o (beam),
      .take_i (valid)
  );

  // ---- Any one target ----------------------------------------------------------------------------
  (* anyconst *) logic signed [TargetW:0] x;
  (* anyconst *) logic signed [TargetW:0] y;
  (* anyconst *) logic signed [TargetW:0] z;
  logic signed [TargetW:0] far, u, v, w, umin, umax, vmin, vmax;
  assign far = $signed({2'b00, light.distance});
  assign w = beam.dir[2] ? z : beam.dir[1] ? y : x;
  assign u = (beam.dir[2:1] == 2'd0) ? y : x;
  assign v = beam.dir[2] ? y : z;
  assign umin = $signed({beam.umin[TargetW-1], beam.umin});
  assign umax = $signed({beam.umax[TargetW-1], beam.umax});
  assign vmin = $signed({beam.vmin[TargetW-1], beam.vmin});
  assign vmax = $signed({beam.vmax[TargetW-1], beam.vmax});
  logic holds;
  assign holds = rst_ni && valid && (w == (beam.dir[0] ? -far : far)) && umin <= u && u <= umax && vmin <= v && v <= vmax;
  always_comb begin
    assume (light.distance != 0 && light.distance <= rc2_pkg::DistanceW'(rc2_pkg::LMAX) && light.fa != 0);
    assume (-far <= x && x <= far && -far <= y && y <= far && -far <= z && z <= far);
    assume (x == far || x == -far || y == far || y == -far || z == far || z == -far);
  end

  logic [3:0] held_q = 4'd0, cycle_q = 4'd0;
  always_ff @(posedge clk_i) begin
    held_q  <= held_q + 4'(holds);
    cycle_q <= (cycle_q == 4'd9) ? cycle_q : cycle_q + 1'b1;
  end
  always_comb begin
    if (cycle_q == 4'd9) assert (!valid && held_q == 4'd1);
    if (rst_ni && valid) begin
      assert (-far <= umin && umax <= far && -far <= vmin && vmax <= far);
      assert (beam.z == light.zs);
    end
  end
endmodule
