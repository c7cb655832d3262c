// SPDX-License-Identifier: Apache-2.0
//
// rc2_pace is never early: the light goes on until step kmax, the distance of the farthest face, has had
// both its cycles, or until a step has ended after cells were said to be idle. Until then a step takes two
// cycles, the lane upwards in the first, downwards in the second, each as long as it is in the cube, in the
// layer that many steps from the light.

module pace_steps (
    input logic clk_i,
    input logic start_i,
    input logic idle_i
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned WideW = CoordW + 3;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  (* anyconst *) rc2_pkg::light_t light;
  rc2_pkg::pace_t pace;
  logic tick, busy;
  rc2_pace u_pace (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(start_i),
      .light_i(light),
      .pace_o (pace),
      .tick_o (tick),
      .idle_i (idle_i),
      .busy_o (busy)
  );

  // ---- Another clock: cycles since the start -----------------------------------------------------
  logic [WideW-1:0] time_q, step, far, up_room, down_room;
  logic running_q, second, last_layer;
  assign up_room = WideW'(N - 1) - WideW'(light.zs);
  assign down_room = WideW'(light.zs);
  assign step = time_q >> 1;
  assign second = time_q[0];
  logic [WideW-1:0] distances[0:5];
  assign distances[0] = WideW'(light.xs);
  assign distances[1] = WideW'(N - 1) - WideW'(light.xs);
  assign distances[2] = WideW'(light.ys);
  assign distances[3] = WideW'(N - 1) - WideW'(light.ys);
  assign distances[4] = down_room;
  assign distances[5] = up_room;
  always_comb begin
    far = '0;
    for (int i = 0; i < 6; i++) if (distances[i] > far) far = distances[i];
  end
  assign last_layer = (step == far);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) running_q <= 1'b0;
    else if (start_i) running_q <= 1'b1;
    else if (second && (last_layer || (idle_i && step != 0))) running_q <= 1'b0;
    time_q <= start_i ? '0 : time_q + 1'b1;
  end
  // One light after the other, the next no sooner than the registers of the last have settled.
  logic rests_q;
  always_ff @(posedge clk_i) rests_q <= rst_ni && !running_q && !start_i;
  always_comb begin
    assume (light.xs < N && light.ys < N && light.zs < N);
    assume (!start_i || rests_q);
  end

  logic [WideW-1:0] layer, room;
  assign room = second ? down_room : up_room;
  assign layer = second ? WideW'(light.zs) - step : WideW'(light.zs) + step;
  logic [CoordW-1:0] layer_q;  // as the pace said it in the cycle before
  always_ff @(posedge clk_i) layer_q <= pace.next_layer;
  (* hierconn *) wire \u_pace.second_q ;
  always_comb begin
    if (rst_ni) begin
      assert (busy == running_q && pace.active == running_q);
      if (running_q) begin
        assert (step <= far);
        assert (pace.first == !second && tick == second && WideW'(pace.step) == step);
        assert (pace.on == (step <= room));
        assert (pace.last == (step == room));
        if (pace.on) assert (WideW'(layer_q) == layer);
        assert (pace.tell == !second);
        if (pace.tell) assert (WideW'(pace.tell_step) == step + WideW'(2));
      end else begin
        assert (!pace.on && pace.tell == start_i);
        if (start_i) assert (WideW'(pace.tell_step) == WideW'(1) && !\u_pace.second_q );
      end
      if (!running_q && rests_q) assert (!\u_pace.second_q );
    end
  end
endmodule
