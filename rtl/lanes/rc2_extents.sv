// SPDX-License-Identifier: Apache-2.0
//
// In which layers of a cell light can still meet something, here or further on.
//
// Light never turns back along x or y, so what it can still meet is in the quadrant of the array away
// from its source. Whether there is anything in each of the four quadrants that the cell is the corner
// of, it hears from its neighbours as the scene is loaded: less than 2n cycles after the last voxel
// (rc2_machine waits for that), once for each scene and whatever the light.
//
// A ray keeps its tilt, the layers that it goes up or down for each cell outward, dz / max(|dx|, |dy|).
// With the start of a light the cell divides for the lowest and the highest tilt of the rays that can
// meet its own column, then joins them with what the cells of its sector in the next ring outward say
// (sw/cycle/extents.h; from ring to ring a cycle each, while the light comes outward, two cycles each),
// and with what its neighbours say that light comes to within the ring. Tilts times the distance are
// layers; until then all layers count, if there is anything in the quadrant. What is rounded is rounded
// so that nothing is missed.
//
// Latency from the start: 2 (TiltSizeW/4 + 1) cycles if there is anything in the column, then one for each
// ring from the outermost with anything, then three; one more in the light's own cell, which has to hear of
// eight neighbours.

module rc2_extents (
    input  logic                             clk_i,
    input  logic                             rst_ni,
    input  logic                             clear_i,
    input  logic                             fill_i,    // voxel fill_z_i is occupied from now on
    input  logic [rc2_pkg::CoordW-1:0]       fill_z_i,
    // whether there is anything in a quadrant, from the neighbours
    input  logic [1:0]                       e_i,       // {se, ne}
    input  logic [1:0]                       n_i,       // {nw, ne}
    input  logic [1:0]                       w_i,       // {sw, nw}
    input  logic [1:0]                       s_i,       // {se, sw}
    output logic [3:0]                       quadrants_o,  // {se, sw, nw, ne}
    // a light: where it is, and where the cell is, seen from it; steady from the start on
    input  logic                             start_i,
    input  logic                             active_i,  // the light spreads
    input  logic [rc2_pkg::CoordW-1:0]       zs_i,
    input  logic [rc2_pkg::CountW-1:0]       distance_i,
    input  logic                             east_i,
    input  logic                             west_i,
    input  logic                             north_i,
    input  logic                             south_i,
    input  logic                             wide_i,    // farther in x than in y
    input  logic                             tall_i,    // farther in y than in x
    // sectors, from the neighbours in directions E NE N NW W SW S SE
    input  logic [rc2_pkg::ReachW-1:0]       reach0_i,
    input  logic [rc2_pkg::ReachW-1:0]       reach1_i,
    input  logic [rc2_pkg::ReachW-1:0]       reach2_i,
    input  logic [rc2_pkg::ReachW-1:0]       reach3_i,
    input  logic [rc2_pkg::ReachW-1:0]       reach4_i,
    input  logic [rc2_pkg::ReachW-1:0]       reach5_i,
    input  logic [rc2_pkg::ReachW-1:0]       reach6_i,
    input  logic [rc2_pkg::ReachW-1:0]       reach7_i,
    output logic [rc2_pkg::ReachW-1:0]       reach_o,
    // what this cell's light can meet: layers min .. max, if there are any
    output logic                             beyond_o,
    output logic [rc2_pkg::CoordW-1:0]       min_o,
    output logic [rc2_pkg::CoordW-1:0]       max_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned FracW = rc2_pkg::TiltFracW;
  localparam int unsigned SizeW = rc2_pkg::TiltSizeW;
  localparam int unsigned TiltW = rc2_pkg::TiltW;
  localparam int unsigned ReachW = rc2_pkg::ReachW;
  localparam int unsigned OddW = CoordW + 2;  // twice a distance, and one
  localparam logic [CoordW-1:0] Last = CoordW'(N - 1);
  localparam logic signed [TiltW-1:0] Most = $signed(rc2_pkg::TiltMost);

  // ---- As the scene is loaded ------------------------------------------------------------------
  logic own_q;
  logic [CoordW-1:0] min_q, max_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      own_q <= 1'b0;
    end else if (fill_i) begin
      own_q <= 1'b1;
      if (!own_q || fill_z_i < min_q) min_q <= fill_z_i;
      if (!own_q || fill_z_i > max_q) max_q <= fill_z_i;
    end
  end

  logic [3:0] quadrants_q, away;
  logic anything;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      quadrants_q <= '0;
    end else begin
      quadrants_q[0] <= own_q || e_i[0] || n_i[0];
      quadrants_q[1] <= own_q || w_i[0] || n_i[1];
      quadrants_q[2] <= own_q || w_i[1] || s_i[0];
      quadrants_q[3] <= own_q || e_i[1] || s_i[1];
    end
  end
  assign quadrants_o = quadrants_q;
  assign away = {!west_i && !north_i, !east_i && !north_i, !east_i && !south_i, !west_i && !south_i};
  assign anything = ((quadrants_q & away) != 0);

  // ---- Tilts of the own column: first the lowest, then the highest ---------------------------------
  // A voxel above the light is met by rays of a tilt of up to (2 dz + 1) / (2 m - 1), and of at least
  // (2 dz - 1) / (2 m + 1).
  logic source;
  assign source = (distance_i == 0);
  logic low_taken_q, high_q, own_done_q, done, high;
  assign high = low_taken_q;  // of the division that starts
  logic signed [OddW-1:0] rise;
  logic below, outer;
  logic [OddW-1:0] size, twice, upper, lower;
  logic [CoordW-1:0] end_z;
  assign end_z = high ? max_q : min_q;
  assign rise = $signed(OddW'(end_z)) - $signed(OddW'(zs_i));
  assign below = rise[OddW-1] || (!high && rise == 0);
  assign outer = (high != below);
  assign size = rise[OddW-1] ? $unsigned(-rise) : $unsigned(rise);
  assign twice = OddW'({distance_i, 1'b0});
  assign upper = outer ? (size << 1) + 1'b1 : (size << 1) - 1'b1;
  assign lower = !outer ? twice + 1'b1 : source ? '0 : twice - 1'b1;
  logic [SizeW-1:0] quotient, own_size;
  logic rest_unused;
  rc2_divide #(
      .NumW (OddW + FracW),
      .DivW (OddW),
      .QuotW(SizeW),
      .Step (4)
  ) u_divide (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i((start_i && own_q) || low_taken_q),
      .num_i  ({upper, FracW'(0)}),
      .div_i  (lower),
      .done_o (done),
      .quot_o (quotient),
      .rest_o (rest_unused)
  );
  logic below_q, outer_q;
  logic signed [TiltW-1:0] own_tilt;
  assign own_size = (outer_q && quotient != '1) ? quotient + 1'b1 : quotient;
  assign own_tilt = below_q ? -$signed({1'b0, own_size}) : $signed({1'b0, own_size});
  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) begin
      low_taken_q <= 1'b0;
      high_q      <= 1'b0;
      own_done_q  <= 1'b0;
    end else begin
      low_taken_q <= done && !high_q;
      if (low_taken_q) high_q <= 1'b1;
      if (done && high_q) own_done_q <= 1'b1;
    end
    if (start_i || low_taken_q) begin
      below_q <= below;
      outer_q <= outer;
    end
  end

  // ---- The sector ------------------------------------------------------------------------------
  // The light's own cell joins as one on the light's row, to the east, then to the west.
  logic wide, west, half_q, known_q;
  logic signed [TiltW-1:0] low_q, high_tilt_q;
  assign wide = wide_i || source;
  assign west = source ? half_q : west_i;
  logic [ReachW-1:0] straight, corner, third;
  logic on_row, on_column;
  assign on_row = wide && !north_i && !south_i;
  assign on_column = tall_i && !east_i && !west_i;
  assign straight = tall_i ? (south_i ? reach6_i : reach2_i) : (west ? reach4_i : reach0_i);
  assign corner = south_i ? (west ? reach5_i : reach7_i) : (west ? reach3_i : reach1_i);
  assign third = on_row ? (west ? reach5_i : reach7_i) :
                 on_column ? (south_i ? reach5_i : reach3_i) :
                 (wide || tall_i) ? rc2_pkg::NoReach : (south_i ? reach6_i : reach2_i);

  logic straight_known, corner_known, third_known, joins;
  logic signed [TiltW-1:0] straight_low, straight_high, corner_low, corner_high, third_low, third_high;
  logic signed [TiltW-1:0] own_low, own_high, inner_low, inner_high, outer_low, outer_high;
  assign {straight_known, straight_high, straight_low} = straight;
  assign {corner_known, corner_high, corner_low} = corner;
  assign {third_known, third_high, third_low} = third;
  assign joins = (own_done_q || !own_q) && straight_known && corner_known && third_known && !known_q;
  // The own column's lowest tilt waits in the sector's register, the highest in the divider.
  assign own_low = (half_q || own_q) ? low_q : Most;
  assign own_high = half_q ? high_tilt_q : own_q ? own_tilt : -Most;
  assign inner_low = (own_low < straight_low) ? own_low : straight_low;
  assign inner_high = (own_high > straight_high) ? own_high : straight_high;
  assign outer_low = (corner_low < third_low) ? corner_low : third_low;
  assign outer_high = (corner_high > third_high) ? corner_high : third_high;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) begin
      half_q  <= 1'b0;
      known_q <= 1'b0;
    end else if (joins) begin
      half_q  <= source;
      known_q <= !source || half_q;
    end
    if (joins) begin
      low_q       <= (inner_low < outer_low) ? inner_low : outer_low;
      high_tilt_q <= (inner_high > outer_high) ? inner_high : outer_high;
    end else if (low_taken_q) begin
      low_q <= own_tilt;
    end
  end
  assign reach_o = anything ? {known_q, high_tilt_q, low_q} : rc2_pkg::NoReach;

  // ---- With what light comes to within the ring ------------------------------------------------
  logic [ReachW-1:0] aside, other;
  logic aside_known, other_known, told, none;
  logic signed [TiltW-1:0] aside_low, aside_high, other_low, other_high;
  logic signed [TiltW-1:0] both_low, both_high, all_low, all_high;
  assign aside = wide ? (south_i ? reach6_i : reach2_i) :
                 tall_i ? (west_i ? reach4_i : reach0_i) : rc2_pkg::NoReach;
  assign other = on_row ? reach6_i : on_column ? reach4_i : rc2_pkg::NoReach;
  assign {aside_known, aside_high, aside_low} = aside;
  assign {other_known, other_high, other_low} = other;
  assign both_low = (aside_low < other_low) ? aside_low : other_low;
  assign both_high = (aside_high > other_high) ? aside_high : other_high;
  assign all_low = (low_q < both_low) ? low_q : both_low;
  assign all_high = (high_tilt_q > both_high) ? high_tilt_q : both_high;
  assign told = known_q && aside_known && other_known;
  assign none = (all_low > all_high);

  // ---- Layers: first the lowest, then the highest ------------------------------------------------
  // at[0]: the lowest tilt lies ready; at[1]: the highest, and the lowest layer; at[2]: both layers.
  localparam int unsigned LayerW = SizeW + OddW - FracW + 1;
  logic [2:0] at_q;
  logic none_q;
  logic signed [TiltW-1:0] tilt_q;
  logic tilt_below, tilt_outer;
  logic [SizeW-1:0] tilt_size;
  logic [OddW-1:0] halves;
  logic [SizeW+OddW-1:0] product;
  logic [LayerW-2:0] twice_layers;
  logic signed [LayerW-1:0] layers, layer;
  logic [CoordW-1:0] bound, first_layer_q, last_layer_q;
  assign tilt_below = tilt_q[TiltW-1];
  assign tilt_outer = (at_q[1] != tilt_below);
  assign tilt_size = SizeW'(tilt_below ? $unsigned(-tilt_q) : $unsigned(tilt_q));
  assign halves = tilt_outer ? twice + 1'b1 : source ? '0 : twice - 1'b1;
  assign product = (SizeW + OddW)'(tilt_size) * (SizeW + OddW)'(halves);
  assign twice_layers = (LayerW - 1)'(product >> FracW);
  assign layers = $signed({1'b0, (twice_layers >> 1) + (LayerW - 1)'(tilt_outer && twice_layers[0])});
  assign layer = $signed(LayerW'(zs_i)) + (tilt_below ? -layers : layers);
  always_comb begin
    bound = layer[CoordW-1:0];
    if (layer > $signed(LayerW'(Last))) bound = Last;
    if (layer < 0) bound = '0;
    if (tilt_outer && tilt_size == '1) bound = tilt_below ? '0 : Last;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni || !active_i) at_q <= '0;
    else if (told) at_q <= {at_q[1:0], 1'b1};
    if (told && !at_q[1]) begin
      tilt_q <= at_q[0] ? all_high : all_low;
      none_q <= none;
    end
    if (!at_q[1]) first_layer_q <= bound;
    if (!at_q[2]) last_layer_q <= bound;
  end
  assign beyond_o = anything && !(at_q[2] && none_q);
  assign min_o = at_q[2] ? first_layer_q : '0;
  assign max_o = at_q[2] ? last_layer_q : Last;

  // Contract: what is known stays until the next start; there is something in the own column's quadrants.
  logic knew_q, same_q;
  always_ff @(posedge clk_i) begin
    knew_q <= rst_ni && !start_i && known_q;
    same_q <= rst_ni && !clear_i && own_q;
    if (rst_ni) begin
      assert (!knew_q || known_q);
      assert (!same_q || quadrants_q == 4'hF);
    end
  end
endmodule
