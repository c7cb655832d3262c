// SPDX-License-Identifier: Apache-2.0
//
// Where an accurate light stops in a column (docs/light.md). The light's height over the owner's
// plane says whether the owner turns away from it. What turns away stops light, and so does what is
// inside; a sheet stops it half a voxel behind its plane, a guard from there to the longest step that
// a ray can make here.
//
// start_i: the memory is read voxel after voxel, one in a cycle; two cycles after the last the stops
// are right, until the next start. The light is steady meanwhile.

module rc2_prepare (
    input  logic                       clk_i,
    input  logic                       rst_ni,
    input  logic                       start_i,
    input  logic [rc2_pkg::CoordW-1:0] x_i,
    input  logic [rc2_pkg::CoordW-1:0] y_i,
    input  rc2_pkg::light_t            light_i,
    input  logic [     rc2_pkg::N-1:0] occupied_i,
    input  logic [     rc2_pkg::N-1:0] guard_i,     // never occupied
    input  logic [     rc2_pkg::N-1:0] solid_i,
    // the owner's memory: what it holds of the address in the cycle before
    output logic [rc2_pkg::CoordW-1:0] addr_o,
    input  rc2_pkg::claim_t            owner_i,
    input  rc2_pkg::plane_t            plane_i,
    output logic [     rc2_pkg::N-1:0] stops_o,
    output logic                       busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned OffW = rc2_pkg::OffW;
  localparam int unsigned NormalW = rc2_pkg::NormalW;
  localparam int unsigned DepthW = rc2_pkg::GapW - 1;
  // Three products of at most N-1 voxels, and a gap.
  localparam int unsigned HeightW = 2 * CoordW + 7;
  // Half a voxel in units of a gap.
  localparam logic [DepthW-1:0] Half = DepthW'(1) << (rc2_pkg::GapFractionW - 1);

  // ---- Which voxel -----------------------------------------------------------------------------
  logic [N-1:0] todo_q;
  logic [CoordW-1:0] z;
  logic any;
  rc2_first #(
      .Width(N)
  ) u_first (
      .bits_i (todo_q),
      .found_o(any),
      .index_o(z)
  );
  assign addr_o = z;

  // ---- The light's height over the plane -------------------------------------------------------
  logic read_q, occupied_q;
  logic [CoordW-1:0] z_q;
  logic signed [OffW-1:0] dx, dy, dz;  // from the light
  logic signed [NormalW-1:0] nx, ny, nz;
  logic signed [HeightW-1:0] gap, height;
  assign dx = $signed({1'b0, x_i}) - $signed({1'b0, light_i.xs});
  assign dy = $signed({1'b0, y_i}) - $signed({1'b0, light_i.ys});
  assign dz = $signed({1'b0, z_q}) - $signed({1'b0, light_i.zs});
  assign nx = $signed(plane_i.x);
  assign ny = $signed(plane_i.y);
  assign nz = $signed(plane_i.z);
  // The middle of the sixteenth that the gap was rounded down to, and an eighth of a voxel for doubt.
  assign gap = ($signed(HeightW'($signed({owner_i.behind, owner_i.distance ^ {DepthW{owner_i.behind}},
                                          1'b1}))) + HeightW'(4)) <<< (CoordW - 1);
  assign height = gap - HeightW'(nx) * HeightW'(dx) - HeightW'(ny) * HeightW'(dy) -
                  HeightW'(nz) * HeightW'(dz);

  // ---- How much deeper a step can bring a ray, if the owner faces the light and if it turns away --
  logic [NormalW-1:0] size_x, size_y, size_z;
  logic [NormalW-1:0] facing_step, away_step;  // at most three
  logic x_same, y_same, z_same;  // the normal's sign and the ray's
  assign size_x = nx[NormalW-1] ? $unsigned(-nx) : $unsigned(nx);
  assign size_y = ny[NormalW-1] ? $unsigned(-ny) : $unsigned(ny);
  assign size_z = nz[NormalW-1] ? $unsigned(-nz) : $unsigned(nz);
  assign x_same = (nx[NormalW-1] == dx[OffW-1]);
  assign y_same = (ny[NormalW-1] == dy[OffW-1]);
  assign z_same = (nz[NormalW-1] == dz[OffW-1]);
  assign facing_step = ((dx == 0 || x_same) ? '0 : size_x) +
                       ((dy == 0 || y_same) ? '0 : size_y) +
                       ((dz == 0 || z_same) ? '0 : size_z);
  assign away_step = ((dx == 0 || !x_same) ? '0 : size_x) +
                     ((dy == 0 || !y_same) ? '0 : size_y) +
                     ((dz == 0 || !z_same) ? '0 : size_z);

  // ---- The verdict -----------------------------------------------------------------------------
  logic judge_q, armour_q, away_q, behind_q;
  logic [CoordW-1:0] judged_z_q;
  logic [rc2_pkg::SurfaceW-1:0] surface_q;
  logic [DepthW-1:0] depth_q;
  logic [NormalW-1:0] step_q;
  logic [DepthW-1:0] nearest, farthest;
  logic in_reach, stops;
  logic [N-1:0] stops_q;
  assign nearest = (surface_q == rc2_pkg::SurfaceSheet) ? Half : '0;
  assign farthest = nearest + DepthW'(step_q >> CoordW) + 1'b1;
  assign in_reach = behind_q && (depth_q >= nearest) &&
                  (armour_q || depth_q <= farthest);
  assign stops = (armour_q && surface_q == rc2_pkg::SurfaceSolid) ? away_q :
                 (armour_q && surface_q == rc2_pkg::SurfaceCrowd) ? 1'b1 : in_reach;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      todo_q  <= '0;
      read_q  <= 1'b0;
      judge_q <= 1'b0;
    end else begin
      todo_q  <= start_i ? occupied_i | guard_i : todo_q & ~(N'(1) << z);
      read_q  <= any;
      judge_q <= read_q;
    end
    z_q        <= z;
    occupied_q <= occupied_i[z];
    judged_z_q <= z_q;
    armour_q   <= occupied_q;
    away_q     <= height[HeightW-1];
    behind_q   <= owner_i.behind ^ height[HeightW-1];
    depth_q    <= owner_i.distance;
    surface_q  <= plane_i.surface;
    step_q     <= height[HeightW-1] ? away_step : facing_step;
    if (start_i) stops_q <= solid_i & ~occupied_i;
    else if (judge_q && stops) stops_q[judged_z_q] <= 1'b1;
  end
  // The light's own voxel stops nothing: it may be a guard or inside a solid.
  logic [N-1:0] own;
  always_comb begin
    own = '0;
    for (int i = 0; i < N; i++) own[i] = (dx == 0) && (dy == 0) && (light_i.zs == CoordW'(i));
  end
  assign stops_o = stops_q & ~own;
  assign busy_o = any || read_q || judge_q;

  // Contract: a guard is not occupied; one start at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert ((occupied_i & guard_i) == 0);
      assert (!(start_i && busy_o));
    end
  end
endmodule
