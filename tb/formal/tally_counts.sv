// SPDX-License-Identifier: Apache-2.0
//
// rc2_tally passes on every target that is done, once: what comes home in a cell plus what ended in it is
// what has left it, but for what is under way in its two registers. So the root never has more than has
// ended, and 24*L*L + 2 only when all have. Sums are exact modulo 2^HomeW, more than all targets.

module tally_counts (
    input logic                        clk_i,
    input logic                        served_i,
    input logic [rc2_pkg::ExtentW-1:0] served_u_i,
    input logic [rc2_pkg::ExtentW-1:0] served_v_i,
    input logic [rc2_pkg::ExtentW-1:0] kept_u_i,
    input logic [rc2_pkg::ExtentW-1:0] kept_v_i,
    input logic [  rc2_pkg::HomeW-1:0] home_i
);
  localparam int unsigned HomeW = rc2_pkg::HomeW;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  logic [HomeW-1:0] area, home;
  logic busy;
  rc2_tally u_tally (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .served_i  (served_i),
      .served_u_i(served_u_i),
      .served_v_i(served_v_i),
      .kept_u_i  (kept_u_i),
      .kept_v_i  (kept_v_i),
      .area_o    (area),
      .home_i    (home_i),
      .home_o    (home),
      .busy_o    (busy)
  );
  always_comb begin
    assume (kept_u_i <= served_u_i && kept_v_i <= served_v_i);
    assume (HomeW'(served_u_i) <= HomeW'(2 * rc2_pkg::LMAX + 1) && HomeW'(served_v_i) <= HomeW'(2 * rc2_pkg::LMAX + 1));
  end

  logic [HomeW-1:0] served, ended, came_q, ended_q, left_q, late_q;
  assign served = HomeW'(served_u_i) * HomeW'(served_v_i);
  assign ended = served_i ? served - HomeW'(kept_u_i) * HomeW'(kept_v_i) : '0;
  logic served_q;
  logic [HomeW-1:0] area_q;
  always_ff @(posedge clk_i) begin
    came_q   <= !rst_ni ? '0 : came_q + home_i;
    ended_q  <= !rst_ni ? '0 : ended_q + ended;
    left_q   <= !rst_ni ? '0 : left_q + home;
    late_q   <= !rst_ni ? '0 : ended;
    served_q <= rst_ni && served_i;
    if (served_i) area_q <= served;
  end
  (* hierconn *) wire [HomeW-1:0] \u_tally.done ;
  always_comb begin
    if (rst_ni) begin
      assert (\u_tally.done == late_q && busy == served_q);
      if (served_q) assert (area == area_q);
      assert (left_q + home + late_q == came_q + ended_q);
    end
  end
endmodule
