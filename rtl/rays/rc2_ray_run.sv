// SPDX-License-Identifier: Apache-2.0
//
// The voxels of a column that a ray passes, from the height at which it came in to that at which it
// leaves, and those of them that are worth a look, the next one first (docs/render.md; thesis 2.3).
// Combinational.

module rc2_ray_run (
    input  logic [ rc2_pkg::CoordW-1:0] z_i,
    input  logic                       down_i,  // the ray goes down
    input  logic [  rc2_pkg::RiseW-1:0] exit_i,  // height on the side of the column
    input  logic [      rc2_pkg::N-1:0] worth_i,
    output logic [      rc2_pkg::N-1:0] todo_o,  // bit i: voxel i, or N-1-i if the ray goes down
    output logic [ rc2_pkg::CoordW-1:0] last_o,  // the last voxel, if it does not leave
    output logic                       leaves_o  // it leaves the cube by its top or bottom
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned RiseW = rc2_pkg::RiseW;
  localparam int unsigned RiseFracW = rc2_pkg::RiseFracW;
  localparam int unsigned FloorW = RiseW - RiseFracW;

  // Going down is going up in a column that stands on its head.
  logic signed [RiseW-1:0] rounded;
  logic signed [FloorW-1:0] exit, far, last;
  logic [CoordW-1:0] from;
  logic [N-1:0] worth, upto;
  assign rounded = $signed(exit_i) + (RiseW'(1) <<< (RiseFracW - 1));
  assign exit = FloorW'(rounded >>> RiseFracW);
  assign far = down_i ? FloorW'(N - 1) - exit : exit;
  assign from = down_i ? CoordW'(N - 1) - z_i : z_i;
  assign last = (far < $signed(FloorW'(from))) ? $signed(FloorW'(from)) : far;
  assign leaves_o = (last > $signed(FloorW'(N - 1)));
  assign last_o = down_i ? CoordW'(N - 1) - CoordW'(last) : CoordW'(last);
  always_comb begin
    for (int i = 0; i < N; i++) begin
      worth[i] = down_i ? worth_i[N-1-i] : worth_i[i];
      upto[i]  = ($signed(FloorW'(i)) <= last);
    end
  end
  assign todo_o = worth & upto & ({N{1'b1}} << from);
endmodule
