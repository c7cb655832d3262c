// SPDX-License-Identifier: Apache-2.0
//
// rc2_splitter sends every target of a beam to the next voxel of its digital ray, and to no other: (u,v) is
// any one target. After k steps the ray of target j is at the integer o nearest to j*k/L, ties down:
//   (2o-1)*L < 2*j*k <= (2o+1)*L    (thesis 4.3.1; no division and no Y_med)
// The beam's corners are at this voxel after k steps, as the beam's sender has seen to.

module splitter_rays (
    input rc2_pkg::beam_t                       beam_i,
    input logic           [rc2_pkg::CoordW-1:0] x_i,
    input logic           [rc2_pkg::CoordW-1:0] y_i,
    input rc2_pkg::light_t                      light_i,
    input logic signed    [rc2_pkg::TargetW-1:0] u,
    input logic signed    [rc2_pkg::TargetW-1:0] v,
    input logic           [               1:0] u_part,  // any one child: 0 low, 1 middle, 2 high
    input logic           [               1:0] v_part
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned ExtentW = rc2_pkg::ExtentW;
  localparam int unsigned OffW = CoordW + 2;          // offsets of the voxels around the cube, signed
  localparam int unsigned WideW = TargetW + OffW + 2;  // products of a target and an offset, signed

  rc2_pkg::split_t split;
  logic [7:0] send;
  logic own, more;
  logic [TargetW-1:0] resume;
  logic [ExtentW-1:0] served_u, served_v, kept_u, kept_v;
  rc2_splitter u_splitter (
      .valid_i   (1'b1),
      .beam_i    (beam_i),
      .x_i       (x_i),
      .y_i       (y_i),
      .light_i   (light_i),
      .split_o   (split),
      .send_o    (send),
      .own_o     (own),
      .more_o    (more),
      .resume_o  (resume),
      .served_u_o(served_u),
      .served_v_o(served_v),
      .kept_u_o  (kept_u),
      .kept_v_o  (kept_v)
  );

  // ---- A beam as the machine has it ----------------------------------------------------------------
  logic along_x, along_y, along_z, down;
  assign along_x = (beam_i.dir[2:1] == 2'd0);
  assign along_y = (beam_i.dir[2:1] == 2'd1);
  assign along_z = (beam_i.dir[2:1] == 2'd2);
  assign down = beam_i.dir[0];
  logic signed [OffW-1:0] dx, dy, dz, w_off, u_off, v_off;
  logic signed [OffW-1:0] step, next;  // k, k+1
  assign dx = $signed({2'b00, x_i}) - $signed({2'b00, light_i.xs});
  assign dy = $signed({2'b00, y_i}) - $signed({2'b00, light_i.ys});
  assign dz = $signed({2'b00, beam_i.z}) - $signed({2'b00, light_i.zs});
  assign w_off = along_x ? dx : along_y ? dy : dz;
  assign u_off = along_x ? dy : dx;
  assign v_off = along_z ? dy : dz;
  assign step = down ? -w_off : w_off;
  assign next = step + 2'sd1;

  logic signed [WideW-1:0] far, umin, umax, vmin, vmax, wide_u, wide_v;
  assign far = $signed({{(WideW - rc2_pkg::DistanceW) {1'b0}}, light_i.distance});
  assign umin = $signed({{(WideW - TargetW) {beam_i.umin[TargetW-1]}}, beam_i.umin});
  assign umax = $signed({{(WideW - TargetW) {beam_i.umax[TargetW-1]}}, beam_i.umax});
  assign vmin = $signed({{(WideW - TargetW) {beam_i.vmin[TargetW-1]}}, beam_i.vmin});
  assign vmax = $signed({{(WideW - TargetW) {beam_i.vmax[TargetW-1]}}, beam_i.vmax});
  assign wide_u = WideW'(u);
  assign wide_v = WideW'(v);

  // Whether target j is at offset o after k steps.
  logic umin_here, umax_here, vmin_here, vmax_here;
  ray_at u_umin (.far_i(far), .target_i(umin), .step_i(step), .offset_i(u_off), .at_o(umin_here));
  ray_at u_umax (.far_i(far), .target_i(umax), .step_i(step), .offset_i(u_off), .at_o(umax_here));
  ray_at u_vmin (.far_i(far), .target_i(vmin), .step_i(step), .offset_i(v_off), .at_o(vmin_here));
  ray_at u_vmax (.far_i(far), .target_i(vmax), .step_i(step), .offset_i(v_off), .at_o(vmax_here));
  always_comb begin
    assume (beam_i.dir < 3'd6);
    assume (x_i <= CoordW'(N - 1) && y_i <= CoordW'(N - 1) && beam_i.z <= CoordW'(N - 1));
    assume (light_i.xs <= CoordW'(N - 1) && light_i.ys <= CoordW'(N - 1) && light_i.zs <= CoordW'(N - 1));
    assume (light_i.distance != 0 && light_i.distance <= rc2_pkg::DistanceW'(rc2_pkg::LMAX));
    assume (step >= 0);
    assume (-far <= umin && umin <= umax && umax <= far && -far <= vmin && vmin <= vmax && vmax <= far);
    assume (umin_here && umax_here && vmin_here && vmax_here);
    assume (u_part < 2'd3 && v_part < 2'd3);
  end

  // ---- Any one child ---------------------------------------------------------------------------
  // A side beam serves one part of V at a time, which stands in all three places.
  logic signed [OffW-1:0] way_u, way_v, way_x, way_y, way_z;  // -1, 0, 1
  assign way_u = $signed({{(OffW - 2) {1'b0}}, u_part}) - 2'sd1;
  assign way_v = $signed({{(OffW - 2) {1'b0}}, v_part}) - 2'sd1;
  assign way_x = along_x ? (down ? -1 : 1) : way_u;
  assign way_y = along_x ? way_u : along_y ? (down ? -1 : 1) : way_v;
  assign way_z = along_z ? (down ? -1 : 1) : way_v;
  logic u_next, v_next;  // the target's ray is there next
  ray_at u_next_u (.far_i(far), .target_i(wide_u), .step_i(next), .offset_i(u_off + way_u), .at_o(u_next));
  ray_at u_next_v (.far_i(far), .target_i(wide_v), .step_i(next), .offset_i(v_off + way_v), .at_o(v_next));

  logic sent;  // to the neighbour that way
  always_comb begin
    case ({way_x[1:0], way_y[1:0]})
      4'b01_00: sent = send[0];
      4'b01_01: sent = send[1];
      4'b00_01: sent = send[2];
      4'b11_01: sent = send[3];
      4'b11_00: sent = send[4];
      4'b11_11: sent = send[5];
      4'b00_11: sent = send[6];
      4'b01_11: sent = send[7];
      default:  sent = own;
    endcase
  end
  logic signed [TargetW-1:0] part_umin, part_umax, part_vmin, part_vmax;
  always_comb begin
    case (u_part)
      2'd0: {part_umin, part_umax} = {split.u_low_min, split.u_low_max};
      2'd1: {part_umin, part_umax} = {split.u_mid_min, split.u_mid_max};
      default: {part_umin, part_umax} = {split.u_high_min, split.u_high_max};
    endcase
    case (v_part)
      2'd0: {part_vmin, part_vmax} = {split.v_low_min, split.v_low_max};
      2'd1: {part_vmin, part_vmax} = {split.v_mid_min, split.v_mid_max};
      default: {part_vmin, part_vmax} = {split.v_high_min, split.v_high_max};
    endcase
  end
  logic in_beam, in_part, in_cube, in_child, later;
  assign in_beam = umin <= wide_u && wide_u <= umax && vmin <= wide_v && wide_v <= vmax;
  logic signed [OffW-1:0] to_x, to_y, to_z;
  assign in_part = part_umin <= u && u <= part_umax && part_vmin <= v && v <= part_vmax;
  assign to_x = $signed({2'b00, x_i}) + way_x;
  assign to_y = $signed({2'b00, y_i}) + way_y;
  assign to_z = $signed({2'b00, beam_i.z}) + way_z;
  assign in_cube = to_x >= 0 && to_x < N && to_y >= 0 && to_y < N && to_z >= 0 && to_z < N;
  assign in_child = sent && in_part && split.z == CoordW'(to_z);
  assign later = more && v >= $signed(resume);  // in the remainder, vmax is its end, too
  always_comb begin
    assert (split.dir == beam_i.dir);
    assert (!more || (!along_z && vmin < $signed(resume) && $signed(resume) <= vmax));
    assert (in_child == (in_beam && !later && u_next && v_next && in_cube));
  end
endmodule

// Whether the ray of a target is at an offset after some steps.
module ray_at #(
    localparam int unsigned OffW = rc2_pkg::CoordW + 2,
    localparam int unsigned WideW = rc2_pkg::TargetW + OffW + 2
) (
    input logic signed [WideW-1:0] far_i,
    input logic signed [WideW-1:0] target_i,
    input logic signed [ OffW-1:0] step_i,
    input logic signed [ OffW-1:0] offset_i,
    output logic                   at_o
);
  logic signed [WideW-1:0] twice, way;
  assign twice = WideW'(offset_i) <<< 1;
  assign way = (target_i * WideW'(step_i)) <<< 1;
  assign at_o = (twice - 2'sd1) * far_i < way && way <= (twice + 2'sd1) * far_i;
endmodule
