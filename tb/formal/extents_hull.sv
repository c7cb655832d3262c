// SPDX-License-Identifier: Apache-2.0
//
// rc2_extents: the own column's extent runs from its lowest to its highest filled voxel; a quadrant's is
// the hull of the own column's and its two neighbours'; what light can meet is the hull of the quadrants
// away from it. `q` is any one quadrant.

module extents_hull (
    input logic                       clk_i,
    input logic                       clear_i,
    input logic                       fill_i,
    input logic [rc2_pkg::CoordW-1:0] fill_z_i,
    input logic [rc2_pkg::ReachW-1:0] ne_e_i,
    input logic [rc2_pkg::ReachW-1:0] ne_n_i,
    input logic [rc2_pkg::ReachW-1:0] nw_w_i,
    input logic [rc2_pkg::ReachW-1:0] nw_n_i,
    input logic [rc2_pkg::ReachW-1:0] sw_w_i,
    input logic [rc2_pkg::ReachW-1:0] sw_s_i,
    input logic [rc2_pkg::ReachW-1:0] se_e_i,
    input logic [rc2_pkg::ReachW-1:0] se_s_i,
    input logic                       east_i,
    input logic                       west_i,
    input logic                       north_i,
    input logic                       south_i
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned ReachW = rc2_pkg::ReachW;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  logic [ReachW-1:0] ne, nw, sw, se;
  logic [CoordW-1:0] min, max;
  rc2_extents u_extents (
      .clk_i   (clk_i),
      .rst_ni  (rst_ni),
      .clear_i (clear_i),
      .fill_i  (fill_i),
      .fill_z_i(fill_z_i),
      .ne_e_i  (ne_e_i),
      .ne_n_i  (ne_n_i),
      .nw_w_i  (nw_w_i),
      .nw_n_i  (nw_n_i),
      .sw_w_i  (sw_w_i),
      .sw_s_i  (sw_s_i),
      .se_e_i  (se_e_i),
      .se_s_i  (se_s_i),
      .ne_o    (ne),
      .nw_o    (nw),
      .sw_o    (sw),
      .se_o    (se),
      .east_i  (east_i),
      .west_i  (west_i),
      .north_i (north_i),
      .south_i (south_i),
      .min_o   (min),
      .max_o   (max)
  );
  // The neighbours' extents only grow until the next clear, as this one's does.
  logic grows_q = 1'b0;
  logic [ReachW-1:0] before_e_q, before_n_q;
  always_ff @(posedge clk_i) begin
    grows_q    <= rst_ni && !clear_i;
    before_e_q <= ne_e_i;
    before_n_q <= ne_n_i;
  end
  always_comb begin
    assume (!(east_i && west_i) && !(north_i && south_i));
    assume (fill_z_i <= CoordW'(N - 1));
    if (grows_q) begin
      assume (ne_e_i[ReachW-1:CoordW] >= before_e_q[ReachW-1:CoordW] && ne_e_i[CoordW-1:0] <= before_e_q[CoordW-1:0]);
      assume (ne_n_i[ReachW-1:CoordW] >= before_n_q[ReachW-1:CoordW] && ne_n_i[CoordW-1:0] <= before_n_q[CoordW-1:0]);
    end else begin
      assume (ne_e_i == rc2_pkg::NoReach && ne_n_i == rc2_pkg::NoReach);
    end
  end

  // ---- The own column ------------------------------------------------------------------------------
  (* hierconn *) wire [CoordW-1:0] \u_extents.min_q ;
  (* hierconn *) wire [CoordW-1:0] \u_extents.max_q ;
  logic [CoordW-1:0] own_min, own_max;
  assign own_min = \u_extents.min_q ;
  assign own_max = \u_extents.max_q ;
  logic [N-1:0] filled_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) filled_q <= '0;
    else if (fill_i) filled_q[fill_z_i] <= 1'b1;
  end
  always_comb begin
    if (rst_ni) begin
      if (filled_q == 0) assert ({own_max, own_min} == rc2_pkg::NoReach);
      else assert (filled_q[own_min] && filled_q[own_max]);
      for (int z = 0; z < N; z++) begin
        if (filled_q[z]) assert (own_min <= CoordW'(z) && CoordW'(z) <= own_max);
      end
    end
  end

  // ---- Any one quadrant: 0 ne, 1 nw, 2 sw, 3 se ----------------------------------------------------
  (* anyconst *) logic [1:0] q;
  logic [ReachW-1:0] along_x, along_y, reach;
  assign along_x = (q == 2'd0) ? ne_e_i : (q == 2'd1) ? nw_w_i : (q == 2'd2) ? sw_w_i : se_e_i;
  assign along_y = (q == 2'd0) ? ne_n_i : (q == 2'd1) ? nw_n_i : (q == 2'd2) ? sw_s_i : se_s_i;
  assign reach = (q == 2'd0) ? ne : (q == 2'd1) ? nw : (q == 2'd2) ? sw : se;

  logic known_q = 1'b0;
  logic [CoordW-1:0] x_min_q, x_max_q, y_min_q, y_max_q, own_min_q, own_max_q, reach_min, reach_max;
  always_ff @(posedge clk_i) begin
    known_q                <= rst_ni && !clear_i;
    {x_max_q, x_min_q}     <= along_x;
    {y_max_q, y_min_q}     <= along_y;
    {own_max_q, own_min_q} <= {own_max, own_min};
  end
  assign {reach_max, reach_min} = reach;
  always_comb begin
    if (known_q) begin
      assert (reach_min <= x_min_q && reach_min <= y_min_q && reach_min <= own_min_q);
      assert (reach_min == x_min_q || reach_min == y_min_q || reach_min == own_min_q);
      assert (reach_max >= x_max_q && reach_max >= y_max_q && reach_max >= own_max_q);
      assert (reach_max == x_max_q || reach_max == y_max_q || reach_max == own_max_q);
    end
  end

  // ---- What light can meet: the quadrants that do not lie back towards it ----------------------------
  logic [3:0] away;
  assign away = {!west_i && !north_i, !east_i && !north_i, !east_i && !south_i, !west_i && !south_i};
  logic away_q;
  logic [3:0] all_away_q;
  logic [4*ReachW-1:0] all_q;
  logic [ReachW-1:0] quadrant_q;
  logic asked_q = 1'b0;
  always_ff @(posedge clk_i) begin
    asked_q    <= 1'b1;
    away_q     <= away[q];
    all_away_q <= away;
    all_q      <= {se, sw, nw, ne};
    quadrant_q <= reach;
  end
  logic [3:0] is_min, is_max;
  for (genvar i = 0; i < 4; i++) begin : g_ends
    assign is_min[i] = all_away_q[i] && all_q[i*ReachW+:CoordW] == min;
    assign is_max[i] = all_away_q[i] && all_q[i*ReachW+CoordW+:CoordW] == max;
  end
  always_comb begin
    if (asked_q) begin
      if (away_q) assert (min <= quadrant_q[CoordW-1:0] && max >= quadrant_q[ReachW-1:CoordW]);
      assert (is_min != 0 && is_max != 0);
    end
  end
endmodule
