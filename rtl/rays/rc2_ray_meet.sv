// SPDX-License-Identifier: Apache-2.0
//
// Where a ray meets a plane, at most a voxel away from the facet's (rays::meeting_point in C++): a
// division and a product for each axis. Height and approach are given with start_i; what else comes in
// is steady from the next cycle on until done_o, which is high Steps + 4 cycles after start_i
// (sw/cycle/ray_timing.h) and with the point stays so until the next start. Thesis 1.3.2.

module rc2_ray_meet (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic                            start_i,
    input  logic [  rc2_pkg::HeightW-1:0] height_i,
    input  logic [rc2_pkg::ApproachW-1:0] approach_i,
    input  rc2_pkg::start_t                 ray_i,
    input  logic [   rc2_pkg::CoordW-1:0] vx_i,  // voxel of the plane
    input  logic [   rc2_pkg::CoordW-1:0] vy_i,
    input  logic [   rc2_pkg::CoordW-1:0] vz_i,
    output logic                            done_o,
    output logic [   rc2_pkg::PlaceW-1:0] px_o,
    output logic [   rc2_pkg::PlaceW-1:0] py_o,
    output logic [   rc2_pkg::PlaceW-1:0] pz_o
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned HeightW = rc2_pkg::HeightW;
  localparam int unsigned FracW = rc2_pkg::MeetFracW;
  localparam int unsigned QuotientW = rc2_pkg::MeetQuotientW;
  localparam int unsigned NumW = HeightW - 1 + FracW;
  localparam int unsigned ProductW = QuotientW + 1 + DirW;

  // ---- The steps: one bit each ---------------------------------------------------------------------
  localparam int unsigned Divide = 0;
  localparam int unsigned X = 1;
  localparam int unsigned Y = 2;
  localparam int unsigned Z = 3;
  localparam int unsigned Done = 4;
  localparam int unsigned Steps = 5;
  logic [Steps-1:0] at;
  logic divided;
  rc2_steps #(
      .Steps(Steps),
      .Wait (Divide)
  ) u_steps (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(start_i),
      .go_i   (divided),
      .at_o   (at)
  );
  assign done_o = at[Done];

  logic [QuotientW-1:0] quotient;
  logic rest, unused;
  rc2_divide #(
      .NumW (NumW),
      .DivW (rc2_pkg::ApproachW),
      .QuotW(QuotientW),
      .Step (rc2_pkg::MeetStep)
  ) u_divide (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(start_i),
      .num_i  (height_i[HeightW-1] ? '0 : NumW'(height_i) << FracW),
      .div_i  (approach_i),
      .done_o (divided),
      .quot_o (quotient),
      .rest_o (rest)
  );
  assign unused = &{1'b0, rest};

  logic [DirW-1:0] along;
  logic signed [PlaceW-1:0] from, low, high, point, px_q, py_q, pz_q;
  logic [CoordW-1:0] voxel;
  logic signed [ProductW-1:0] product, half, reached;
  assign along = at[X] ? ray_i.dx : at[Y] ? ray_i.dy : ray_i.dz;
  assign from = $signed(at[X] ? ray_i.ox : at[Y] ? ray_i.oy : ray_i.oz);
  assign voxel = at[X] ? vx_i : at[Y] ? vy_i : vz_i;
  assign product = ProductW'($signed({1'b0, quotient})) * ProductW'($signed(along));
  assign half = ProductW'(1) <<< (FracW - 1);
  assign reached = ProductW'(from) + ((product + half) >>> FracW);
  assign low = $signed(PlaceW'({voxel, {PlaceFracW{1'b0}}})) - $signed(PlaceW'(3 << (PlaceFracW - 1)));
  assign high = $signed(PlaceW'({voxel, {PlaceFracW{1'b0}}})) + $signed(PlaceW'((3 << (PlaceFracW - 1)) - 1));
  assign point = (reached < ProductW'(low)) ? low : (reached > ProductW'(high)) ? high : PlaceW'(reached);
  always_ff @(posedge clk_i) begin
    if (at[X]) px_q <= point;
    if (at[Y]) py_q <= point;
    if (at[Z]) pz_q <= point;
  end
  assign {px_o, py_o, pz_o} = {px_q, py_q, pz_q};

  // Contract: one point at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (!(start_i && at != 0 && !done_o));
  end
endmodule
