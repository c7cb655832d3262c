// SPDX-License-Identifier: Apache-2.0
//
// What happens to a ray rarely, one thing at a time, with one divider, one root and one multiplier
// (sw/rays has the same in C++):
//   OpLaunch   at its start: E, and where it meets the next sides in x and y (rays::launch)
//   OpMeet     where it meets a plane, moved into the voxel or those round it (rays::meeting_point)
//   OpReflect  the mirrored direction (rays::reflect)
//   OpRefract  the direction behind a plane by Snell's law, or that there is none (rays::refract)
// Rays: thesis 1.3.2, 2.3; Snell: 1.1.
//
// start_i for one cycle while nothing is under way; the inputs are steady from then on until done_o,
// which is high in the last cycle. From the next cycle on the results stay until the next start. Cycles
// from the one after start_i to that of done_o (sw/cycle/ray_timing.h): OpLaunch 2 (1 +
// RiseQuotientW) + 4, OpMeet 1 + MeetQuotientW + 3, OpReflect 3 + 1 + BendQuotientW + 3, OpRefract 1 +
// RootW + 8 more, or 6 in all if everything is reflected.

module rc2_ray_unit (
    input  logic                             clk_i,
    input  logic                             rst_ni,
    input  logic                             start_i,
    input  logic [                      1:0] op_i,
    input  logic [    rc2_pkg::PlaceW-1:0] ox_i,  // origin
    input  logic [    rc2_pkg::PlaceW-1:0] oy_i,
    input  logic [    rc2_pkg::PlaceW-1:0] oz_i,
    input  logic [      rc2_pkg::DirW-1:0] dx_i,  // direction
    input  logic [      rc2_pkg::DirW-1:0] dy_i,
    input  logic [      rc2_pkg::DirW-1:0] dz_i,
    input  rc2_pkg::face_t                 face_i,
    input  logic [    rc2_pkg::CoordW-1:0] vx_i,  // voxel of the plane
    input  logic [    rc2_pkg::CoordW-1:0] vy_i,
    input  logic [    rc2_pkg::CoordW-1:0] vz_i,
    output logic                           done_o,
    output logic [ rc2_pkg::DecisionW-1:0] decision_o,  // OpLaunch
    output logic [     rc2_pkg::RiseW-1:0] exit_x_o,
    output logic [     rc2_pkg::RiseW-1:0] exit_y_o,
    output logic [     rc2_pkg::RiseW-1:0] slope_x_o,
    output logic [     rc2_pkg::RiseW-1:0] slope_y_o,
    output logic [    rc2_pkg::PlaceW-1:0] px_o,  // OpMeet: the point
    output logic [    rc2_pkg::PlaceW-1:0] py_o,
    output logic [    rc2_pkg::PlaceW-1:0] pz_o,
    output logic [      rc2_pkg::DirW-1:0] bx_o,  // OpReflect, OpRefract: the direction
    output logic [      rc2_pkg::DirW-1:0] by_o,
    output logic [      rc2_pkg::DirW-1:0] bz_o,
    output logic                           none_o  // OpRefract: all is reflected
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned WayW = rc2_pkg::WayW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned DirFracW = rc2_pkg::DirFracW;
  localparam int unsigned RiseW = rc2_pkg::RiseW;
  localparam int unsigned RiseFracW = rc2_pkg::RiseFracW;
  localparam int unsigned RiseQuotientW = rc2_pkg::RiseQuotientW;
  localparam int unsigned HeightW = rc2_pkg::HeightW;
  localparam int unsigned ApproachW = rc2_pkg::ApproachW;
  localparam int unsigned IndexFracW = rc2_pkg::IndexFracW;
  localparam int unsigned MeetFracW = rc2_pkg::MeetFracW;
  localparam int unsigned MeetQuotientW = rc2_pkg::MeetQuotientW;
  localparam int unsigned BendFracW = rc2_pkg::BendFracW;
  localparam int unsigned BendQuotientW = rc2_pkg::BendQuotientW;
  localparam int unsigned RootW = rc2_pkg::RootW;
  localparam int unsigned SquareW = 2 * rc2_pkg::SlopeFormFracW + 2;  // |N|^2: three at most
  // What is multiplied: K's terms (16 |N|^2 2^DirFracW at most, signed), a quotient; what by.
  localparam int unsigned SineW = SquareW + DirFracW + 5;
  localparam int unsigned WideW = (SineW > MeetQuotientW + 1) ? SineW : MeetQuotientW + 1;
  localparam int unsigned NarrowW = ApproachW + 1;
  localparam int unsigned ProductW = WideW + NarrowW;
  localparam int unsigned AmountW = ApproachW + 3;  // signed: root - ratio * approach
  localparam int unsigned MeetNumW = HeightW - 1 + MeetFracW;
  localparam int unsigned BendNumW = AmountW + BendFracW;
  localparam int unsigned NumW = (MeetNumW > BendNumW) ? MeetNumW : BendNumW;
  localparam int unsigned DivisorW = (ApproachW > SquareW) ? ApproachW : SquareW;
  localparam int unsigned QuotientW =
      (MeetQuotientW > RiseQuotientW) ? MeetQuotientW : RiseQuotientW;
  localparam int unsigned BitsW = $clog2(QuotientW + 1);

  // ---- The steps: one bit each -----------------------------------------------------------------
  localparam int unsigned LaunchDivX = 0;
  localparam int unsigned LaunchX = 1;
  localparam int unsigned LaunchDivY = 2;
  localparam int unsigned LaunchY = 3;
  localparam int unsigned DecideX = 4;
  localparam int unsigned DecideY = 5;
  localparam int unsigned MeetDiv = 6;
  localparam int unsigned MeetX = 7;
  localparam int unsigned MeetY = 8;
  localparam int unsigned MeetZ = 9;
  localparam int unsigned SquareX = 10;
  localparam int unsigned SquareY = 11;
  localparam int unsigned SquareZ = 12;
  localparam int unsigned Cosine = 13;
  localparam int unsigned SineOnce = 14;
  localparam int unsigned SineTwice = 15;
  localparam int unsigned Root = 16;
  localparam int unsigned Amount = 17;
  localparam int unsigned ScaleX = 18;
  localparam int unsigned ScaleY = 19;
  localparam int unsigned ScaleZ = 20;
  localparam int unsigned BendDiv = 21;
  localparam int unsigned BendX = 22;
  localparam int unsigned BendY = 23;
  localparam int unsigned BendZ = 24;
  localparam int unsigned Steps = 25;

  logic [Steps-1:0] at_q, ends, waits, next;
  logic fresh_q;  // first cycle of a step
  logic refracts, div_done, root_done, all_back;
  assign refracts = (op_i == rc2_pkg::OpRefract);
  always_comb begin
    waits = '0;
    waits[LaunchDivX] = !div_done;
    waits[LaunchDivY] = !div_done;
    waits[MeetDiv] = !div_done;
    waits[BendDiv] = !div_done;
    waits[Root] = !root_done;
    ends = '0;
    ends[DecideY] = 1'b1;
    ends[MeetZ] = 1'b1;
    ends[SineTwice] = all_back;
    ends[BendZ] = 1'b1;
    // To the next step, but after the square a mirror goes straight to its division.
    next = ((at_q & ~waits & ~ends) << 1) | (at_q & waits);
    if (at_q[SquareZ] && !refracts) begin
      next[Cosine]  = 1'b0;
      next[BendDiv] = 1'b1;
    end
    if (start_i && op_i == rc2_pkg::OpLaunch) next[LaunchDivX] = 1'b1;
    if (start_i && op_i == rc2_pkg::OpMeet) next[MeetDiv] = 1'b1;
    if (start_i && op_i[1]) next[SquareX] = 1'b1;
  end
  assign done_o = ((at_q & ends) != 0);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) at_q <= '0;
    else at_q <= next;
    fresh_q <= ((at_q & waits) == 0);
  end

  // ---- Operands ----------------------------------------------------------------------------------
  logic [DirFracW:0] run_x, run_y, rise;  // sizes
  logic [WayW-1:0] way_x, way_y;          // to the side of the first voxel
  logic [PlaceFracW-1:0] part_x, part_y;  // from the voxel's lower side
  logic signed [PlaceW-1:0] ox, oy, oz;
  logic signed [DirW-1:0] dx, dy, dz;
  logic signed [rc2_pkg::SlopeFormW-1:0] nx, ny, nz;
  logic signed [HeightW-1:0] height;
  logic signed [NarrowW-1:0] approach, ratio;
  assign {ox, oy, oz} = {ox_i, oy_i, oz_i};
  assign {dx, dy, dz} = {dx_i, dy_i, dz_i};
  assign {nx, ny, nz} = {face_i.x, face_i.y, face_i.z};
  assign height = $signed(face_i.height);
  assign approach = $signed({1'b0, face_i.approach});
  assign ratio = $signed(NarrowW'(face_i.ratio));
  assign run_x = dx[DirW-1] ? (DirFracW + 1)'(-dx) : (DirFracW + 1)'(dx);
  assign run_y = dy[DirW-1] ? (DirFracW + 1)'(-dy) : (DirFracW + 1)'(dy);
  assign rise = dz[DirW-1] ? (DirFracW + 1)'(-dz) : (DirFracW + 1)'(dz);
  assign part_x = ox[PlaceFracW-1:0] ^ {1'b1, {(PlaceFracW - 1) {1'b0}}};
  assign part_y = oy[PlaceFracW-1:0] ^ {1'b1, {(PlaceFracW - 1) {1'b0}}};
  assign way_x = dx[DirW-1] ? WayW'(part_x) : (WayW'(1) << PlaceFracW) - WayW'(part_x);
  assign way_y = dy[DirW-1] ? WayW'(part_y) : (WayW'(1) << PlaceFracW) - WayW'(part_y);

  // ---- The divider and the root ----------------------------------------------------------------
  logic [SquareW-1:0] square_q;
  logic signed [AmountW-1:0] amount_q, amount_size;
  logic signed [SineW-1:0] sine_q;
  logic [NumW-1:0] num;
  logic [DivisorW-1:0] divisor;
  logic [BitsW-1:0] bits;
  logic [QuotientW-1:0] quotient;
  logic [RootW-1:0] root;
  logic rest, dividing;
  assign amount_size = amount_q[AmountW-1] ? -amount_q : amount_q;
  assign dividing = at_q[LaunchDivX] || at_q[LaunchDivY] || at_q[MeetDiv] || at_q[BendDiv];
  always_comb begin
    num = NumW'(rise) << RiseFracW;
    divisor = at_q[LaunchDivX] ? DivisorW'(run_x) : DivisorW'(run_y);
    bits = BitsW'(RiseQuotientW);
    if (at_q[MeetDiv]) begin
      num = height[HeightW-1] ? '0 : NumW'($unsigned(height)) << MeetFracW;
      divisor = DivisorW'(face_i.approach);
      bits = BitsW'(MeetQuotientW);
    end
    if (at_q[BendDiv]) begin
      num = NumW'($unsigned(amount_size)) << BendFracW;
      divisor = DivisorW'(square_q);
      bits = BitsW'(BendQuotientW);
    end
  end
  rc2_divide #(
      .NumW (NumW),
      .DivW (DivisorW),
      .QuotW(QuotientW)
  ) u_divide (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(dividing && fresh_q),
      .num_i  (num),
      .div_i  (divisor),
      .bits_i (bits),
      .done_o (div_done),
      .quot_o (quotient),
      .rest_o (rest)
  );
  rc2_root #(
      .RootW(RootW)
  ) u_root (
      .clk_i   (clk_i),
      .rst_ni  (rst_ni),
      .start_i (at_q[Root] && fresh_q),
      .square_i((2 * RootW)'($unsigned(sine_q)) << DirFracW),
      .done_o  (root_done),
      .root_o  (root)
  );

  // ---- The multiplier ------------------------------------------------------------------------------
  logic signed [WideW-1:0] wide;
  logic signed [NarrowW-1:0] narrow;
  logic signed [ProductW-1:0] product;
  logic signed [WideW-1:0] turn, size;  // floor of the bend's quotient
  assign size = $signed(WideW'(quotient));
  assign turn = amount_q[AmountW-1] ? -size - $signed(WideW'(rest)) : size;
  always_comb begin
    wide = $signed(WideW'(quotient));
    narrow = '0;
    if (at_q[LaunchX]) narrow = $signed(NarrowW'(way_x));
    if (at_q[LaunchY]) narrow = $signed(NarrowW'(way_y));
    if (at_q[DecideX]) begin
      wide = $signed(WideW'(run_y));
      narrow = $signed(NarrowW'(way_x));
    end
    if (at_q[DecideY]) begin
      wide = $signed(WideW'(run_x));
      narrow = $signed(NarrowW'(way_y));
    end
    if (at_q[MeetX]) narrow = NarrowW'(dx);
    if (at_q[MeetY]) narrow = NarrowW'(dy);
    if (at_q[MeetZ]) narrow = NarrowW'(dz);
    if (at_q[SquareX]) {wide, narrow} = {WideW'(nx), NarrowW'(nx)};
    if (at_q[SquareY]) {wide, narrow} = {WideW'(ny), NarrowW'(ny)};
    if (at_q[SquareZ]) {wide, narrow} = {WideW'(nz), NarrowW'(nz)};
    if (at_q[Cosine]) {wide, narrow} = {WideW'(approach), approach};
    if (at_q[SineOnce] || at_q[SineTwice]) {wide, narrow} = {WideW'(sine_q), ratio};
    if (at_q[Amount]) {wide, narrow} = {WideW'(approach), ratio};
    if (at_q[ScaleX]) {wide, narrow} = {WideW'(dx), ratio};
    if (at_q[ScaleY]) {wide, narrow} = {WideW'(dy), ratio};
    if (at_q[ScaleZ]) {wide, narrow} = {WideW'(dz), ratio};
    if (at_q[BendX]) {wide, narrow} = {turn, NarrowW'(nx)};
    if (at_q[BendY]) {wide, narrow} = {turn, NarrowW'(ny)};
    if (at_q[BendZ]) {wide, narrow} = {turn, NarrowW'(nz)};
  end
  assign product = ProductW'(wide) * ProductW'(narrow);

  // ---- Launch: slopes and first exits, at most what stands for infinity ----------------------------
  localparam int unsigned LimitBit = RiseFracW + CoordW + 1;
  localparam logic signed [RiseW-1:0] Limit = RiseW'(1) << LimitBit;
  logic signed [RiseW-1:0] slope, first, base;
  assign slope = (quotient >= QuotientW'($unsigned(Limit))) ? Limit : $signed(RiseW'(quotient));
  assign first = ((product >>> PlaceFracW) >= ProductW'(Limit)) ? Limit :
                 $signed(RiseW'(product >>> PlaceFracW));
  assign base = RiseW'(oz) <<< (RiseFracW - PlaceFracW);

  logic signed [RiseW-1:0] exit_x_q, exit_y_q, slope_x_q, slope_y_q;
  logic signed [rc2_pkg::DecisionW-1:0] decision_q;
  assign {exit_x_o, exit_y_o, slope_x_o, slope_y_o} = {exit_x_q, exit_y_q, slope_x_q, slope_y_q};
  assign decision_o = decision_q;

  // ---- Meet: the point, at most a voxel away from the facet's --------------------------------------
  logic signed [ProductW-1:0] meet_half, ahead;
  logic signed [PlaceW-1:0] from, low, high, point;
  logic signed [ProductW-1:0] reached;
  logic [CoordW-1:0] voxel;
  assign meet_half = ProductW'(1) <<< (MeetFracW - 1);
  assign ahead = (product + meet_half) >>> MeetFracW;
  assign voxel = at_q[MeetX] ? vx_i : at_q[MeetY] ? vy_i : vz_i;
  assign from = at_q[MeetX] ? ox : at_q[MeetY] ? oy : oz;
  assign reached = ProductW'(from) + ahead;
  assign low = $signed(PlaceW'({voxel, {PlaceFracW{1'b0}}})) -
               $signed(PlaceW'(3 << (PlaceFracW - 1)));
  assign high = $signed(PlaceW'({voxel, {PlaceFracW{1'b0}}})) +
                $signed(PlaceW'((3 << (PlaceFracW - 1)) - 1));
  assign point = (reached < ProductW'(low)) ? low : (reached > ProductW'(high)) ? high :
                 PlaceW'(reached);

  // ---- Bend ----------------------------------------------------------------------------------------
  localparam logic signed [DirW-1:0] One = DirW'(1) << DirFracW;
  localparam logic signed [DirW-1:0] MinusOne = -One;
  localparam int unsigned BentW = DirW + 4;
  logic signed [SineW-1:0] full, less;
  logic signed [BentW-1:0] scaled_x_q, scaled_y_q, scaled_z_q, scaled, unbent;
  logic signed [ProductW-1:0] bend_half, turned, bent, scale_half;
  logic signed [DirW-1:0] direction;
  assign full = $signed(SineW'(square_q)) <<< DirFracW;
  assign less = full - SineW'(product >>> IndexFracW);  // K
  assign all_back = less[SineW-1];
  assign bend_half = ProductW'(1) <<< (BendFracW - 1);
  assign scale_half = ProductW'(1) <<< (IndexFracW - 1);
  assign scaled = BentW'((product + scale_half) >>> IndexFracW);
  assign unbent = at_q[BendX] ? scaled_x_q : at_q[BendY] ? scaled_y_q : scaled_z_q;
  assign turned = (product + bend_half) >>> BendFracW;
  assign bent = ProductW'(unbent) - turned;
  assign direction = (bent > ProductW'(One)) ? One : (bent < ProductW'(MinusOne)) ? MinusOne : DirW'(bent);

  logic signed [PlaceW-1:0] px_q, py_q, pz_q;
  logic signed [DirW-1:0] bx_q, by_q, bz_q;
  logic none_q;
  assign {px_o, py_o, pz_o} = {px_q, py_q, pz_q};
  assign {bx_o, by_o, bz_o} = {bx_q, by_q, bz_q};
  assign none_o = none_q;

  logic signed [SineW-1:0] sine;
  assign sine = full - SineW'(product >>> DirFracW);

  logic signed [AmountW-1:0] twice;
  assign twice = AmountW'(approach) <<< 1;

  always_ff @(posedge clk_i) begin
    if (at_q[LaunchX]) slope_x_q <= dz[DirW-1] ? -slope : slope;
    if (at_q[LaunchX]) exit_x_q <= dz[DirW-1] ? base - first : base + first;
    if (at_q[LaunchY]) slope_y_q <= dz[DirW-1] ? -slope : slope;
    if (at_q[LaunchY]) exit_y_q <= dz[DirW-1] ? base - first : base + first;
    if (at_q[DecideX]) decision_q <= rc2_pkg::DecisionW'(product);
    if (at_q[DecideY]) decision_q <= decision_q - rc2_pkg::DecisionW'(product);
    if (at_q[MeetX]) px_q <= point;
    if (at_q[MeetY]) py_q <= point;
    if (at_q[MeetZ]) pz_q <= point;
    if (at_q[SquareX]) square_q <= SquareW'(product);
    if (at_q[SquareY] || at_q[SquareZ]) square_q <= square_q + SquareW'(product);
    if (at_q[SquareX]) begin  // a mirror's
      amount_q   <= -twice;
      scaled_x_q <= BentW'(dx);
      scaled_y_q <= BentW'(dy);
      scaled_z_q <= BentW'(dz);
    end
    if (at_q[Cosine]) sine_q <= sine[SineW-1] ? '0 : sine;
    if (at_q[SineOnce]) sine_q <= SineW'(product >>> IndexFracW);
    if (at_q[SineTwice]) sine_q <= less;
    if (at_q[SineTwice]) none_q <= all_back;
    if (at_q[Amount])
      amount_q <= $signed(AmountW'(root)) - AmountW'(product >>> IndexFracW);
    if (at_q[ScaleX]) scaled_x_q <= scaled;
    if (at_q[ScaleY]) scaled_y_q <= scaled;
    if (at_q[ScaleZ]) scaled_z_q <= scaled;
    if (at_q[BendX]) bx_q <= direction;
    if (at_q[BendY]) by_q <= direction;
    if (at_q[BendZ]) bz_q <= direction;
  end

  // Contract: one thing at a time, in one step.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert ((at_q & (at_q - 1'b1)) == 0);
      assert (!(start_i && at_q != 0));
    end
  end
endmodule
