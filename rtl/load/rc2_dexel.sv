// SPDX-License-Identifier: Apache-2.0
//
// Dexel unit (thesis 3.9; the thesis's "dixel"): from the bounds of one facet at one column to the
// interval of z that the facet fills. HEAD opens the box's z range; each BOUND c*z + d >= 0 (T and
// U of the slab, Ti of a side) narrows it from below (c > 0: z >= ceil(-d/c)), from above (c < 0:
// z <= floor(d/-c)) or keeps or empties it (c = 0). z counts from the box's low corner.
//
// No divider: a quotient that falls outside the range is recognised first (one comparison each
// side); what is left has only as many bits as the range, found by compare and subtract, one per
// cycle. A bound takes one cycle, or 1 + bits(range) when it must be divided; the dexel, if any,
// is offered in the cycle after its last bound is settled.

module rc2_dexel (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    // HEAD and BOUND words of packets that cover this column
    input  logic                              valid_i,
    input  logic [rc2_pkg::KindW-1:0]         kind_i,
    input  logic                              last_i,
    input  logic [rc2_pkg::RestW-1:0]         rest_i,
    output logic                              ready_o,
    // the dexel: facet fills lo..hi
    output logic                              valid_o,
    output logic [rc2_pkg::FacetW-1:0]        facet_o,
    output logic [rc2_pkg::CoordW-1:0]        lo_o,
    output logic [rc2_pkg::CoordW-1:0]        hi_o,
    input  logic                              ready_i,
    output logic                              busy_o
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned CoefW = rc2_pkg::CoefW;
  localparam int unsigned DistW = rc2_pkg::DistW;
  // |d| + |c| fits in DistW bits without sign (|c| needs CoefW-1 < DistW-1); one bit of sign.
  localparam int unsigned NumW = DistW + 1;
  // A divisor moved up by the range's bits.
  localparam int unsigned DivW = CoefW + CoordW;
  localparam int unsigned CmpW = (NumW > DivW) ? NumW : DivW;

  // ---- The packet's box ----------------------------------------------------------------------
  logic [rc2_pkg::FacetW-1:0] facet_q;
  logic [CoordW-1:0] z0_q, lo_q, hi_q;
  logic [CoordW:0] top_q;  // one-hot: 2^bits(range), the first quotient surely above the range
  logic empty_q, settle_q;

  logic [rc2_pkg::FacetW-1:0] head_facet;
  logic [CoordW-1:0] head_span, head_z0;
  assign {head_facet, head_span, head_z0} = rest_i[rc2_pkg::HeadRestW-1:0];

  logic [CoordW:0] head_top;
  assign head_top[0] = (head_span == 0);
  for (genvar i = 0; i < CoordW; i++) begin : g_top
    assign head_top[i+1] = head_span[i] && ((head_span >> (i + 1)) == 0);
  end

  // ---- A bound -------------------------------------------------------------------------------
  logic signed [CoefW-1:0] c;
  logic signed [DistW-1:0] d;
  assign c = $signed(rest_i[DistW+CoefW-1:DistW]);
  assign d = $signed(rest_i[DistW-1:0]);

  logic flat, lower;
  assign flat  = (c == 0);
  assign lower = !c[CoefW-1];

  logic [CoefW-1:0] divisor;
  logic signed [NumW-1:0] d_wide, c_wide, numerator;
  assign divisor = lower ? $unsigned(c) : $unsigned(-c);
  assign d_wide = {d[DistW-1], d};
  assign c_wide = {{(NumW - CoefW) {c[CoefW-1]}}, c};
  assign numerator = lower ? c_wide - 1'b1 - d_wide : d_wide;  // floor(numerator/divisor)

  // divisor * 2^bits(range), by the one-hot top_q.
  logic [DivW-1:0] divisor_top;
  always_comb begin
    divisor_top = '0;
    for (int i = 0; i <= CoordW; i++) begin
      if (top_q[i]) divisor_top = {{CoordW{1'b0}}, divisor} << i;
    end
  end

  logic below, above, bound_empties, bound_divides;
  assign below = numerator[NumW-1];
  assign above = !below && ({{(CmpW - NumW) {1'b0}}, $unsigned(numerator)} >=
                            {{(CmpW - DivW) {1'b0}}, divisor_top});
  assign bound_empties = flat ? d[DistW-1] : (lower ? above : below);
  assign bound_divides = !flat && !below && !above && !top_q[0] && !empty_q;

  // ---- Division by compare and subtract --------------------------------------------------------
  logic dividing_q, lower_q, last_q;
  logic [NumW-1:0] rem_q;
  logic [DivW-1:0] div_q;
  logic [CoordW-1:0] bit_q, quo_q;

  logic step_fits;
  logic [CoordW-1:0] quo;
  assign step_fits = ({{(CmpW - NumW) {1'b0}}, rem_q} >= {{(CmpW - DivW) {1'b0}}, div_q});
  assign quo = quo_q | (step_fits ? bit_q : '0);

  // ---- Handshakes ------------------------------------------------------------------------------
  logic nothing, settled, take_head, take_bound;
  assign nothing = empty_q || (lo_q > hi_q);
  assign settled = settle_q && (nothing || ready_i);
  assign valid_o = settle_q && !nothing;
  assign facet_o = facet_q;
  assign lo_o = z0_q + lo_q;
  assign hi_o = z0_q + hi_q;
  assign busy_o = dividing_q || settle_q;

  assign ready_o = !dividing_q && (!settle_q || settled);
  assign take_head = valid_i && ready_o && (kind_i == rc2_pkg::KindHead);
  assign take_bound = valid_i && ready_o && (kind_i == rc2_pkg::KindBound);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      settle_q   <= 1'b0;
      dividing_q <= 1'b0;
      empty_q    <= 1'b1;
    end else begin
      if (settled) settle_q <= 1'b0;
      if (take_head) empty_q <= 1'b0;
      if (take_bound) begin
        if (bound_empties) empty_q <= 1'b1;
        if (bound_divides) dividing_q <= 1'b1;
        else settle_q <= last_i;
      end
      if (dividing_q && bit_q[0]) begin
        dividing_q <= 1'b0;
        settle_q   <= last_q;
      end
    end

    if (take_head) begin
      facet_q <= head_facet;
      z0_q    <= head_z0;
      lo_q    <= '0;
      hi_q    <= head_span;
      top_q   <= head_top;
    end
    if (take_bound && bound_divides) begin
      lower_q <= lower;
      last_q  <= last_i;
      rem_q   <= $unsigned(numerator);
      div_q   <= divisor_top >> 1;
      bit_q   <= top_q[CoordW:1];
      quo_q   <= '0;
    end
    if (dividing_q) begin
      if (step_fits) rem_q <= rem_q - NumW'(div_q);
      div_q <= div_q >> 1;
      bit_q <= bit_q >> 1;
      quo_q <= quo;
      if (bit_q[0]) begin
        if (lower_q && quo > lo_q) lo_q <= quo;
        if (!lower_q && quo < hi_q) hi_q <= quo;
      end
    end
  end

  // Contract: the division never meets a quotient beyond its bits; an offered dexel lies in the
  // grid and stays until it is taken.
  logic offered_q;
  always_ff @(posedge clk_i) begin
    offered_q <= rst_ni && valid_o && !ready_i;
    if (rst_ni) begin
      assert (!dividing_q || bit_q != 0);
      assert (!offered_q || valid_o);
      assert (!valid_o || (lo_o <= hi_o && 32'(hi_o) < rc2_pkg::N));
      assert (!valid_i || kind_i == rc2_pkg::KindHead || kind_i == rc2_pkg::KindBound);
    end
  end
endmodule
