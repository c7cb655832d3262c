// SPDX-License-Identifier: Apache-2.0
//
// What becomes of a ray that goes no further, in two stages with a place each (rays::split in C++, thesis
// 1.3.2): first where it meets the plane and, in glass, how much it turns (rc2_ray_meet beside
// rc2_ray_snell); then the new directions (rc2_ray_bend twice), if there are any. A ray that has left the
// cube spends a cycle in each. Cycles: sw/cycle/ray_timing.h.

module rc2_ray_hit (
    input  logic                clk_i,
    input  logic                rst_ni,
    input  rc2_pkg::limits_t   limits_i,
    input  logic                stop_i,     // a ray
    input  rc2_pkg::stop_t     stop_ray_i,
    output logic                taken_o,
    output logic                answer_o,   // what is to be answered
    output rc2_pkg::answer_t   answer_ray_o,
    input  logic                free_i,     // it is taken
    output logic                busy_o,
    output logic                work_o
);
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned SlopeFormW = rc2_pkg::SlopeFormW;
  localparam int unsigned WeightW = rc2_pkg::WeightW;
  localparam int unsigned SquareW = rc2_pkg::SquareW;
  localparam int unsigned AmountW = rc2_pkg::AmountW;
  localparam int unsigned BentW = rc2_pkg::BentW;

  logic meeting_q, meet_done, meet_leaves, bending_q, bend_leaves;
  assign taken_o = stop_i && (!meeting_q || meet_leaves);
  assign meet_leaves = meeting_q && meet_done && (!bending_q || bend_leaves);
  assign busy_o = meeting_q || bending_q;
  assign work_o = meet_leaves || (meeting_q && !meet_done);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      meeting_q <= 1'b0;
      bending_q <= 1'b0;
    end else begin
      meeting_q <= taken_o || (meeting_q && !meet_leaves);
      bending_q <= meet_leaves || (bending_q && !bend_leaves);
    end
  end

  // ---- The first stage -------------------------------------------------------------------------------
  rc2_pkg::stop_t stop_q;
  rc2_pkg::start_t ray;
  rc2_pkg::face_t new_face, face;
  logic met, turned, all_back;
  logic [PlaceW-1:0] px, py, pz;
  logic [SquareW-1:0] square;
  logic [AmountW-1:0] amount;
  logic [BentW-1:0] scaled_x, scaled_y, scaled_z;
  assign new_face = stop_ray_i.face;
  assign ray = stop_q.start;
  assign face = stop_q.face;
  always_ff @(posedge clk_i) begin
    if (taken_o) stop_q <= stop_ray_i;
  end
  rc2_ray_meet u_meet (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .start_i   (taken_o && !stop_ray_i.escaped),
      .height_i  (new_face.height),
      .approach_i(new_face.approach),
      .ray_i     (ray),
      .vx_i      (stop_q.vx),
      .vy_i      (stop_q.vy),
      .vz_i      (stop_q.vz),
      .done_o    (met),
      .px_o      (px),
      .py_o      (py),
      .pz_o      (pz)
  );
  rc2_ray_snell u_snell (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .start_i   (taken_o && !stop_ray_i.escaped),
      .ray_i     (ray),
      .face_i    (face),
      .done_o    (turned),
      .none_o    (all_back),
      .square_o  (square),
      .amount_o  (amount),
      .scaled_x_o(scaled_x),
      .scaled_y_o(scaled_y),
      .scaled_z_o(scaled_z)
  );
  // The square, and whether all is reflected, are known before the point is.
  assign meet_done = stop_q.escaped || (met && (!face.glass || all_back || turned));

  // ---- What comes of it: new rays, where the old one ended, moved into the voxel in which it stopped -----
  logic send_mirrored, send_cleared;
  logic [WeightW-1:0] mirrored_weight, cleared_weight;
  logic [1:0] too_light, too_deep;
  rc2_ray_share u_share (
      .limits_i         (limits_i),
      .node_i           (ray.node),
      .weight_i         (ray.weight),
      .mirror_i         (face.mirror),
      .clear_i          (face.clear),
      .all_back_i       (face.glass && all_back),
      .mirrored_o       (send_mirrored),
      .mirrored_weight_o(mirrored_weight),
      .cleared_o        (send_cleared),
      .cleared_weight_o (cleared_weight),
      .too_light_o      (too_light),
      .too_deep_o       (too_deep)
  );
  logic signed [PlaceW-1:0] low_x, low_y, low_z, ex, ey, ez;
  localparam logic [PlaceFracW-1:0] Half = PlaceFracW'(1) << (PlaceFracW - 1);
  localparam logic signed [PlaceW-1:0] Most = PlaceW'((1 << PlaceFracW) - 1);
  assign low_x = $signed(PlaceW'({stop_q.hx, {PlaceFracW{1'b0}}})) - $signed(PlaceW'(Half));
  assign low_y = $signed(PlaceW'({stop_q.hy, {PlaceFracW{1'b0}}})) - $signed(PlaceW'(Half));
  assign low_z = $signed(PlaceW'({stop_q.hz, {PlaceFracW{1'b0}}})) - $signed(PlaceW'(Half));
  assign ex = ($signed(px) < low_x) ? low_x : ($signed(px) > low_x + Most) ? low_x + Most : $signed(px);
  assign ey = ($signed(py) < low_y) ? low_y : ($signed(py) > low_y + Most) ? low_y + Most : $signed(py);
  assign ez = ($signed(pz) < low_z) ? low_z : ($signed(pz) > low_z + Most) ? low_z + Most : $signed(pz);

  rc2_pkg::end_t ended;
  rc2_pkg::answer_t answer, answer_q;
  always_comb begin
    ended.escaped = stop_q.escaped;
    ended.rescued = stop_q.rescued;
    ended.back = face.back;
    ended.facet = face.facet;
    {ended.vx, ended.vy, ended.vz} = {stop_q.vx, stop_q.vy, stop_q.vz};
    {ended.px, ended.py, ended.pz} = {px, py, pz};
    ended.too_light = too_light;
    ended.too_deep = too_deep;
    if (stop_q.escaped) ended = {1'b1, {(rc2_pkg::EndW - 1) {1'b0}}};
    answer.start = ray;
    answer.ended = ended;
    {answer.ex, answer.ey, answer.ez} = {ex, ey, ez};
    answer.mirrored = send_mirrored && !stop_q.escaped;
    answer.mirrored_weight = mirrored_weight;
    {answer.mx, answer.my, answer.mz} = '0;
    answer.cleared = send_cleared && !stop_q.escaped;
    answer.cleared_inside = ray.in_glass ^ face.glass;
    answer.cleared_weight = cleared_weight;
    {answer.cx, answer.cy, answer.cz} = {ray.dx, ray.dy, ray.dz};
  end

  // ---- The second stage ------------------------------------------------------------------------------
  logic bends, bends_q, refracts_q;
  logic [1:0] bent;
  logic [SlopeFormW-1:0] nx_q, ny_q, nz_q;
  logic [BentW-1:0] scaled_x_q, scaled_y_q, scaled_z_q;
  logic [DirW-1:0] mx, my, mz, cx, cy, cz;
  rc2_pkg::start_t sender;
  assign sender = answer_q.start;
  assign bends = answer.mirrored || (answer.cleared && face.glass);
  always_ff @(posedge clk_i) begin
    if (meet_leaves) begin
      answer_q                             <= answer;
      bends_q                              <= bends;
      refracts_q                           <= face.glass;
      {nx_q, ny_q, nz_q}                   <= {face.x, face.y, face.z};
      {scaled_x_q, scaled_y_q, scaled_z_q} <= {scaled_x, scaled_y, scaled_z};
    end
  end
  rc2_ray_bend u_mirrored (
      .clk_i   (clk_i),
      .rst_ni  (rst_ni),
      .start_i (meet_leaves && bends),
      .amount_i(-(AmountW'(face.approach) << 1)),
      .square_i(square),
      .from_x_i(BentW'($signed(sender.dx))),
      .from_y_i(BentW'($signed(sender.dy))),
      .from_z_i(BentW'($signed(sender.dz))),
      .nx_i    (nx_q),
      .ny_i    (ny_q),
      .nz_i    (nz_q),
      .done_o  (bent[0]),
      .dx_o    (mx),
      .dy_o    (my),
      .dz_o    (mz)
  );
  rc2_ray_bend u_cleared (
      .clk_i   (clk_i),
      .rst_ni  (rst_ni),
      .start_i (meet_leaves && bends),
      .amount_i(amount),
      .square_i(square),
      .from_x_i(scaled_x_q),
      .from_y_i(scaled_y_q),
      .from_z_i(scaled_z_q),
      .nx_i    (nx_q),
      .ny_i    (ny_q),
      .nz_i    (nz_q),
      .done_o  (bent[1]),
      .dx_o    (cx),
      .dy_o    (cy),
      .dz_o    (cz)
  );
  assign answer_o = bending_q && (!bends_q || bent[0]);
  assign bend_leaves = answer_o && free_i;
  always_comb begin
    answer_ray_o = answer_q;
    {answer_ray_o.mx, answer_ray_o.my, answer_ray_o.mz} = {mx, my, mz};
    if (refracts_q) {answer_ray_o.cx, answer_ray_o.cy, answer_ray_o.cz} = {cx, cy, cz};
  end

  // Contract: both directions take equally long.
  always_ff @(posedge clk_i) begin
    if (rst_ni && bending_q && bends_q) assert (bent[0] == bent[1]);
  end
endmodule
