// SPDX-License-Identifier: Apache-2.0
//
// The classes of one column or row of cells (sw/cycle/classes.h): all cells of equal x, or y, see
// the same targets of that axis in each step, so what becomes of them is worked out once for all.
// It keeps the list of the classes' outermost targets, as distances from 0, and hands on what
// leaves to the axis unit outward of it. At the light's own coordinate there is one class; its
// lowest target is kept in `inner`.
//
// In step s cut_o says what the classes of step s do, come_o how many have come for step s+1.

module rc2_axis (
    input  logic                             clk_i,
    input  logic                             start_i,
    input  logic                             tick_i,
    input  logic       [rc2_pkg::CoordW-1:0] at_i,
    input  logic       [rc2_pkg::CoordW-1:0] light_i,  // its coordinate
    input  logic       [rc2_pkg::DistanceW-1:0] distance_i,
    input  logic       [rc2_pkg::RatioW-1:0] ratio_i,
    output rc2_pkg::cut_t                    cut_o,
    output logic       [rc2_pkg::ClassW-1:0] come_o,
    // what leaves: to the neighbour below, above; only the first class differs
    output logic       [rc2_pkg::ClassW-1:0] down_count_o,
    output logic       [rc2_pkg::ClassW-1:0] up_count_o,
    output logic       [rc2_pkg::DistanceW-1:0] down_inner_o,
    output logic       [rc2_pkg::DistanceW-1:0] up_inner_o,
    output logic       [rc2_pkg::DistanceW-1:0] down_first_o,
    output logic       [rc2_pkg::ClassM*rc2_pkg::DistanceW-1:0] leaving_o,
    // what comes from below, above
    input  logic       [rc2_pkg::ClassW-1:0] below_count_i,
    input  logic       [rc2_pkg::DistanceW-1:0] below_inner_i,
    input  logic       [rc2_pkg::ClassM*rc2_pkg::DistanceW-1:0] below_i,
    input  logic       [rc2_pkg::ClassW-1:0] above_count_i,
    input  logic       [rc2_pkg::DistanceW-1:0] above_inner_i,
    input  logic       [rc2_pkg::DistanceW-1:0] above_first_i,
    input  logic       [rc2_pkg::ClassM*rc2_pkg::DistanceW-1:0] above_i,
    // for who counts: targets of each class of step s, and those that stay in the cube
    output logic       [rc2_pkg::WeightsW-1:0] weights_o,
    output logic       [rc2_pkg::WeightsW-1:0] kept_o
);
  localparam int unsigned M = rc2_pkg::ClassM;
  localparam int unsigned ClassW = rc2_pkg::ClassW;
  localparam int unsigned DistanceW = rc2_pkg::DistanceW;
  localparam int unsigned WeightsW = rc2_pkg::WeightsW;
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned OffW = rc2_pkg::OffW;
  localparam int unsigned StopW = rc2_pkg::StopW;
  localparam int unsigned ExtentW = rc2_pkg::ExtentW;

  logic signed [OffW-1:0] offset;
  logic zero, negative;
  assign offset = $signed({1'b0, at_i}) - $signed({1'b0, light_i});
  assign zero = (offset == 0);
  assign negative = offset[OffW-1];

  // ---- The last target, as a distance, that stays in the next step ---------------------------
  logic signed [OffW:0] odd_up, odd_down;
  logic signed [StopW-1:0] border_up, border_down;
  logic [DistanceW-1:0] up_last_q, down_last_q, last;
  assign odd_up = {offset, 1'b1};
  assign odd_down = odd_up - (OffW + 1)'(2);
  rc2_border u_up (
      .odd_i  (odd_up),
      .ratio_i(ratio_i),
      .last_o (border_up)
  );
  rc2_border u_down (
      .odd_i  (odd_down),
      .ratio_i(ratio_i),
      .last_o (border_down)
  );
  assign last = negative ? down_last_q : up_last_q;

  // ---- What the list does --------------------------------------------------------------------
  logic [ClassW-1:0] count_q, come_q, stay, leave;
  logic [DistanceW-1:0] inner_q, next_inner;
  logic [M*DistanceW-1:0] outer_q, leaving;
  logic [M-1:0] below, at;  // classes that end before the last target that stays, or with it
  logic down, up;
  for (genvar i = 0; i < M; i++) begin : g_compare
    logic [DistanceW-1:0] outer;
    assign outer = outer_q[i*DistanceW+:DistanceW];
    assign below[i] = (ClassW'(i) < count_q) && (outer < last);
    assign at[i] = (ClassW'(i) < count_q) && (outer == last);
  end
  assign down = zero ? (inner_q > down_last_q) : negative;
  assign up = zero ? (outer_q[DistanceW-1:0] > up_last_q) : !negative;
  always_comb begin
    leave = '0;
    for (int i = 0; i < M; i++) leave = leave + ClassW'(below[i] || at[i]);
    stay = leave;
    if (leave < count_q && at == 0 && (leave != 0 || inner_q <= last)) stay = leave + 1'b1;
    if (zero) begin
      stay  = ClassW'(1);
      leave = (down || up) ? '0 : ClassW'(1);
    end
  end

  // ---- What leaves -----------------------------------------------------------------------------
  always_comb begin
    leaving = outer_q;
    for (int b = 0; b < ClassW; b++) if (leave[b]) leaving = leaving >> (DistanceW << b);
    next_inner = inner_q;
    for (int i = 1; i < M; i++) begin
      if (leave == ClassW'(i)) next_inner = outer_q[(i-1)*DistanceW+:DistanceW] + 1'b1;
    end
    if (leave != stay) next_inner = last + 1'b1;
  end
  assign leaving_o = leaving;
  assign down_count_o = !down ? '0 : zero ? ClassW'(1) : count_q - leave;
  assign up_count_o = !up ? '0 : zero ? ClassW'(1) : count_q - leave;
  assign down_inner_o = zero ? down_last_q + 1'b1 : next_inner;
  assign up_inner_o = zero ? up_last_q + 1'b1 : next_inner;
  assign down_first_o = zero ? inner_q : leaving[DistanceW-1:0];

  // ---- The next list: what comes, then what stays ----------------------------------------------
  logic [ClassW-1:0] coming;
  logic [DistanceW-1:0] coming_inner;
  logic [M*DistanceW-1:0] coming_list, staying, moved, next_list;
  assign coming = zero ? '0 : negative ? above_count_i : below_count_i;
  assign coming_inner = negative ? above_inner_i : below_inner_i;
  always_comb begin
    coming_list = below_i;
    if (negative) begin
      coming_list = above_i;
      coming_list[DistanceW-1:0] = above_first_i;
    end
    staying = outer_q;
    for (int i = 0; i < M; i++) begin
      if (staying[i*DistanceW+:DistanceW] > last) staying[i*DistanceW+:DistanceW] = last;
    end
    moved = staying;
    for (int b = 0; b < ClassW; b++) if (coming[b]) moved = moved << (DistanceW << b);
    for (int i = 0; i < M; i++) begin
      next_list[i*DistanceW+:DistanceW] = (ClassW'(i) < coming) ?
          coming_list[i*DistanceW+:DistanceW] : moved[i*DistanceW+:DistanceW];
    end
  end

  rc2_pkg::cut_t cut_q;
  assign cut_o = cut_q;
  assign come_o = come_q;
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      // Step 0, where the light's own coordinate has all targets, and the lists after it.
      cut_q       <= '0;
      cut_q.stay  <= ClassW'(zero);
      cut_q.leave <= ClassW'(zero && distance_i == DistanceW'(1));
      cut_q.down  <= zero && (distance_i >= DistanceW'(2));
      cut_q.up    <= zero && (distance_i > DistanceW'(2));
      count_q     <= '0;
      come_q      <= '0;
      inner_q     <= zero ? (distance_i - 1'b1) >> 1 :
                     negative ? DistanceW'(({1'b0, distance_i} + 1'b1) >> 1) : (distance_i >> 1) + 1'b1;
      outer_q     <= {{(M - 1) * DistanceW{1'b0}}, zero ? (distance_i >> 1) : distance_i - 1'b1};
      if (zero) count_q <= ClassW'(1);
      if ((offset == 1 && distance_i > DistanceW'(2)) || (offset == -1 && distance_i >= DistanceW'(2))) begin
        count_q <= ClassW'(1);
        come_q  <= ClassW'(1);
      end
    end else if (tick_i) begin
      cut_q.come  <= come_q;
      cut_q.stay  <= stay;
      cut_q.leave <= leave;
      cut_q.down  <= down;
      cut_q.up    <= up;
      come_q      <= coming;
      count_q     <= zero ? ClassW'(1) : coming + stay;
      outer_q     <= next_list;
      if (zero) inner_q <= (inner_q > down_last_q) ? down_last_q : inner_q;
      else if (coming != 0) inner_q <= coming_inner;
    end
    if (tick_i) begin
      up_last_q   <= DistanceW'(border_up);
      down_last_q <= DistanceW'(~border_down);
    end
  end

  // ---- Numbers of targets ------------------------------------------------------------------------
  if (rc2_pkg::COUNTS) begin : g_count
    logic [ExtentW-1:0] up_stay, up_leave, down_stay, down_leave;  // of the light's own coordinate
    logic [WeightsW-1:0] weights, kept, weights_q, kept_q;
    logic to_down, to_up;  // neighbours that are in the cube
    logic [ExtentW-1:0] all;
    assign all = ExtentW'(distance_i);
    assign to_down = (at_i != 0);
    assign to_up = (at_i != CoordW'(N - 1));
    logic [DistanceW-1:0] highest, up_most, down_most;
    assign highest = outer_q[DistanceW-1:0];
    assign up_most = (highest < up_last_q) ? highest : up_last_q;
    assign down_most = (inner_q < down_last_q) ? inner_q : down_last_q;
    assign up_stay = ExtentW'(up_most);
    assign up_leave = ExtentW'(highest) - up_stay;
    assign down_stay = ExtentW'(down_most);
    assign down_leave = ExtentW'(inner_q) - down_stay;
    for (genvar i = 0; i < M; i++) begin : g_class
      logic [ExtentW-1:0] first, end_of, weight, stays;
      if (i == 0) begin : inner
        assign first = ExtentW'(inner_q);
      end else begin : later
        assign first = ExtentW'(outer_q[(i-1)*DistanceW+:DistanceW]) + 1'b1;
      end
      assign end_of = ExtentW'(outer_q[i*DistanceW+:DistanceW]) + 1'b1;
      assign weight = (ClassW'(i) < count_q) ? end_of - first : '0;
      assign stays = (ClassW'(i) < leave) ? weight :
                     (ClassW'(i) < stay) ? ExtentW'(last) + 1'b1 - first : '0;
      if (i == 0) begin : own
        assign weights[i*ExtentW+:ExtentW] = zero ? up_stay + up_leave + down_stay + down_leave + 1'b1 : weight;
        assign kept[i*ExtentW+:ExtentW] = zero ?
            up_stay + down_stay + 1'b1 + (to_up ? up_leave : '0) + (to_down ? down_leave : '0) :
            stays + ((negative ? to_down : to_up) ? weight - stays : '0);
      end else begin : outward
        assign weights[i*ExtentW+:ExtentW] = weight;
        assign kept[i*ExtentW+:ExtentW] = stays + ((negative ? to_down : to_up) ? weight - stays : '0);
      end
    end
    always_ff @(posedge clk_i) begin
      if (start_i) begin
        weights_q <= '0;
        kept_q    <= '0;
        if (zero) begin
          weights_q[ExtentW-1:0] <= (all << 1) - 1'b1;
          kept_q[ExtentW-1:0] <= (to_up ? all : (all >> 1) + 1'b1) +
                                 (to_down ? all - 1'b1 : (all - 1'b1) >> 1);
        end
      end else if (tick_i) begin
        weights_q <= weights;
        kept_q    <= kept;
      end
    end
    assign weights_o = weights_q;
    assign kept_o = kept_q;
  end else begin : g_no_count
    assign weights_o = '0;
    assign kept_o = '0;
  end
endmodule
