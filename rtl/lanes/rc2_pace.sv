// SPDX-License-Identifier: Apache-2.0
//
// The clock of the light in lanes: one step every two cycles, from the light's voxel to the
// farthest face of the cube, or until there is no light in any cell. In the first cycle of a step the lane upwards moves on in all cells,
// in the second the lane downwards.
//
// Before the wave of the side beams comes to the cells at distance k, they hear of L/2k and k/L:
// k = 1 with the start, k = s+2 in the first cycle of step s. The axes hear of each L/2k one step
// earlier. One of these per machine; light_i must be steady for four cycles before the start.

module rc2_pace (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              start_i,
    input  rc2_pkg::light_t                   light_i,
    output rc2_pkg::pace_t                    pace_o,
    output logic                              tick_o,   // a step begins in the next cycle
    output logic        [rc2_pkg::RatioW-1:0] ratio_o,  // of the axes: L/2(s+3) in step s
    input  logic                              idle_i,   // no cell was busy two cycles ago
    output logic                              busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam int unsigned RatioF = rc2_pkg::RatioF;
  localparam int unsigned RatioW = rc2_pkg::RatioW;
  localparam int unsigned SlopeW = rc2_pkg::SlopeW;
  localparam logic [CoordW-1:0] Last = CoordW'(N - 1);

  // ---- Steps -----------------------------------------------------------------------------------
  logic active_q, second_q, on_q, last_q;
  logic [CountW-1:0] step_q;
  logic [CoordW-1:0] up_x, up_y, up_z, far_x, far_y, far_z, far_xy, far;
  assign up_x = Last - light_i.xs;
  assign up_y = Last - light_i.ys;
  assign up_z = Last - light_i.zs;
  assign far_x = (up_x > light_i.xs) ? up_x : light_i.xs;
  assign far_y = (up_y > light_i.ys) ? up_y : light_i.ys;
  assign far_z = (up_z > light_i.zs) ? up_z : light_i.zs;
  assign far_xy = (far_x > far_y) ? far_x : far_y;
  assign far = (far_xy > far_z) ? far_xy : far_z;

  // The lane of the next cycle: upwards with a step's beginning, else downwards.
  logic next_up;
  logic [CountW-1:0] next_step;
  logic [CoordW-1:0] next_room;
  assign next_up = !active_q || second_q;
  assign next_step = !active_q ? '0 : step_q + CountW'(second_q);
  assign next_room = next_up ? up_z : light_i.zs;

  // Of the first step the array does not yet know.
  logic ended;
  assign ended = idle_i && (step_q != 0);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      second_q <= 1'b0;
      step_q   <= '0;
      on_q     <= 1'b0;
      last_q   <= 1'b0;
    end else begin
      if (start_i) active_q <= 1'b1;
      else if (second_q && (step_q == CountW'(far) || ended)) active_q <= 1'b0;
      second_q <= active_q && !second_q;
      step_q   <= next_step;
      on_q     <= (next_step <= CountW'(next_room));
      last_q   <= (next_step == CountW'(next_room));
    end
  end
  assign tick_o = start_i || (active_q && second_q);
  assign busy_o = active_q;

  // ---- L/2k and k/L ------------------------------------------------------------------------------
  logic [RatioW-1:0] ratio, cells_ratio_q, axes_ratio_q;
  logic [CountW-1:0] coming;  // k of the next ratio: at the start those of 1 and 2 are there
  assign coming = active_q ? step_q + CountW'(4) : CountW'(3);
  logic [SlopeW+CoordW-1:0] slope_q;
  rc2_ratio u_ratio (
      .clk_i     (clk_i),
      .step_i    (coming),  // steady for the cycle before a tick
      .distance_i(light_i.distance),
      .ratio_o   (ratio)
  );
  always_ff @(posedge clk_i) begin
    if (tick_o) begin
      cells_ratio_q <= axes_ratio_q;
      axes_ratio_q  <= ratio;
      slope_q       <= slope_q + (SlopeW + CoordW)'(light_i.inverse);
    end else if (!active_q) begin
      cells_ratio_q <= RatioW'(light_i.distance) << (RatioF - 1);
      axes_ratio_q  <= RatioW'(light_i.distance) << (RatioF - 2);
      slope_q       <= (SlopeW + CoordW)'(light_i.inverse);
    end
  end
  assign ratio_o = axes_ratio_q;

  assign pace_o.active = active_q;
  assign pace_o.first = !second_q;
  assign pace_o.step = step_q;
  assign pace_o.on = active_q && on_q;
  assign pace_o.last = last_q;
  assign pace_o.next_layer = next_up ? light_i.zs + next_step[CoordW-1:0] :
                                       light_i.zs - next_step[CoordW-1:0];
  assign pace_o.tell = start_i || (active_q && !second_q);
  assign pace_o.tell_step = start_i ? CountW'(1) : step_q + CountW'(2);
  assign pace_o.ratio = cells_ratio_q;
  assign pace_o.slope = slope_q[CoordW+:SlopeW];

  // Contract: one light after the other.
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (!(start_i && active_q));
  end
endmodule
