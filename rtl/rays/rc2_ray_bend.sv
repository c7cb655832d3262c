// SPDX-License-Identifier: Apache-2.0
//
// The direction that a ray takes at a plane: what it had, less so much of the plane's normal that it
// is mirrored or refracted (bend in sw/rays/split.cpp). A division, a product for each axis. Amount and
// square are given with start_i; what else comes in is steady from the next cycle on until done_o, which
// is high Steps + 4 cycles after start_i (sw/cycle/ray_timing.h) and with the direction stays so until the
// next start. Thesis 1.1.

module rc2_ray_bend (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              start_i,
    input  logic [   rc2_pkg::AmountW-1:0] amount_i,  // signed
    input  logic [   rc2_pkg::SquareW-1:0] square_i,  // of the normal
    input  logic [     rc2_pkg::BentW-1:0] from_x_i,  // what it had
    input  logic [     rc2_pkg::BentW-1:0] from_y_i,
    input  logic [     rc2_pkg::BentW-1:0] from_z_i,
    input  logic [rc2_pkg::SlopeFormW-1:0] nx_i,
    input  logic [rc2_pkg::SlopeFormW-1:0] ny_i,
    input  logic [rc2_pkg::SlopeFormW-1:0] nz_i,
    output logic                              done_o,
    output logic [      rc2_pkg::DirW-1:0] dx_o,
    output logic [      rc2_pkg::DirW-1:0] dy_o,
    output logic [      rc2_pkg::DirW-1:0] dz_o
);
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned DirFracW = rc2_pkg::DirFracW;
  localparam int unsigned SlopeFormW = rc2_pkg::SlopeFormW;
  localparam int unsigned AmountW = rc2_pkg::AmountW;
  localparam int unsigned FracW = rc2_pkg::BendFracW;
  localparam int unsigned QuotientW = rc2_pkg::BendQuotientW;
  localparam int unsigned NumW = AmountW + FracW;
  localparam int unsigned TurnW = QuotientW + 2;  // signed, rounded down
  localparam int unsigned ProductW = TurnW + SlopeFormW;

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

  logic [AmountW-1:0] size;
  logic [QuotientW-1:0] quotient;
  logic rest, back_q;  // back: the amount is below 0
  assign size = amount_i[AmountW-1] ? -amount_i : amount_i;
  rc2_divide #(
      .NumW (NumW),
      .DivW (rc2_pkg::SquareW),
      .QuotW(QuotientW),
      .Step (rc2_pkg::BendStep)
  ) u_divide (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(start_i),
      .num_i  (NumW'(size) << FracW),
      .div_i  (square_i),
      .done_o (divided),
      .quot_o (quotient),
      .rest_o (rest)
  );

  localparam logic signed [ProductW-1:0] One = ProductW'(1) << DirFracW;
  logic signed [TurnW-1:0] wide, turn;
  logic [SlopeFormW-1:0] normal;
  logic [rc2_pkg::BentW-1:0] from;
  logic signed [ProductW-1:0] product, half, bent;
  logic [DirW-1:0] direction, dx_q, dy_q, dz_q;
  assign wide = $signed(TurnW'(quotient));
  assign turn = back_q ? -wide - $signed(TurnW'(rest)) : wide;
  assign normal = at[X] ? nx_i : at[Y] ? ny_i : nz_i;
  assign from = at[X] ? from_x_i : at[Y] ? from_y_i : from_z_i;
  assign product = ProductW'(turn) * ProductW'($signed(normal));
  assign half = ProductW'(1) <<< (FracW - 1);
  assign bent = ProductW'($signed(from)) - ((product + half) >>> FracW);
  assign direction = DirW'((bent > One) ? One : (bent < -One) ? -One : bent);
  always_ff @(posedge clk_i) begin
    if (start_i) back_q <= amount_i[AmountW-1];
    if (at[X]) dx_q <= direction;
    if (at[Y]) dy_q <= direction;
    if (at[Z]) dz_q <= direction;
  end
  assign {dx_o, dy_o, dz_o} = {dx_q, dy_q, dz_q};

  // Contract: one direction at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (!(start_i && at != 0 && !done_o));
  end
endmodule
