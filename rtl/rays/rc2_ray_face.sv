// SPDX-License-Identifier: Apache-2.0
//
// Facing and exit: whether a ray stops in an armoured voxel, by the plane of the voxel's owner
// (rays::face, is_reached, is_in_front, side_face in C++; docs/render.md, thesis 5.5.2).
//
// A voxel a cycle: what is given in one cycle is answered in the next. With h the origin's height over
// the plane, m what N.d is, w the way to the side by which the ray leaves and a its axis, all is told
// by the sign of h|d_a| + mw: the plane is where that is 0.

module rc2_ray_face (
    input  logic                          clk_i,
    input  logic [    rc2_pkg::PlaceW-1:0] ox_i,  // origin
    input  logic [    rc2_pkg::PlaceW-1:0] oy_i,
    input  logic [    rc2_pkg::PlaceW-1:0] oz_i,
    input  logic [      rc2_pkg::DirW-1:0] dx_i,  // direction
    input  logic [      rc2_pkg::DirW-1:0] dy_i,
    input  logic [      rc2_pkg::DirW-1:0] dz_i,
    input  logic                          inside_i,
    input  logic [    rc2_pkg::CoordW-1:0] x_i,  // the voxel
    input  logic [    rc2_pkg::CoordW-1:0] y_i,
    input  logic [    rc2_pkg::CoordW-1:0] z_i,
    input  logic [                    2:0] axis_i,  // by which it is left: one bit for x, y, z
    input  rc2_pkg::claim_t                owner_i,
    input  rc2_pkg::optics_t               optics_i,
    output rc2_pkg::face_t                 face_o,   // if touches_o
    output logic                          seen_o,     // the ray could stop at the owner's plane
    output logic                          reached_o,  // and does
    output logic                          in_room_o,  // on the inner side of a room's wall
    output logic                          touches_o   // seen, or at least a room's side
);
  localparam int unsigned PlaceW = rc2_pkg::PlaceW;
  localparam int unsigned PlaceFracW = rc2_pkg::PlaceFracW;
  localparam int unsigned WayW = rc2_pkg::WayW;
  localparam int unsigned DirW = rc2_pkg::DirW;
  localparam int unsigned DirFracW = rc2_pkg::DirFracW;
  localparam int unsigned SlopeFormW = rc2_pkg::SlopeFormW;
  localparam int unsigned SlopeFormFracW = rc2_pkg::SlopeFormFracW;
  localparam int unsigned HeightW = rc2_pkg::HeightW;
  localparam int unsigned ApproachW = rc2_pkg::ApproachW;
  localparam int unsigned LeavingW = ApproachW + 1;  // signed
  localparam int unsigned OffsetW = PlaceW + 1;
  localparam logic signed [HeightW-1:0] Voxel = HeightW'(1) << (PlaceFracW + SlopeFormFracW);

  // ---- First cycle: the two dot products ---------------------------------------------------------
  logic signed [OffsetW-1:0] off_x, off_y, off_z, off;  // of the origin from the voxel's centre
  logic signed [DirW-1:0] dx, dy, dz, along;
  logic signed [SlopeFormW-1:0] nx, ny, nz;
  logic signed [HeightW-1:0] gap, height_q;
  logic signed [LeavingW-1:0] leaving_q;
  logic [DirFracW:0] speed_q;
  logic [WayW-1:0] way_q;
  logic [2:0] axis_q;
  logic inside_q, core_q;
  logic [2:0] back_q;  // signs of the direction
  logic [rc2_pkg::FacetW-1:0] facet_q;
  rc2_pkg::optics_t optics_q;
  assign {dx, dy, dz} = {dx_i, dy_i, dz_i};
  assign {nx, ny, nz} = {optics_i.x, optics_i.y, optics_i.z};
  assign off_x = OffsetW'($signed(ox_i)) - $signed(OffsetW'({x_i, {PlaceFracW{1'b0}}}));
  assign off_y = OffsetW'($signed(oy_i)) - $signed(OffsetW'({y_i, {PlaceFracW{1'b0}}}));
  assign off_z = OffsetW'($signed(oz_i)) - $signed(OffsetW'({z_i, {PlaceFracW{1'b0}}}));
  // The middle of the sixteenth that the gap was rounded down to.
  assign gap = HeightW'($signed({owner_i.behind, owner_i.distance ^ {(rc2_pkg::GapW - 1){owner_i.behind}},
                                 1'b1})) <<< (PlaceFracW - rc2_pkg::GapFractionW - 1 + SlopeFormFracW);
  assign along = axis_i[0] ? dx : axis_i[1] ? dy : dz;
  assign off = axis_i[0] ? off_x : axis_i[1] ? off_y : off_z;

  always_ff @(posedge clk_i) begin
    height_q  <= gap + HeightW'(nx) * HeightW'(off_x) + HeightW'(ny) * HeightW'(off_y) +
                 HeightW'(nz) * HeightW'(off_z);
    leaving_q <= LeavingW'(nx) * LeavingW'(dx) + LeavingW'(ny) * LeavingW'(dy) +
                 LeavingW'(nz) * LeavingW'(dz);
    speed_q   <= (DirFracW + 1)'(along[DirW-1] ? -along : along);
    way_q     <= WayW'(along[DirW-1] ? off : -off) + (WayW'(1) << (PlaceFracW - 1));
    axis_q    <= axis_i;
    inside_q  <= inside_i;
    core_q    <= !owner_i.not_core;
    back_q    <= {dz[DirW-1], dy[DirW-1], dx[DirW-1]};
    facet_q   <= owner_i.facet;
    optics_q  <= optics_i;
  end

  // ---- Second cycle: the verdict -------------------------------------------------------------------
  localparam int unsigned OverW = ((HeightW > LeavingW) ? HeightW : LeavingW) + WayW + 2;
  logic solid, room, thin, glass, back, sees, from_far;
  logic signed [HeightW-1:0] height, least;
  logic [ApproachW-1:0] approach;
  logic signed [OverW-1:0] over;  // where it leaves the voxel
  logic front;
  assign room = (optics_q.body == rc2_pkg::BodyRoom);
  assign solid = !optics_q.body[0] && !optics_q.body[1];
  assign glass = solid && (optics_q.clear != 0);
  assign thin = (optics_q.body == rc2_pkg::BodySheet) || (room && optics_q.clear != 0);
  assign back = !leaving_q[LeavingW-1];
  assign sees = (inside_q && glass) ? back : (!back || optics_q.body == rc2_pkg::BodySheet);
  assign height = back ? -height_q : height_q;
  assign approach = ApproachW'(back ? leaving_q : -leaving_q);
  assign least = thin ? Voxel >>> 1 : room ? -Voxel : '0;
  assign from_far = (height >= least);
  assign over = OverW'(height_q) * OverW'($signed({1'b0, speed_q})) +
                OverW'(leaving_q) * OverW'($signed({1'b0, way_q}));
  assign front = !over[OverW-1] && (over != 0);

  logic [SlopeFormW-1:0] side_x, side_y, side_z;  // the side it leaves by, as a face
  assign side_x = {back_q[0] ? 2'b01 : 2'b11, {SlopeFormFracW{1'b0}}};
  assign side_y = {back_q[1] ? 2'b01 : 2'b11, {SlopeFormFracW{1'b0}}};
  assign side_z = {back_q[2] ? 2'b01 : 2'b11, {SlopeFormFracW{1'b0}}};

  assign seen_o = (!solid || core_q) && (leaving_q != 0) && sees && from_far;
  assign reached_o = seen_o && (back ? !over[OverW-1] : !front);
  assign in_room_o = room && front;
  assign touches_o = seen_o || in_room_o;
  assign face_o.x = !seen_o ? side_x & {SlopeFormW{axis_q[0]}} : back ? -optics_q.x : optics_q.x;
  assign face_o.y = !seen_o ? side_y & {SlopeFormW{axis_q[1]}} : back ? -optics_q.y : optics_q.y;
  assign face_o.z = !seen_o ? side_z & {SlopeFormW{axis_q[2]}} : back ? -optics_q.z : optics_q.z;
  assign face_o.height = seen_o ? height : HeightW'(way_q) << SlopeFormFracW;
  assign face_o.approach = seen_o ? approach : ApproachW'(speed_q) << SlopeFormFracW;
  logic back_face;
  assign back_face = seen_o ? back : inside_q;
  assign face_o.back = back_face;
  assign face_o.facet = facet_q;
  assign face_o.mirror = optics_q.mirror;
  assign face_o.clear = optics_q.clear;
  assign face_o.glass = glass;
  assign face_o.ratio = back_face ? optics_q.leave : optics_q.enter;
endmodule
