// SPDX-License-Identifier: Apache-2.0
//
// The one place where the machine's size, message formats and widths are stated.
//
// A build chooses N, F, LMAX and FAMAX by macros; everything else follows from them.
// sw/base/config.h derives the same widths for the host, which checks them against the
// capability registers of rc2_machine before it sends a word.
//
// Language: the subset that Verilator 5.006 and Yosys 0.23 both read correctly. No import, no
// unpacked arrays of structs, no packed arrays of more than one dimension, no array ports.

`ifndef RC2_N
`define RC2_N 16
`endif
`ifndef RC2_F
`define RC2_F 4
`endif
`ifndef RC2_LMAX
`define RC2_LMAX (4 * `RC2_N)
`endif
`ifndef RC2_FAMAX
`define RC2_FAMAX 32
`endif

package rc2_pkg;

  // ---- What a build chooses ----------------------------------------------------------------
  localparam int unsigned N = `RC2_N;          // cells per side and voxels per column, >= 2
  localparam int unsigned F = `RC2_F;          // vertices are multiples of 2^-F voxel
  localparam int unsigned LMAX = `RC2_LMAX;    // largest distance of the virtual faces
  localparam int unsigned FAMAX = `RC2_FAMAX;  // places in a cell's beam queue (FA)

  // ---- Widths ------------------------------------------------------------------------------
  localparam int unsigned CoordW = (N <= 2) ? 1 : $clog2(N);  // 0 .. N-1
  localparam int unsigned OffW = CoordW + 1;                  // signed -(N-1) .. N-1
  localparam int unsigned CountW = $clog2(N + 1);             // 0 .. N
  // A plane coefficient is twice a projected area: at most (N*2^F)^2, which is reached; and a sign.
  localparam int unsigned CoefW = 2 * (CoordW + F) + 2;
  // A bound's value at any cell: three coefficients times an extent of N voxels, half a slab, sign.
  localparam int unsigned DistW = 3 * CoordW + 2 * F + 3;
  localparam int unsigned FacetW = 20;
  localparam int unsigned DistanceW = $clog2(LMAX + 1);        // L
  localparam int unsigned TargetW = DistanceW + 1;             // signed -L .. L
  localparam int unsigned ExtentW = $clog2(2 * LMAX + 2);      // 0 .. 2L+1 targets along one axis
  localparam int unsigned HomeW = $clog2(24 * LMAX * LMAX + 3);  // all targets of a source
  localparam int unsigned QueueW = $clog2(FAMAX + 1);
  // A readback value: a facet number, or a count of beams (each target visits a column <= N times).
  localparam int unsigned ValueW = (FacetW > HomeW + CoordW) ? FacetW : HomeW + CoordW;

  // ---- Words of the loading and readback pipe ------------------------------------------------
  // A word is {last, kind, payload}. In HEAD and BOUND the payload is {lead, rest}: `lead` steers
  // the stage that reads it, `rest` is what the stage hands to the unit beside it. The vertical
  // pipe's rest is a row pipe's payload, so one stage serves both (rc2_facet_stage).
  localparam int unsigned KindW = 2;
  localparam logic [1:0] KindHead = 2'd0;   // lead {take, skip}, rest {facet, zspan, z0}
  localparam logic [1:0] KindBound = 2'd1;  // lead step per cell, rest {c, d}: ..+ c*z + d >= 0
  localparam logic [1:0] KindRead = 2'd2;   // rest {what}: every cell appends its words
  localparam logic [1:0] KindData = 2'd3;   // one word read back: data_t

  localparam int unsigned LeadW = (2 * CountW > CoefW) ? 2 * CountW : CoefW;
  localparam int unsigned HeadRestW = FacetW + 2 * CoordW;
  localparam int unsigned BoundRestW = CoefW + DistW;
  localparam int unsigned RestW = (HeadRestW > BoundRestW) ? HeadRestW : BoundRestW;
  localparam int unsigned RowPayloadW = LeadW + RestW;
  localparam int unsigned HostPayloadW = LeadW + RowPayloadW;
  localparam int unsigned RowWordW = 1 + KindW + RowPayloadW;
  localparam int unsigned HostWordW = 1 + KindW + HostPayloadW;

  localparam logic [1:0] ReadVoxels = 2'd0;    // owner of each occupied voxel
  localparam logic [1:0] ReadLight = 2'd1;     // targets arrived at each occupied voxel
  localparam logic [1:0] ReadCounters = 2'd2;  // z=0: beams served; z=1: deepest queue

  typedef struct packed {
    logic              empty;  // the cell has nothing to say: z and value mean nothing
    logic [CoordW-1:0] z;
    logic [ValueW-1:0] value;
  } data_t;
  localparam int unsigned DataW = 1 + CoordW + ValueW;

  // ---- Light -------------------------------------------------------------------------------
  // A beam: all targets [umin..umax] x [vmin..vmax] of one face whose rays are at voxel z of the
  // cell that holds the beam (thesis 4.3.4.1). U is y on the x faces, else x; V is y on the z
  // faces, else z.
  localparam int unsigned BeamW = 3 + CoordW + 4 * TargetW;
  typedef struct packed {
    logic [2:0]         dir;  // {axis, negative}: 0 +x, 1 -x, 2 +y, 3 -y, 4 +z, 5 -z
    logic [CoordW-1:0]  z;
    logic [TargetW-1:0] umin;
    logic [TargetW-1:0] umax;
    logic [TargetW-1:0] vmin;
    logic [TargetW-1:0] vmax;
  } beam_t;

  // A beam cut into parts, along U and V each into low, middle and high (rc2_split_axis). The child
  // for U part i and V part j goes where those parts go; an empty part has no child.
  typedef struct packed {
    logic [2:0]         dir;
    logic [CoordW-1:0]  z;  // the children's voxel
    logic [TargetW-1:0] u_low_min;
    logic [TargetW-1:0] u_low_max;
    logic [TargetW-1:0] u_mid_min;
    logic [TargetW-1:0] u_mid_max;
    logic [TargetW-1:0] u_high_min;
    logic [TargetW-1:0] u_high_max;
    logic [TargetW-1:0] v_low_min;
    logic [TargetW-1:0] v_low_max;
    logic [TargetW-1:0] v_mid_min;
    logic [TargetW-1:0] v_mid_max;
    logic [TargetW-1:0] v_high_min;
    logic [TargetW-1:0] v_high_max;
  } split_t;

  // Constants of one light, steady while it runs.
  typedef struct packed {
    logic [CoordW-1:0]    xs;
    logic [CoordW-1:0]    ys;
    logic [CoordW-1:0]    zs;
    logic [DistanceW-1:0] distance;  // L
    logic [QueueW-1:0]    fa;        // places of the queue in use, 1 .. FAMAX
  } light_t;

  // ---- Directions: 0 E, 1 NE, 2 N, 3 NW, 4 W, 5 SW, 6 S, 7 SE; x grows east, y north ----------
  // The opposite of d is (d + 4) mod 8. Bit d is set where direction d has that component.
  localparam logic [7:0] Eastward = 8'b1000_0011;
  localparam logic [7:0] Northward = 8'b0000_1110;
  localparam logic [7:0] Westward = 8'b0011_1000;
  localparam logic [7:0] Southward = 8'b1110_0000;

endpackage
