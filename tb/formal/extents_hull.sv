// SPDX-License-Identifier: Apache-2.0
//
// rc2_extents: the own column's extent runs from its lowest to its highest filled voxel; a quadrant has
// something if the own column or a neighbour's quadrant has; once a cell knows its sector, its tilts hold
// those of each neighbour that light goes on to in the next ring, and of no wrong one: with the own
// column's they are the hull. `q` is any one quadrant, `d` any one direction, the light anywhere.

module extents_hull (
    input logic                       clk_i,
    input logic                       clear_i,
    input logic                       fill_i,
    input logic [rc2_pkg::CoordW-1:0] fill_z_i,
    input logic [1:0]                 e_i,
    input logic [1:0]                 n_i,
    input logic [1:0]                 w_i,
    input logic [1:0]                 s_i,
    input logic                       start_i,
    input logic                       active_i,
    input logic [8*rc2_pkg::ReachW-1:0] reaches_i
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned OffW = rc2_pkg::OffW;
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam int unsigned TiltW = rc2_pkg::TiltW;
  localparam int unsigned ReachW = rc2_pkg::ReachW;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  // A light lasts longer than two divisions, or the host needs the time to see that it is over; nothing is
  // loaded meanwhile.
  logic [4:0] since_q = '1;
  always_ff @(posedge clk_i) since_q <= start_i ? '0 : (since_q == '1) ? since_q : since_q + 1'b1;
  localparam int unsigned Steps = (rc2_pkg::TiltSizeW + 3) / 4;
  (* hierconn *) wire [$clog2(Steps + 1)-1:0] \u_extents.u_divide.left_q ;
  (* hierconn *) wire \u_extents.low_taken_q ;
  (* hierconn *) wire \u_extents.high_q ;
  (* hierconn *) wire \u_extents.own_q ;
  (* hierconn *) wire \u_extents.own_done_q ;
  (* hierconn *) wire \u_extents.known_q ;
  (* hierconn *) wire \u_extents.half_q ;
  logic [4:0] left;
  assign left = 5'(\u_extents.u_divide.left_q );
  always_comb begin
    if (rst_ni && since_q != '1) assume (!start_i);
    if (start_i || since_q != '1) assume (!fill_i && !clear_i);
    if (rst_ni) begin
      if (left != 0) assert (since_q + left == (\u_extents.high_q ? 5'(2 * Steps + 1) : 5'(Steps)));
      if (left != 0 || \u_extents.low_taken_q ) begin
        assert (\u_extents.own_q && !\u_extents.own_done_q && !\u_extents.known_q && !\u_extents.half_q );
      end
      if (\u_extents.low_taken_q ) assert (since_q == 5'(Steps) && left == 0 && !\u_extents.high_q );
    end
  end

  // ---- Where the cell is, seen from any light ------------------------------------------------------
  (* anyconst *) logic signed [OffW-1:0] dx;
  (* anyconst *) logic signed [OffW-1:0] dy;
  (* anyconst *) logic [CoordW-1:0] zs;
  logic [OffW-1:0] far_x, far_y;
  assign far_x = dx[OffW-1] ? $unsigned(-dx) : $unsigned(dx);
  assign far_y = dy[OffW-1] ? $unsigned(-dy) : $unsigned(dy);

  logic [3:0] quadrants;
  logic [ReachW-1:0] reach;
  logic beyond;
  logic [CoordW-1:0] first, last;
  rc2_extents u_extents (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .clear_i    (clear_i),
      .fill_i     (fill_i),
      .fill_z_i   (fill_z_i),
      .e_i        (e_i),
      .n_i        (n_i),
      .w_i        (w_i),
      .s_i        (s_i),
      .quadrants_o(quadrants),
      .start_i    (start_i),
      .active_i   (active_i),
      .zs_i       (zs),
      .distance_i (CountW'((far_x > far_y) ? far_x : far_y)),
      .east_i     (dx > 0),
      .west_i     (dx < 0),
      .north_i    (dy > 0),
      .south_i    (dy < 0),
      .wide_i     (far_x > far_y),
      .tall_i     (far_y > far_x),
      .reach0_i   (reaches_i[0*ReachW+:ReachW]),
      .reach1_i   (reaches_i[1*ReachW+:ReachW]),
      .reach2_i   (reaches_i[2*ReachW+:ReachW]),
      .reach3_i   (reaches_i[3*ReachW+:ReachW]),
      .reach4_i   (reaches_i[4*ReachW+:ReachW]),
      .reach5_i   (reaches_i[5*ReachW+:ReachW]),
      .reach6_i   (reaches_i[6*ReachW+:ReachW]),
      .reach7_i   (reaches_i[7*ReachW+:ReachW]),
      .reach_o    (reach),
      .beyond_o   (beyond),
      .min_o      (first),
      .max_o      (last)
  );

  // ---- The own column ------------------------------------------------------------------------------
  (* hierconn *) wire [CoordW-1:0] \u_extents.min_q ;
  (* hierconn *) wire [CoordW-1:0] \u_extents.max_q ;
  logic own;
  logic [CoordW-1:0] own_min, own_max;
  assign own = \u_extents.own_q ;
  assign own_min = \u_extents.min_q ;
  assign own_max = \u_extents.max_q ;
  logic [N-1:0] filled_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) filled_q <= '0;
    else if (fill_i) filled_q[fill_z_i] <= 1'b1;
  end
  always_comb begin
    assume (fill_z_i <= CoordW'(N - 1));
    if (rst_ni) begin
      assert (own == (filled_q != 0));
      if (own) assert (filled_q[own_min] && filled_q[own_max]);
      for (int z = 0; z < N; z++) begin
        if (filled_q[z]) assert (own_min <= CoordW'(z) && CoordW'(z) <= own_max);
      end
    end
  end

  // ---- Any one quadrant: 0 ne, 1 nw, 2 sw, 3 se ----------------------------------------------------
  (* anyconst *) logic [1:0] q;
  logic heard, heard_q, asked_q = 1'b0;
  assign heard = own || ((q == 2'd0) ? e_i[0] || n_i[0] : (q == 2'd1) ? w_i[0] || n_i[1] :
                         (q == 2'd2) ? w_i[1] || s_i[0] : e_i[1] || s_i[1]);
  always_ff @(posedge clk_i) begin
    asked_q <= rst_ni && !clear_i;
    heard_q <= heard;
  end
  always_comb if (asked_q) assert (quadrants[q] == heard_q);

  // ---- Any one neighbour ---------------------------------------------------------------------------
  // It counts if it is in the next ring and on no axis back towards the light.
  (* anyconst *) logic [2:0] d;
  logic signed [OffW:0] way_x, way_y, to_x, to_y;
  logic [OffW:0] size_x, size_y;
  logic back, next_ring;
  assign way_x = (d == 3'd0 || d == 3'd1 || d == 3'd7) ? 1 : (d == 3'd2 || d == 3'd6) ? 0 : -1;
  assign way_y = (d == 3'd1 || d == 3'd2 || d == 3'd3) ? 1 : (d == 3'd0 || d == 3'd4) ? 0 : -1;
  assign to_x = (OffW + 1)'(dx) + way_x;
  assign to_y = (OffW + 1)'(dy) + way_y;
  assign size_x = to_x[OffW] ? $unsigned(-to_x) : $unsigned(to_x);
  assign size_y = to_y[OffW] ? $unsigned(-to_y) : $unsigned(to_y);
  assign back = (way_x > 0 && dx < 0) || (way_x < 0 && dx > 0) || (way_y > 0 && dy < 0) || (way_y < 0 && dy > 0);
  assign next_ring = ((size_x > size_y) ? size_x : size_y) > (OffW + 1)'((far_x > far_y) ? far_x : far_y);

  // A neighbour that knows goes on to know the same, until the next light.
  logic [ReachW-1:0] said;
  logic [8*ReachW-1:0] said_q;
  logic follows_q = 1'b0;
  assign said = reaches_i[d*ReachW+:ReachW];
  always_ff @(posedge clk_i) begin
    said_q    <= reaches_i;
    follows_q <= rst_ni && !start_i;
  end
  for (genvar i = 0; i < 8; i++) begin : g_steady
    always_comb begin
      if (follows_q && said_q[i*ReachW+ReachW-1]) begin
        assume (reaches_i[i*ReachW+:ReachW] == said_q[i*ReachW+:ReachW]);
      end
    end
  end

  (* hierconn *) wire [TiltW-1:0] \u_extents.low_q ;
  (* hierconn *) wire [TiltW-1:0] \u_extents.high_tilt_q ;
  logic source, holds, ready_q = 1'b0;
  always_ff @(posedge clk_i) if (start_i && rst_ni) ready_q <= 1'b1;
  assign source = (dx == 0) && (dy == 0);
  assign holds = said[ReachW-1] && $signed(\u_extents.low_q ) <= $signed(said[TiltW-1:0]) &&
                 $signed(\u_extents.high_tilt_q ) >= $signed(said[2*TiltW-1:TiltW]);
  always_comb begin
    if (rst_ni && ready_q && follows_q) begin
      if (\u_extents.known_q && next_ring && !back && !(source && way_x == 0)) assert (holds);
      if (\u_extents.half_q && source && way_x > 0) assert (holds);
      if (\u_extents.known_q ) assert (!source || \u_extents.half_q );
    end
  end

  // Nothing else joins: both ends are the own column's, a counting neighbour's, or what was there.
  (* hierconn *) wire \u_extents.joins ;
  (* hierconn *) wire [TiltW-1:0] \u_extents.own_low ;
  (* hierconn *) wire [TiltW-1:0] \u_extents.own_high ;
  logic [7:0] is_low, is_high;
  for (genvar i = 0; i < 8; i++) begin : g_only
    localparam int X = (i == 0 || i == 1 || i == 7) ? 1 : (i == 2 || i == 6) ? 0 : -1;
    localparam int Y = (i == 1 || i == 2 || i == 3) ? 1 : (i == 0 || i == 4) ? 0 : -1;
    logic away;
    assign away = !((X > 0 && dx < 0) || (X < 0 && dx > 0) || (Y > 0 && dy < 0) || (Y < 0 && dy > 0));
    logic [TiltW-1:0] low_before_q, high_before_q;
    always_ff @(posedge clk_i) {high_before_q, low_before_q} <= reaches_i[i*ReachW+:2*TiltW];
    assign is_low[i] = away && \u_extents.low_q == low_before_q;
    assign is_high[i] = away && \u_extents.high_tilt_q == high_before_q;
  end
  logic joined_q = 1'b0;
  logic [TiltW-1:0] own_low_q, own_high_q;
  always_ff @(posedge clk_i) begin
    joined_q   <= rst_ni && \u_extents.joins ;
    own_low_q  <= \u_extents.own_low ;
    own_high_q <= \u_extents.own_high ;
  end
  always_comb begin
    if (joined_q) begin
      assert (is_low != 0 || \u_extents.low_q == own_low_q || \u_extents.low_q == rc2_pkg::TiltMost);
      assert (is_high != 0 || \u_extents.high_tilt_q == own_high_q || \u_extents.high_tilt_q == -rc2_pkg::TiltMost);
    end
  end
endmodule
