// SPDX-License-Identifier: Apache-2.0
//
// rc2_dexel offers exactly the voxels that every word of the packet allows: `z` is any one voxel of the
// box, and a word allows it where its integers say so, 0 <= c*z + d <= width or c*z + d >= 0, which is to
// be within the rational interval. So is the core. Packets, stalls and their number are arbitrary.
//
// Induction goes through because the division keeps numerator = quotient * divisor + rest, with the rest
// below the divisor moved up by the bits still to come, and lo .. hi changes only when a word leaves.

module dexel_interval (
    input logic                        clk_i,
    input logic                        valid_i,
    input logic [  rc2_pkg::KindW-1:0] kind_i,
    input logic [  rc2_pkg::RestW-1:0] rest_i,
    input logic                        take_i,
    input logic                        ready_i
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned CoefW = rc2_pkg::CoefW;
  localparam int unsigned DistW = rc2_pkg::DistW;
  localparam int unsigned WidthW = rc2_pkg::WidthW;
  localparam int unsigned SideW = rc2_pkg::SideW;
  localparam int unsigned PushW = rc2_pkg::PushW;
  localparam int unsigned NumW = DistW + 2;
  localparam int unsigned DivW = CoefW + CoordW;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  logic ready, valid;
  logic [CoordW-1:0] z0, lo, hi, core_lo, core_hi;
  rc2_dexel u_dexel (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .valid_i  (valid_i),
      .kind_i   (kind_i),
      .rest_i   (rest_i),
      .ready_o  (ready),
      .take_i   (take_i),
      .valid_o  (valid),
      .z0_o     (z0),
      .lo_o     (lo),
      .hi_o     (hi),
      .core_lo_o(core_lo),
      .core_hi_o(core_hi),
      .ready_i  (ready_i)
  );

  // ---- Any packets -----------------------------------------------------------------------------
  logic is_head, is_slab, is_side, is_gap;
  assign is_head = (kind_i == rc2_pkg::KindHead);
  assign is_slab = (kind_i == rc2_pkg::KindSlab);
  assign is_side = (kind_i == rc2_pkg::KindSide);
  assign is_gap = (kind_i == rc2_pkg::KindGap);
  logic [CoordW-1:0] head_span, head_z0;
  logic [WidthW-1:0] head_width;
  logic [rc2_pkg::LayerW-1:0] head_layer;
  logic [rc2_pkg::FacetW-1:0] head_facet;
  assign {head_layer, head_width, head_facet, head_span, head_z0} = rest_i[rc2_pkg::HeadRestW-1:0];

  logic seen_q, waits_q;  // a head has been taken; a word waits
  logic [rc2_pkg::KindW-1:0] kind_q;
  logic [rc2_pkg::RestW-1:0] rest_q;
  always_comb begin
    assume (is_head || is_slab || is_side || is_gap);
    assume (!valid_i || seen_q || is_head);
    assume (!take_i || (valid_i && ready));
    assume (!waits_q || (valid_i && kind_i == kind_q && rest_i == rest_q));
    assume (32'(head_z0) + 32'(head_span) < rc2_pkg::N || !is_head);
  end

  // ---- Any one voxel of the box ------------------------------------------------------------------
  (* anyconst *) logic [CoordW-1:0] z;
  logic [WidthW-1:0] width_q;
  logic [CoordW-1:0] span_q, z0_q;
  logic frontless_q, in_q, core_q;
  logic signed [CoefW-1:0] c;
  logic signed [NumW+1:0] value, reach;
  assign c = is_slab ? $signed(rest_i[DistW+CoefW-1:DistW]) :
                       $signed({{(CoefW - SideW) {rest_i[DistW+SideW-1]}}, rest_i[DistW+SideW-1:DistW]});
  assign value = (NumW + 2)'(c) * $signed((NumW + 2)'(z)) + (NumW + 2)'($signed(rest_i[DistW-1:0]));
  assign reach = is_slab ? $signed((NumW + 2)'(width_q)) : $signed((NumW + 2)'(rest_i[DistW+SideW+:PushW]));
  logic allowed, allowed_core;
  assign allowed = (value >= 0) && (!is_slab || frontless_q || value <= reach);
  assign allowed_core = is_slab || (value >= reach);

  always_ff @(posedge clk_i) begin
    waits_q <= rst_ni && valid_i && !take_i;
    kind_q  <= kind_i;
    rest_q  <= rest_i;
    if (!rst_ni) seen_q <= 1'b0;
    else if (take_i) seen_q <= 1'b1;
    if (take_i && is_head) begin
      width_q     <= head_width;
      span_q      <= head_span;
      z0_q        <= head_z0;
      frontless_q <= (head_layer == rc2_pkg::LayerInside);
      in_q        <= (z <= head_span);
      core_q      <= (z <= head_span);
    end else if (take_i && (is_slab || is_side)) begin
      in_q   <= in_q && allowed;
      core_q <= core_q && allowed_core;
    end
  end
  logic nothing;
  assign nothing = (lo > hi);
  always_comb begin
    if (rst_ni && valid) begin
      assert (in_q == (lo <= z && z <= hi));
      assert (core_q == (core_lo <= z && z <= core_hi));
    end
    if (rst_ni && valid_i && is_gap && !valid) assert (!in_q);
  end

  // ---- What makes it inductive -------------------------------------------------------------------
  (* hierconn *) wire [CoordW:0] \u_dexel.top_q ;
  (* hierconn *) wire [WidthW-1:0] \u_dexel.width_q ;
  (* hierconn *) wire [rc2_pkg::LayerW-1:0] \u_dexel.layer_q ;
  (* hierconn *) wire \u_dexel.dividing_q , \u_dexel.wanted_a_q , \u_dexel.wanted_b_q ;
  (* hierconn *) wire \u_dexel.divides , \u_dexel.divides_a , \u_dexel.divides_b , \u_dexel.empties_core ;
  (* hierconn *) wire [NumW-1:0] \u_dexel.rem_a_q , \u_dexel.rem_b_q , \u_dexel.num_a , \u_dexel.num_b ;
  (* hierconn *) wire [DivW-1:0] \u_dexel.div_q ;
  (* hierconn *) wire [CoefW-1:0] \u_dexel.divisor ;
  (* hierconn *) wire [CoordW-1:0] \u_dexel.bit_q , \u_dexel.quo_a_q , \u_dexel.quo_b_q ;
  localparam int unsigned WideW = NumW + DivW + 2;
  logic [WideW-1:0] divisor, moved;  // moved up by the bits to come, the present one included
  logic [CoordW:0] top, later;
  logic dividing;
  assign divisor = WideW'(\u_dexel.divisor );
  assign moved = WideW'(\u_dexel.div_q ) << 1;
  assign top = \u_dexel.top_q ;
  assign later = {\u_dexel.bit_q , 1'b0} - 1'b1;
  assign dividing = rst_ni && \u_dexel.dividing_q ;
  always_comb begin
    if (rst_ni && seen_q) begin
      assert (top != 0 && (top & (top - 1'b1)) == 0 && (CoordW + 1)'(span_q) < top);
      assert (\u_dexel.width_q == width_q && (\u_dexel.layer_q == rc2_pkg::LayerInside) == frontless_q);
      assert (z0 == z0_q && 32'(z0_q) + 32'(span_q) < rc2_pkg::N);
      if (nothing) assert (!in_q);
      else begin
        assert (hi <= span_q);
        assert (in_q == (lo <= z && z <= hi));
        if (core_lo > core_hi) assert (!core_q || (dividing && \u_dexel.empties_core && !allowed_core));
        else assert (core_hi <= span_q && core_q == (core_lo <= z && z <= core_hi));
      end
    end
    if (dividing) begin
      assert (seen_q && waits_q && (is_slab || is_side) && !nothing && \u_dexel.divides );
      assert (!\u_dexel.empties_core || core_lo > core_hi);
      assert (\u_dexel.bit_q != 0 && (\u_dexel.bit_q & (\u_dexel.bit_q - 1'b1)) == 0);
      assert ((CoordW + 1)'(\u_dexel.bit_q ) < top);
      assert (WideW'(\u_dexel.div_q ) == divisor * WideW'(\u_dexel.bit_q ));
      assert (\u_dexel.wanted_a_q == \u_dexel.divides_a && \u_dexel.wanted_b_q == \u_dexel.divides_b );
      if (\u_dexel.wanted_a_q ) begin
        assert (({1'b0, \u_dexel.quo_a_q } & later) == 0);
        assert (WideW'(\u_dexel.quo_a_q ) * divisor + WideW'(\u_dexel.rem_a_q ) == WideW'(\u_dexel.num_a ));
        assert (WideW'(\u_dexel.rem_a_q ) < moved);
      end
      if (\u_dexel.wanted_b_q ) begin
        assert (({1'b0, \u_dexel.quo_b_q } & later) == 0);
        assert (WideW'(\u_dexel.quo_b_q ) * divisor + WideW'(\u_dexel.rem_b_q ) == WideW'(\u_dexel.num_b ));
        assert (WideW'(\u_dexel.rem_b_q ) < moved);
      end
    end
  end
endmodule
