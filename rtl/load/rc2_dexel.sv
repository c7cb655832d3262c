// SPDX-License-Identifier: Apache-2.0
//
// Dexel unit (thesis 3.9; the thesis's "dixel"): from the slab and the sides of one facet at one
// column to the interval of z that the facet fills, and to the part of it that is its core. HEAD
// opens the box's z range. SLAB and SIDE words have two bounds each, c*z + e >= 0, that narrow an
// interval from below (c > 0: z >= ceil(-e/c)), from above (c < 0: z <= floor(e/-c)), or keep or
// empty it (c = 0):
//   SLAB  back  c*z + d >= 0 and front -c*z + width - d >= 0, both of the facet (T and U)
// (a packet of the layer "inside" has no front)
//   SIDE  c*z + d >= 0 of the facet (Ti), c*z + d - push >= 0 of its core
// GAP ends the packet: the unit offers what is left. z counts from the box's low corner.
//
// No divider: a quotient that falls outside the range is recognised first (one comparison each
// side); what is left has only as many bits as the range, found by compare and subtract, one per
// cycle and both bounds at once. A word waits in its stage meanwhile: one cycle, or 1 + bits(range)
// when a bound must be divided, or until the fill unit takes the dexel.

module rc2_dexel (
    input  logic                      clk_i,
    input  logic                      rst_ni,
    // HEAD, SLAB, SIDE and GAP words of packets that cover this column
    input  logic                      valid_i,       // a word waits
    input  logic [rc2_pkg::KindW-1:0] kind_i,
    input  logic [rc2_pkg::RestW-1:0] rest_i,
    output logic                      ready_o,       // it may leave at the end of this cycle
    input  logic                      take_i,        // it does
    // the dexel that a GAP offers: voxels z0+lo .. z0+hi, core z0+core_lo .. z0+core_hi
    output logic                      valid_o,
    output logic [rc2_pkg::FacetW-1:0] facet_o,
    output logic [rc2_pkg::LayerW-1:0] layer_o,
    output logic [rc2_pkg::CoordW-1:0] z0_o,
    output logic [rc2_pkg::CoordW-1:0] lo_o,
    output logic [rc2_pkg::CoordW-1:0] hi_o,
    output logic [rc2_pkg::CoordW-1:0] core_lo_o,
    output logic [rc2_pkg::CoordW-1:0] core_hi_o,
    input  logic                      ready_i
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned CoefW = rc2_pkg::CoefW;
  localparam int unsigned DistW = rc2_pkg::DistW;
  localparam int unsigned WidthW = rc2_pkg::WidthW;
  localparam int unsigned SideW = rc2_pkg::SideW;
  localparam int unsigned PushW = rc2_pkg::PushW;
  // |d| + reach + |c|, each below 2^DistW, and a sign.
  localparam int unsigned NumW = DistW + 2;
  // A divisor moved up by the range's bits.
  localparam int unsigned DivW = CoefW + CoordW;
  localparam int unsigned CmpW = (NumW > DivW) ? NumW : DivW;

  // ---- The packet's box ----------------------------------------------------------------------
  logic [rc2_pkg::FacetW-1:0] facet_q;
  logic [rc2_pkg::LayerW-1:0] layer_q;
  logic [WidthW-1:0] width_q;
  logic [CoordW-1:0] z0_q, lo_q, hi_q, core_lo_q, core_hi_q;
  logic [CoordW:0] top_q;  // one-hot: 2^bits(range), the first quotient surely above the range

  logic [rc2_pkg::LayerW-1:0] head_layer;
  logic [WidthW-1:0] head_width;
  logic [rc2_pkg::FacetW-1:0] head_facet;
  logic [CoordW-1:0] head_span, head_z0;
  assign {head_layer, head_width, head_facet, head_span, head_z0} = rest_i[rc2_pkg::HeadRestW-1:0];

  logic [CoordW:0] head_top;
  assign head_top[0] = (head_span == 0);
  for (genvar i = 0; i < CoordW; i++) begin : g_top
    assign head_top[i+1] = head_span[i] && ((head_span >> (i + 1)) == 0);
  end

  logic is_head, is_slab, is_side, is_gap, nothing, no_core;
  assign is_head = (kind_i == rc2_pkg::KindHead);
  assign is_slab = (kind_i == rc2_pkg::KindSlab);
  assign is_side = (kind_i == rc2_pkg::KindSide);
  assign is_gap = (kind_i == rc2_pkg::KindGap);
  assign nothing = (lo_q > hi_q);
  assign no_core = (core_lo_q > core_hi_q);

  // ---- The word's bounds: a, and b with e = d - reach or its opposite --------------------------
  logic signed [CoefW-1:0] c;
  logic signed [DistW-1:0] d;
  logic [WidthW-1:0] reach;
  assign d = $signed(rest_i[DistW-1:0]);
  assign c = is_slab ? $signed(rest_i[DistW+CoefW-1:DistW])
                     : $signed({{(CoefW - SideW) {rest_i[DistW+SideW-1]}}, rest_i[DistW+SideW-1:DistW]});
  assign reach = is_slab ? width_q : WidthW'(rest_i[DistW+SideW+PushW-1:DistW+SideW]);

  logic flat, lower_a, lower_b;
  assign flat = (c == 0);
  assign lower_a = !c[CoefW-1];
  assign lower_b = lower_a ^ is_slab;

  logic [CoefW-1:0] divisor;
  logic signed [NumW-1:0] e_a, beyond, e_b, divisor_less, num_a, num_b;
  assign divisor = c[CoefW-1] ? $unsigned(-c) : $unsigned(c);
  assign e_a = {{(NumW - DistW) {d[DistW-1]}}, d};
  assign beyond = e_a - $signed({{(NumW - WidthW) {1'b0}}, reach});
  assign e_b = is_slab ? -beyond : beyond;
  assign divisor_less = $signed({{(NumW - CoefW) {1'b0}}, divisor}) - 1'b1;
  assign num_a = lower_a ? divisor_less - e_a : e_a;  // floor(num/divisor) bounds z
  assign num_b = lower_b ? divisor_less - e_b : e_b;

  // divisor * 2^bits(range), by the one-hot top_q.
  logic [DivW-1:0] divisor_top;
  always_comb begin
    divisor_top = '0;
    for (int i = 0; i <= CoordW; i++) begin
      if (top_q[i]) divisor_top = {{CoordW{1'b0}}, divisor} << i;
    end
  end

  logic [CmpW-1:0] limit;
  logic frontless;
  assign frontless = is_slab && (layer_q == rc2_pkg::LayerInside);

  logic below_a, below_b, above_a, above_b, fails_a, fails_b, divides_a, divides_b;
  assign limit = {{(CmpW - DivW) {1'b0}}, divisor_top};
  assign below_a = num_a[NumW-1];
  assign below_b = num_b[NumW-1];
  assign above_a = !below_a && ({{(CmpW - NumW) {1'b0}}, $unsigned(num_a)} >= limit);
  assign above_b = !below_b && ({{(CmpW - NumW) {1'b0}}, $unsigned(num_b)} >= limit);
  assign fails_a = flat ? e_a[NumW-1] : (lower_a ? above_a : below_a);
  assign fails_b = flat ? e_b[NumW-1] : (lower_b ? above_b : below_b);
  assign divides_a = !flat && !below_a && !above_a && !top_q[0];
  assign divides_b = !flat && !below_b && !above_b && !top_q[0] && !(is_side && no_core) && !frontless;

  logic empties, empties_core, divides;
  assign empties = fails_a || (is_slab && fails_b && !frontless);
  assign empties_core = is_side && fails_b;
  assign divides = !empties && (divides_a || divides_b);

  // ---- Division by compare and subtract --------------------------------------------------------
  logic dividing_q, wanted_a_q, wanted_b_q;
  logic [NumW-1:0] rem_a_q, rem_b_q;
  logic [DivW-1:0] div_q;
  logic [CoordW-1:0] bit_q, quo_a_q, quo_b_q;

  logic fits_a, fits_b;
  logic [CoordW-1:0] quo_a, quo_b;
  assign fits_a = ({{(CmpW - NumW) {1'b0}}, rem_a_q} >= {{(CmpW - DivW) {1'b0}}, div_q});
  assign fits_b = ({{(CmpW - NumW) {1'b0}}, rem_b_q} >= {{(CmpW - DivW) {1'b0}}, div_q});
  assign quo_a = quo_a_q | (fits_a ? bit_q : '0);
  assign quo_b = quo_b_q | (fits_b ? bit_q : '0);

  // ---- Handshakes ------------------------------------------------------------------------------
  logic bound, work, begins, ends, narrow_a, narrow_b;
  assign bound = is_slab || is_side;
  assign ready_o = is_head || nothing ||
                   (is_gap ? ready_i : (dividing_q ? bit_q[0] : !divides));
  assign valid_o = valid_i && is_gap && !nothing;
  assign facet_o = facet_q;
  assign layer_o = layer_q;
  assign z0_o = z0_q;
  assign lo_o = lo_q;
  assign hi_o = hi_q;
  assign core_lo_o = core_lo_q;
  assign core_hi_o = core_hi_q;

  // The last step of a word waits until the word can leave.
  assign work = valid_i && bound && !nothing && (take_i || !ready_o);
  assign begins = work && !dividing_q;
  assign ends = work && dividing_q && bit_q[0];
  assign narrow_a = ends && wanted_a_q;
  assign narrow_b = ends && wanted_b_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) dividing_q <= 1'b0;
    else if (begins) dividing_q <= divides;
    else if (ends) dividing_q <= 1'b0;

    if (valid_i && is_head && take_i) begin
      facet_q   <= head_facet;
      layer_q   <= head_layer;
      width_q   <= head_width;
      z0_q      <= head_z0;
      lo_q      <= '0;
      hi_q      <= head_span;
      core_lo_q <= '0;
      core_hi_q <= head_span;
      top_q     <= head_top;
    end
    // An empty interval is 1..0.
    if (begins && empties) begin
      lo_q <= CoordW'(1);
      hi_q <= '0;
    end
    if (begins && empties_core) begin
      core_lo_q <= CoordW'(1);
      core_hi_q <= '0;
    end
    if (begins) begin
      wanted_a_q <= divides_a;
      wanted_b_q <= divides_b;
      rem_a_q    <= $unsigned(num_a);
      rem_b_q    <= $unsigned(num_b);
      quo_a_q    <= '0;
      quo_b_q    <= '0;
      div_q      <= divisor_top >> 1;
      bit_q      <= top_q[CoordW:1];
    end
    if (work && dividing_q) begin
      if (fits_a) rem_a_q <= rem_a_q - NumW'(div_q);
      if (fits_b) rem_b_q <= rem_b_q - NumW'(div_q);
      quo_a_q <= quo_a;
      quo_b_q <= quo_b;
      div_q   <= div_q >> 1;
      bit_q   <= bit_q >> 1;
    end
    if (narrow_a && lower_a && quo_a > lo_q) lo_q <= quo_a;
    if (narrow_a && !lower_a && quo_a < hi_q) hi_q <= quo_a;
    if (narrow_b && is_slab && lower_b && quo_b > lo_q) lo_q <= quo_b;
    if (narrow_b && is_slab && !lower_b && quo_b < hi_q) hi_q <= quo_b;
    if (narrow_b && is_side && lower_b && quo_b > core_lo_q) core_lo_q <= quo_b;
    if (narrow_b && is_side && !lower_b && quo_b < core_hi_q) core_hi_q <= quo_b;
  end

  // Contract: a word that waits does not change; the division never meets a quotient beyond its
  // bits; an offered dexel lies in the grid.
  logic waiting_q;
  logic [rc2_pkg::KindW-1:0] kind_q;
  logic [rc2_pkg::RestW-1:0] rest_q;
  always_ff @(posedge clk_i) begin
    waiting_q <= rst_ni && valid_i && !take_i;
    kind_q    <= kind_i;
    rest_q    <= rest_i;
    if (rst_ni) begin
      assert (!waiting_q || (valid_i && kind_i == kind_q && rest_i == rest_q));
      assert (!take_i || (valid_i && ready_o));
      assert (!dividing_q || (bit_q != 0 && !nothing && bound));
      assert (!valid_o || (lo_o <= hi_o && 32'(z0_o) + 32'(hi_o) < rc2_pkg::N));
      assert (!valid_i || is_head || bound || is_gap);
    end
  end
endmodule
