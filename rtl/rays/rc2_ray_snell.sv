// SPDX-License-Identifier: Apache-2.0
//
// How much a ray turns where it enters or leaves glass (rays::refract in C++; Snell, thesis 1.1): the
// square of the plane's normal N, the amount of N that is to be taken from the direction times the ratio of
// indices, and that product. Or that there is nothing to be had, because all is reflected.
//
// One multiplier and a root. What comes in is steady from the cycle after start_i on until done_o, which
// is high Steps + 7 cycles after start_i (sw/cycle/ray_timing.h), the square after 4, none_o after 7;
// they stay so until the next start.

module rc2_ray_snell (
    input  logic                           clk_i,
    input  logic                           rst_ni,
    input  logic                           start_i,
    input  rc2_pkg::start_t                ray_i,
    input  rc2_pkg::face_t                 face_i,
    output logic                           done_o,
    output logic                           none_o,    // all is reflected
    output logic [rc2_pkg::SquareW-1:0] square_o,
    output logic [rc2_pkg::AmountW-1:0] amount_o,
    output logic [  rc2_pkg::BentW-1:0] scaled_x_o,
    output logic [  rc2_pkg::BentW-1:0] scaled_y_o,
    output logic [  rc2_pkg::BentW-1:0] scaled_z_o
);
  localparam int unsigned DirFracW = rc2_pkg::DirFracW;
  localparam int unsigned IndexFracW = rc2_pkg::IndexFracW;
  localparam int unsigned RootW = rc2_pkg::RootW;
  localparam int unsigned SquareW = rc2_pkg::SquareW;
  localparam int unsigned AmountW = rc2_pkg::AmountW;
  localparam int unsigned BentW = rc2_pkg::BentW;
  // What is multiplied: K's terms (16 |N|^2 2^DirFracW at most, signed); what by.
  localparam int unsigned WideW = SquareW + DirFracW + 5;
  localparam int unsigned NarrowW = rc2_pkg::ApproachW + 1;
  localparam int unsigned ProductW = WideW + NarrowW;

  // ---- The steps: one bit each; the root runs from Amount on ---------------------------------------------
  localparam int unsigned SquareX = 0;
  localparam int unsigned SquareY = 1;
  localparam int unsigned SquareZ = 2;
  localparam int unsigned Cosine = 3;
  localparam int unsigned SineOnce = 4;
  localparam int unsigned SineTwice = 5;
  localparam int unsigned Amount = 6;
  localparam int unsigned ScaleX = 7;
  localparam int unsigned ScaleY = 8;
  localparam int unsigned ScaleZ = 9;
  localparam int unsigned Root = 10;
  localparam int unsigned Done = 11;
  localparam int unsigned Steps = 12;
  logic [Steps-1:0] at;
  logic rooted;
  rc2_steps #(
      .Steps(Steps),
      .Wait (Root)
  ) u_steps (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .start_i(start_i),
      .go_i   (rooted),
      .at_o   (at)
  );
  assign done_o = at[Done];

  // ---- The multiplier ----------------------------------------------------------------------------------
  logic signed [WideW-1:0] wide, sine_q, sine, full, less;
  logic signed [NarrowW-1:0] narrow, approach, ratio;
  logic signed [ProductW-1:0] product, half;
  logic [SquareW-1:0] square_q;
  assign approach = $signed({1'b0, face_i.approach});
  assign ratio = $signed(NarrowW'(face_i.ratio));
  always_comb begin
    wide = WideW'(sine_q);
    narrow = ratio;
    if (at[SquareX]) {wide, narrow} = {WideW'($signed(face_i.x)), NarrowW'($signed(face_i.x))};
    if (at[SquareY]) {wide, narrow} = {WideW'($signed(face_i.y)), NarrowW'($signed(face_i.y))};
    if (at[SquareZ]) {wide, narrow} = {WideW'($signed(face_i.z)), NarrowW'($signed(face_i.z))};
    if (at[Cosine]) {wide, narrow} = {WideW'(approach), approach};
    if (at[Amount]) wide = WideW'(approach);
    if (at[ScaleX]) wide = WideW'($signed(ray_i.dx));
    if (at[ScaleY]) wide = WideW'($signed(ray_i.dy));
    if (at[ScaleZ]) wide = WideW'($signed(ray_i.dz));
  end
  assign product = ProductW'(wide) * ProductW'(narrow);
  assign half = ProductW'(1) <<< (IndexFracW - 1);

  assign full = $signed(WideW'(square_q)) <<< DirFracW;
  assign sine = full - WideW'(product >>> DirFracW);
  assign less = full - WideW'(product >>> IndexFracW);  // K

  logic none_q;
  logic [RootW-1:0] root;
  rc2_root #(
      .RootW(RootW),
      .Step (rc2_pkg::RootStep)
  ) u_root (
      .clk_i   (clk_i),
      .rst_ni  (rst_ni),
      .start_i (at[SineTwice]),
      .square_i((2 * RootW)'($unsigned(less)) << DirFracW),
      .done_o  (rooted),
      .root_o  (root)
  );

  logic signed [AmountW-1:0] less_q;
  logic signed [BentW-1:0] scaled, scaled_x_q, scaled_y_q, scaled_z_q;
  assign scaled = BentW'((product + half) >>> IndexFracW);
  always_ff @(posedge clk_i) begin
    if (at[SquareX]) square_q <= SquareW'(product);
    if (at[SquareY] || at[SquareZ]) square_q <= square_q + SquareW'(product);
    if (at[Cosine]) sine_q <= sine[WideW-1] ? '0 : sine;
    if (at[SineOnce]) sine_q <= WideW'(product >>> IndexFracW);
    if (at[SineTwice]) none_q <= less[WideW-1];
    if (at[Amount]) less_q <= AmountW'(product >>> IndexFracW);
    if (at[ScaleX]) scaled_x_q <= scaled;
    if (at[ScaleY]) scaled_y_q <= scaled;
    if (at[ScaleZ]) scaled_z_q <= scaled;
  end
  assign none_o = none_q;
  assign square_o = square_q;
  assign amount_o = $signed(AmountW'(root)) - less_q;
  assign {scaled_x_o, scaled_y_o, scaled_z_o} = {scaled_x_q, scaled_y_q, scaled_z_q};

  // Contract: that of rc2_steps and of rc2_root.
endmodule
