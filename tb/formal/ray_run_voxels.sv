// SPDX-License-Identifier: Apache-2.0
//
// rc2_ray_run: any one voxel of the column is one that the ray passes or not, by where its borders lie: voxel
// v reaches from v - 1/2 to v + 1/2, and its lower border is its own. The ray passes the voxel at which
// it came in, and those from there to that of the height at which it leaves, if that lies ahead.

module ray_run_voxels #(
    localparam int unsigned N = rc2_pkg::N,
    localparam int unsigned CoordW = rc2_pkg::CoordW,
    localparam int unsigned RiseW = rc2_pkg::RiseW
) (
    input logic [CoordW-1:0] z_i,
    input logic              down_i,
    input logic [ RiseW-1:0] exit_i,
    input logic [     N-1:0] worth_i
);
  localparam int unsigned WideW = RiseW + CoordW + 4;
  logic [N-1:0] todo;
  logic [CoordW-1:0] last;
  logic leaves;
  rc2_ray_run u_run (
      .z_i     (z_i),
      .down_i  (down_i),
      .exit_i  (exit_i),
      .worth_i (worth_i),
      .todo_o  (todo),
      .last_o  (last),
      .leaves_o(leaves)
  );
  // A ray that is in the cube leaves the column within the slope's bound, 2 * 2^CoordW, of that height.
  logic signed [RiseW-1:0] exit;
  localparam logic signed [RiseW-1:0] Half = RiseW'(1) <<< (rc2_pkg::RiseFracW - 1);
  assign exit = $signed(exit_i);
  localparam logic signed [RiseW-1:0] Most = RiseW'(3) <<< (rc2_pkg::RiseFracW + CoordW);
  always_comb assume (z_i < N && exit >= -Most && exit <= Most);

  (* anyconst *) logic [CoordW-1:0] voxel;
  always_comb assume (voxel < N);
  logic signed [WideW-1:0] height, low, high;
  assign height = WideW'(exit);
  assign low = $signed(WideW'(voxel) << rc2_pkg::RiseFracW) - WideW'(Half);
  assign high = low + $signed(WideW'(1) << rc2_pkg::RiseFracW);
  logic passes, passes_last, above, below;
  assign above = (height >= low);
  assign below = (height < high);
  assign passes = (voxel == z_i) || (down_i ? voxel < z_i && below : voxel > z_i && above);
  // Nothing further on is passed.
  assign passes_last = passes && (down_i ? above || voxel == 0 : below || voxel == CoordW'(N - 1));

  logic signed [WideW-1:0] bottom, top;
  assign bottom = $signed(WideW'(0)) - WideW'(Half);
  assign top = bottom + $signed(WideW'(N) << rc2_pkg::RiseFracW);
  always_comb begin
    assert (todo[down_i ? CoordW'(N - 1) - voxel : voxel] == (worth_i[voxel] && passes));
    assert (leaves == (down_i ? height < bottom : height >= top));
    if (!leaves && voxel == last) assert (passes_last);
  end
endmodule
