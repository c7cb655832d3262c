// SPDX-License-Identifier: Apache-2.0
//
// One stage of a pipe that walks facet packets past a line of units (thesis 3.9): the vertical
// pipe feeds rows, a row pipe feeds cells. A packet's HEAD says how many units to skip and how
// many to serve; the value of each other word is stepped by its coefficient from one served unit to
// the next (the thesis's T-A, Ti-Ai, T-B, Ti-Bi). Units outside the box never see the packet.
//
// A word waits at least one cycle in the stage's buffer of two; one word per cycle.
// READ and END go to the unit and on to the next stage; DATA only goes on. RAY words follow a HEAD and
// go where it went, as they are.

module rc2_facet_stage #(
    parameter int unsigned PayloadW = rc2_pkg::RowPayloadW,
    parameter int unsigned Stride = 1,  // units from this one to the next; a power of two
    localparam int unsigned WordW = rc2_pkg::KindW + PayloadW,
    localparam int unsigned UnitPayloadW = PayloadW - rc2_pkg::LeadW,
    localparam int unsigned UnitWordW = rc2_pkg::KindW + UnitPayloadW
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    // from the stage before
    input  logic                 valid_i,
    input  logic [    WordW-1:0] word_i,
    output logic                 ready_o,
    // to the unit beside
    output logic                 unit_waits_o,  // a word for it waits, even if it cannot leave
    output logic                 unit_valid_o,
    output logic [UnitWordW-1:0] unit_word_o,
    output logic [rc2_pkg::LeadW-1:0] unit_lead_o,
    input  logic                 unit_ready_i,
    // to the stage after
    output logic                 next_valid_o,
    output logic [    WordW-1:0] next_word_o,
    input  logic                 next_ready_i,
    output logic                 busy_o
);
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam int unsigned LeadW = rc2_pkg::LeadW;
  localparam int unsigned DistW = rc2_pkg::DistW;

  // ---- Buffer ------------------------------------------------------------------------------
  logic [1:0] held;
  logic [WordW-1:0] word;
  logic fire;

  assign ready_o = (held != 2'd2);
  assign busy_o  = (held != 2'd0);

  rc2_fifo #(
      .Width(WordW),
      .Depth(2)
  ) u_buffer (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .push_i (valid_i && ready_o),
      .data_i (word_i),
      .pop_i  (fire),
      .data_o (word),
      .count_o(held)
  );

  // ---- Where the word goes -------------------------------------------------------------------
  logic [rc2_pkg::KindW-1:0] kind;
  logic [LeadW-1:0] lead;
  logic [UnitPayloadW-1:0] rest;
  assign {kind, lead, rest} = word;

  logic [CountW-1:0] skip, take;
  assign {take, skip} = lead[2*CountW-1:0];

  logic here_q, on_q;  // the packet under way: serves this unit, goes on
  logic here, on, is_head, is_value, is_gap, is_follower, is_for_all, is_data;
  assign is_head = (kind == rc2_pkg::KindHead);
  assign is_gap = (kind == rc2_pkg::KindGap);
  assign is_value = (kind == rc2_pkg::KindSlab) || (kind == rc2_pkg::KindSide) || is_gap;
  assign is_follower = is_value || (kind == rc2_pkg::KindRay);
  assign is_for_all = (kind == rc2_pkg::KindRead) || (kind == rc2_pkg::KindEnd);
  assign is_data = (kind == rc2_pkg::KindData);
  assign here = (is_head && skip == 0) || (is_follower && here_q) || is_for_all;
  assign on = (is_head && (skip != 0 || take > 1)) || (is_follower && on_q) || is_for_all || is_data;

  assign fire = (held != 0) && (!here || unit_ready_i) && (!on || next_ready_i);
  assign unit_waits_o = (held != 0) && here;
  assign unit_valid_o = (held != 0) && here && (!on || next_ready_i);
  assign next_valid_o = (held != 0) && on && (!here || unit_ready_i);

  // ---- What goes on --------------------------------------------------------------------------
  logic [CountW-1:0] skip_next, take_next;
  logic [DistW-1:0] step, dist_next;
  logic [LeadW-1:0] lead_next;
  logic [UnitPayloadW-1:0] rest_next;

  assign skip_next = (skip == 0) ? skip : skip - 1'b1;
  assign take_next = (skip == 0) ? take - 1'b1 : take;
  assign step = {{(DistW - rc2_pkg::CoefW) {lead[rc2_pkg::CoefW-1]}}, lead[rc2_pkg::CoefW-1:0]}
                << $clog2(Stride);
  assign dist_next = rest[DistW-1:0] + step;
  always_comb begin
    lead_next = lead;
    rest_next = rest;
    if (is_head) lead_next[2*CountW-1:0] = {take_next, skip_next};
    if (is_value && here_q) rest_next[DistW-1:0] = dist_next;
  end

  assign next_word_o = {kind, lead_next, rest_next};
  assign unit_word_o = {kind, rest};
  assign unit_lead_o = lead;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      here_q <= 1'b0;
      on_q   <= 1'b0;
    end else if (fire && is_head) begin
      here_q <= here;
      on_q   <= on;
    end
  end

  // Contract: a packet serves at least one unit; stepping never overflows; a word leaves whole.
  always_ff @(posedge clk_i) begin
    if (rst_ni && held != 0) begin
      assert (!is_head || take != 0);
      // A gap may wrap.
      assert (!(fire && is_value && !is_gap && here_q && on_q) ||
              rest[DistW-1] != step[DistW-1] || dist_next[DistW-1] == step[DistW-1]);
      assert (!fire || (unit_valid_o == here && next_valid_o == on));
    end
  end
endmodule
