// SPDX-License-Identifier: Apache-2.0
//
// Splits a beam at a free voxel of this cell into its children (thesis 4.3.3, 4.3.4.2): up to 3x3
// parts in line with the source, 2x2 elsewhere. A z beam's parts go to nine different cells and
// leave at once. A side beam (x or y face) would send the parts of V, which differ in z, to the
// same cells, so it serves one part of V at a time, the lowest first: `more_o` says that a
// remainder starting at target `resume_o` stays.
//
// Children that would leave the cube are not made; their targets are counted as escaped. Combinational.

module rc2_splitter (
    input  logic                                valid_i,
    input  rc2_pkg::beam_t                      beam_i,
    input  logic            [rc2_pkg::CoordW-1:0] x_i,
    input  logic            [rc2_pkg::CoordW-1:0] y_i,
    input  rc2_pkg::light_t                     light_i,
    output rc2_pkg::split_t                     split_o,
    output logic            [               7:0] send_o,    // children to the neighbours
    output logic                                 own_o,     // child that stays in this cell
    output logic                                 more_o,    // a remainder stays
    output logic            [rc2_pkg::TargetW-1:0] resume_o,  // its lowest V target
    // targets served now, along U and V, and those of them that stay in the cube
    output logic            [rc2_pkg::ExtentW-1:0] served_u_o,
    output logic            [rc2_pkg::ExtentW-1:0] served_v_o,
    output logic            [rc2_pkg::ExtentW-1:0] kept_u_o,
    output logic            [rc2_pkg::ExtentW-1:0] kept_v_o
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned OffW = rc2_pkg::OffW;
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam logic [CoordW-1:0] Last = CoordW'(rc2_pkg::N - 1);

  // ---- Where the voxel lies, seen from the source ----------------------------------------------
  logic signed [OffW-1:0] dx, dy, dz, step_off, u_off, v_off;
  logic [OffW-1:0] step_abs, u_abs, v_abs;
  logic along_x, along_y, along_z, negative;
  assign dx = $signed({1'b0, x_i}) - $signed({1'b0, light_i.xs});
  assign dy = $signed({1'b0, y_i}) - $signed({1'b0, light_i.ys});
  assign dz = $signed({1'b0, beam_i.z}) - $signed({1'b0, light_i.zs});
  assign along_x = (beam_i.dir[2:1] == 2'd0);
  assign along_y = (beam_i.dir[2:1] == 2'd1);
  assign along_z = beam_i.dir[2];
  assign negative = beam_i.dir[0];
  assign step_off = along_x ? dx : (along_y ? dy : dz);
  assign u_off = along_x ? dy : dx;
  assign v_off = along_z ? dy : dz;
  assign step_abs = step_off[OffW-1] ? $unsigned(-step_off) : $unsigned(step_off);
  assign u_abs = u_off[OffW-1] ? $unsigned(-u_off) : $unsigned(u_off);
  assign v_abs = v_off[OffW-1] ? $unsigned(-v_off) : $unsigned(v_off);

  logic [CountW-1:0] step;  // k+1
  assign step = CountW'(step_abs) + 1'b1;

  // ---- The parts -------------------------------------------------------------------------------
  logic [rc2_pkg::DistanceW-1:0] u_floor, u_ceil, v_floor, v_ceil;
  rc2_ymed u_ymed_u (
      .offset_i  (u_abs[CoordW-1:0]),
      .step_i    (step),
      .distance_i(light_i.distance),
      .floor_o   (u_floor),
      .ceil_o    (u_ceil)
  );
  rc2_ymed u_ymed_v (
      .offset_i  (v_abs[CoordW-1:0]),
      .step_i    (step),
      .distance_i(light_i.distance),
      .floor_o   (v_floor),
      .ceil_o    (v_ceil)
  );

  logic [2:0] u_part, v_part;
  logic signed [TargetW-1:0] u_low_max, u_mid_min, u_mid_max, u_high_min;
  logic signed [TargetW-1:0] v_low_max, v_mid_min, v_mid_max, v_high_min;
  rc2_split_axis u_split_u (
      .valid_i   (valid_i),
      .min_i     ($signed(beam_i.umin)),
      .max_i     ($signed(beam_i.umax)),
      .negative_i(u_off[OffW-1]),
      .zero_i    (u_off == 0),
      .floor_i   (u_floor),
      .ceil_i    (u_ceil),
      .part_o    (u_part),
      .low_max_o (u_low_max),
      .mid_min_o (u_mid_min),
      .mid_max_o (u_mid_max),
      .high_min_o(u_high_min)
  );
  rc2_split_axis u_split_v (
      .valid_i   (valid_i),
      .min_i     ($signed(beam_i.vmin)),
      .max_i     ($signed(beam_i.vmax)),
      .negative_i(v_off[OffW-1]),
      .zero_i    (v_off == 0),
      .floor_i   (v_floor),
      .ceil_i    (v_ceil),
      .part_o    (v_part),
      .low_max_o (v_low_max),
      .mid_min_o (v_mid_min),
      .mid_max_o (v_mid_max),
      .high_min_o(v_high_min)
  );

  // ---- What is served now ------------------------------------------------------------------------
  logic [2:0] v_served;
  assign v_served = along_z ? v_part : (v_part & (~v_part + 1'b1));
  assign more_o = (v_part != v_served);
  assign resume_o = $unsigned(v_served[0] ? v_low_max + 1'b1 : v_mid_max + 1'b1);

  // ---- What stays in the cube ----------------------------------------------------------------------
  logic west, east, south, north, floor, ceiling;  // the cube's borders this voxel touches
  assign west = (x_i == 0);
  assign east = (x_i == Last);
  assign south = (y_i == 0);
  assign north = (y_i == Last);
  assign floor = (beam_i.z == 0);
  assign ceiling = (beam_i.z == Last);

  logic leaves;  // one step along the beam's direction leaves the cube
  logic [2:0] u_inside, v_inside;
  assign leaves = along_x ? (negative ? west : east) :
                  along_y ? (negative ? south : north) : (negative ? floor : ceiling);
  assign u_inside = along_x ? {!north, 1'b1, !south} : {!east, 1'b1, !west};
  assign v_inside = along_z ? {!north, 1'b1, !south} : {!ceiling, 1'b1, !floor};

  logic [2:0] u_kept, v_kept;
  assign u_kept = leaves ? 3'b000 : (u_part & u_inside);
  assign v_kept = leaves ? 3'b000 : (v_served & v_inside);

  // ---- The children --------------------------------------------------------------------------------
  // {west, centre, east} and {south, centre, north} of this cell, as parts {low, middle, high}.
  logic [2:0] to_x, to_y;
  assign to_x = along_x ? (negative ? 3'b001 : 3'b100) : u_kept;
  assign to_y = along_x ? u_kept : along_y ? (negative ? 3'b001 : 3'b100) : v_kept;
  for (genvar d = 0; d < 8; d++) begin : g_send
    localparam int unsigned XPart = (((rc2_pkg::Eastward >> d) & 8'd1) != 0) ? 2 : (((rc2_pkg::Westward >> d) & 8'd1) != 0) ? 0 : 1;
    localparam int unsigned YPart = (((rc2_pkg::Northward >> d) & 8'd1) != 0) ? 2 : (((rc2_pkg::Southward >> d) & 8'd1) != 0) ? 0 : 1;
    assign send_o[d] = valid_i && to_x[XPart] && to_y[YPart] && (v_kept != 0);
  end
  assign own_o = valid_i && along_z && u_kept[1] && v_kept[1];

  logic z_down, z_up;
  assign z_down = along_z ? negative : v_served[0];
  assign z_up = along_z ? !negative : v_served[2];
  assign split_o.dir = beam_i.dir;
  assign split_o.z = beam_i.z + CoordW'(z_up) - CoordW'(z_down);
  assign split_o.u_low_min = beam_i.umin;
  assign split_o.u_low_max = $unsigned(u_low_max);
  assign split_o.u_mid_min = $unsigned(u_mid_min);
  assign split_o.u_mid_max = $unsigned(u_mid_max);
  assign split_o.u_high_min = $unsigned(u_high_min);
  assign split_o.u_high_max = beam_i.umax;
  // A side beam's children all take the V part that is served, so it stands in all three places. It is
  // the lowest part, so it begins where the beam does.
  logic [TargetW-1:0] v_max;
  assign v_max = v_served[0] ? $unsigned(v_low_max) : v_served[1] ? $unsigned(v_mid_max) : beam_i.vmax;
  assign split_o.v_low_min = beam_i.vmin;
  assign split_o.v_low_max = along_z ? $unsigned(v_low_max) : v_max;
  assign split_o.v_mid_min = along_z ? $unsigned(v_mid_min) : beam_i.vmin;
  assign split_o.v_mid_max = along_z ? $unsigned(v_mid_max) : v_max;
  assign split_o.v_high_min = along_z ? $unsigned(v_high_min) : beam_i.vmin;
  assign split_o.v_high_max = along_z ? beam_i.vmax : v_max;

  // ---- How many targets that is ----------------------------------------------------------------
  rc2_extent u_extent_u (
      .min_i     ($signed(beam_i.umin)),
      .max_i     ($signed(beam_i.umax)),
      .low_max_i (u_low_max),
      .high_min_i(u_high_min),
      .mid_min_i (u_mid_min),
      .mid_max_i (u_mid_max),
      .served_i  (u_part),
      .kept_i    (u_kept),
      .served_o  (served_u_o),
      .kept_o    (kept_u_o)
  );
  rc2_extent u_extent_v (
      .min_i     ($signed(beam_i.vmin)),
      .max_i     ($signed(beam_i.vmax)),
      .low_max_i (v_low_max),
      .high_min_i(v_high_min),
      .mid_min_i (v_mid_min),
      .mid_max_i (v_mid_max),
      .served_i  (v_served),
      .kept_i    (v_kept),
      .served_o  (served_v_o),
      .kept_o    (kept_v_o)
  );

  // Contract: a child never leaves the cube, a ray never strays further than its step, and side
  // beams never stay in the cell.
  always_comb begin
    if (valid_i) begin
      assert (u_abs <= step_abs && v_abs <= step_abs);
      assert (!((west && (send_o & rc2_pkg::Westward) != 0)));
      assert (!((east && (send_o & rc2_pkg::Eastward) != 0)));
      assert (!((south && (send_o & rc2_pkg::Southward) != 0)));
      assert (!((north && (send_o & rc2_pkg::Northward) != 0)));
      assert (!own_o || along_z);
    end
  end
endmodule
