// SPDX-License-Identifier: Apache-2.0
//
// The whole array in thesis mode with light from any voxel, any L and any voxels occupied: no target is
// lost, the light ends, all targets are home then and not before. Cycles from reset up to one by which
// every light has ended are therefore complete.

module thesis_light_ends #(
    parameter int unsigned Cycles = 60
) (
    input logic clk_i
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam int unsigned RowWordW = rc2_pkg::RowWordW;

  logic rst_ni = 1'b0;
  logic [7:0] cycle_q = 8'd0;
  always_ff @(posedge clk_i) begin
    rst_ni  <= 1'b1;
    cycle_q <= cycle_q + 1'b1;
  end

  (* anyconst *) rc2_pkg::light_t light;
  logic [N*HomeW-1:0] home;
  logic [N-1:0] busy;
  rc2_grid_thesis u_grid (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .clear_i     (1'b0),
      .start_i     (cycle_q == 8'd1),
      .light_i     (light),
      .west_valid_i('0),
      .west_word_i ('0),
      .east_ready_i('1),
      .home_o      (home),
      .busy_o      (busy)
  );
  always_comb begin
    assume (light.fa != 0 && light.fa <= rc2_pkg::QueueW'(rc2_pkg::FAMAX));
    assume (light.distance != 0 && light.distance <= rc2_pkg::DistanceW'(rc2_pkg::LMAX));
    assume (light.xs < N && light.ys < N && light.zs < N);
  end

  logic [HomeW-1:0] targets, now, home_q;
  assign targets = HomeW'(24) * HomeW'(light.distance) * HomeW'(light.distance) + HomeW'(2);
  always_comb begin
    now = '0;
    for (int y = 0; y < N; y++) now = now + home[y*HomeW+:HomeW];
  end
  always_ff @(posedge clk_i) home_q <= !rst_ni ? '0 : home_q + now;
  always_comb begin
    if (rst_ni) begin
      assert (home_q <= targets);
      if (home_q == targets) assert (busy == 0 && now == 0);
      if (cycle_q == 8'(Cycles)) assert (home_q == targets);
    end
  end
endmodule
