// SPDX-License-Identifier: Apache-2.0
//
// The stage in which a ray begins (rays::launch in C++; thesis 1.3.2, 2.3): E, and where it meets the next
// sides in x and y. Two divisions at a time, one multiplier: Steps + 3 cycles from the one in which a
// ray is taken up to that in which ready_o is high and the next may be taken (sw/cycle/ray_timing.h).

module rc2_ray_launch (
    input  logic            clk_i,
    input  logic            rst_ni,
    input  logic            take_i,   // a ray begins; nothing is there, or it leaves
    input  rc2_pkg::start_t begin_i,
    output logic            busy_o,
    output logic            ready_o,  // it can go on, as ray_o
    output rc2_pkg::ray_t   ray_o,
    input  logic            leave_i,
    output logic            work_o
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned WayW = rc2_pkg::WayW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned DirFracW = rc2_pkg::DirFracW;
  localparam int unsigned DecisionW = rc2_pkg::DecisionW;
  localparam int unsigned RiseW = rc2_pkg::RiseW;
  localparam int unsigned RiseFracW = rc2_pkg::RiseFracW;
  localparam int unsigned QuotientW = rc2_pkg::RiseQuotientW;
  localparam int unsigned NumW = DirFracW + 1 + RiseFracW;
  localparam int unsigned ProductW = QuotientW + WayW;

  // ---- The steps: one bit each ---------------------------------------------------------------------
  localparam int unsigned DecideX = 0;
  localparam int unsigned DecideY = 1;
  localparam int unsigned Divide = 2;
  localparam int unsigned ExitX = 3;
  localparam int unsigned ExitY = 4;
  localparam int unsigned Ready = 5;
  localparam int unsigned Steps = 6;
  logic [Steps-1:0] at_q, next;
  logic divided;
  always_comb begin
    next = at_q << 1;
    if (at_q[Divide] && !divided) next = at_q;
    if (at_q[Ready] && !leave_i) next = at_q;
    if (take_i) next = Steps'(1);
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) at_q <= '0;
    else at_q <= next;
  end
  assign busy_o = (at_q != 0);
  assign ready_o = at_q[Ready];
  assign work_o = take_i || (busy_o && !ready_o);

  // ---- Operands: sizes of the direction, ways to the side of the first voxel --------------------------
  rc2_pkg::start_t start_q;
  logic [DirFracW:0] new_x, new_y, new_z, run_x, run_y;
  logic [PlaceFracW-1:0] part_x, part_y;  // from the voxel's lower side
  logic [WayW-1:0] way_x, way_y;
  assign new_x = (DirFracW + 1)'(begin_i.dx[DirW-1] ? -begin_i.dx : begin_i.dx);
  assign new_y = (DirFracW + 1)'(begin_i.dy[DirW-1] ? -begin_i.dy : begin_i.dy);
  assign new_z = (DirFracW + 1)'(begin_i.dz[DirW-1] ? -begin_i.dz : begin_i.dz);
  assign part_x = start_q.ox[PlaceFracW-1:0] ^ {1'b1, {(PlaceFracW - 1) {1'b0}}};
  assign part_y = start_q.oy[PlaceFracW-1:0] ^ {1'b1, {(PlaceFracW - 1) {1'b0}}};
  assign way_x = start_q.dx[DirW-1] ? WayW'(part_x) : (WayW'(1) << PlaceFracW) - WayW'(part_x);
  assign way_y = start_q.dy[DirW-1] ? WayW'(part_y) : (WayW'(1) << PlaceFracW) - WayW'(part_y);

  // ---- Slopes ----------------------------------------------------------------------------------------
  logic [QuotientW-1:0] steep_x, steep_y;
  logic [1:0] done, rest;
  rc2_divide #(
      .NumW (NumW),
      .DivW (DirFracW + 1),
      .QuotW(QuotientW),
      .Step (rc2_pkg::RiseStep)
  ) u_divide_x (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(take_i),
      .num_i  (NumW'(new_z) << RiseFracW),
      .div_i  (new_x),
      .done_o (done[0]),
      .quot_o (steep_x),
      .rest_o (rest[0])
  );
  rc2_divide #(
      .NumW (NumW),
      .DivW (DirFracW + 1),
      .QuotW(QuotientW),
      .Step (rc2_pkg::RiseStep)
  ) u_divide_y (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(take_i),
      .num_i  (NumW'(new_z) << RiseFracW),
      .div_i  (new_y),
      .done_o (done[1]),
      .quot_o (steep_y),
      .rest_o (rest[1])
  );
  assign divided = done[0];
  logic unused;
  assign unused = &{1'b0, rest, done[1]};

  // ---- The multiplier ----------------------------------------------------------------------------------
  logic [QuotientW-1:0] wide, steep;
  logic [WayW-1:0] narrow;
  logic [ProductW-1:0] product;
  assign run_x = (DirFracW + 1)'(start_q.dx[DirW-1] ? -start_q.dx : start_q.dx);
  assign run_y = (DirFracW + 1)'(start_q.dy[DirW-1] ? -start_q.dy : start_q.dy);
  assign steep = at_q[ExitX] ? steep_x : steep_y;
  assign wide = at_q[DecideX] ? QuotientW'(run_y) : at_q[DecideY] ? QuotientW'(run_x) : steep;
  assign narrow = (at_q[DecideX] || at_q[ExitX]) ? way_x : way_y;
  assign product = ProductW'(wide) * ProductW'(narrow);

  // ---- At most what stands for infinity ------------------------------------------------------------------
  localparam int unsigned LimitBit = RiseFracW + CoordW + 1;
  localparam logic [RiseW-1:0] Limit = RiseW'(1) << LimitBit;
  logic [RiseW-1:0] slope, first, base, exit_x_q, exit_y_q, slope_x_q, slope_y_q;
  logic [DecisionW-1:0] decision_q;
  logic down;
  assign down = start_q.dz[DirW-1];
  assign slope = (steep >= QuotientW'(Limit)) ? Limit : RiseW'(steep);
  assign first = ((product >> PlaceFracW) >= ProductW'(Limit)) ? Limit : RiseW'(product >> PlaceFracW);
  assign base = RiseW'($signed(start_q.oz)) << (RiseFracW - PlaceFracW);
  always_ff @(posedge clk_i) begin
    if (take_i) start_q <= begin_i;
    if (at_q[DecideX]) decision_q <= DecisionW'(product);
    if (at_q[DecideY]) decision_q <= decision_q - DecisionW'(product);
    if (at_q[ExitX]) begin
      slope_x_q <= down ? -slope : slope;
      exit_x_q  <= down ? base - first : base + first;
    end
    if (at_q[ExitY]) begin
      slope_y_q <= down ? -slope : slope;
      exit_y_q  <= down ? base - first : base + first;
    end
  end

  localparam logic [PlaceW-1:0] Half = PlaceW'(1) << (PlaceFracW - 1);
  logic [PlaceW-1:0] place_z;
  assign place_z = start_q.oz + Half;
  always_comb begin
    ray_o = '0;
    ray_o.start = start_q;
    ray_o.decision = decision_q;
    ray_o.exit_x = exit_x_q;
    ray_o.exit_y = exit_y_q;
    ray_o.slope_x = slope_x_q;
    ray_o.slope_y = slope_y_q;
    ray_o.z = place_z[PlaceFracW+:CoordW];
  end

  // Contract: one ray at a time, in one step; it leaves when it is ready.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert ((at_q & (at_q - 1'b1)) == 0);
      assert (!(take_i && busy_o && !leave_i));
      assert (!(leave_i && !ready_o));
    end
  end
endmodule
