// SPDX-License-Identifier: Apache-2.0
//
// The one place where the machine's size, message formats and widths are stated.
//
// A build chooses N, F, LMAX, FAMAX, FEEDERS, LAYERS, THESIS, COUNTS and SKIPS by macros; everything else
// follows from them. rc2_limits refuses what no machine can come of.
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
`define RC2_LMAX (4 * N)
`endif
`ifndef RC2_FAMAX
`define RC2_FAMAX 32
`endif
`ifndef RC2_LAYERS
`define RC2_LAYERS 1
`endif
`ifndef RC2_THESIS
`define RC2_THESIS 0
`endif
`ifndef RC2_COUNTS
`define RC2_COUNTS 1
`endif
`ifndef RC2_SKIPS
`define RC2_SKIPS 1
`endif
`ifndef RC2_RAYS
`define RC2_RAYS 0
`endif
`ifndef RC2_RAYDEPTH
`define RC2_RAYDEPTH 4
`endif
`ifndef RC2_RAYQ
`define RC2_RAYQ 2
`endif
`ifndef RC2_FEEDERS
`define RC2_FEEDERS ((N >= 64) ? 16 : (N >= 32) ? 8 : (N >= 16) ? 4 : (N >= 8) ? 2 : 1)
`endif

package rc2_pkg;

  // ---- What a build chooses ----------------------------------------------------------------
  // What is out of range becomes something small here, so that only rc2_limits speaks. N and F go as
  // far as the host's 64-bit arithmetic (sw/base/config.h), LMAX four times as far as N, FAMAX as far as
  // what rc2_history says fits a word of readback.
  localparam bit FitsN = (`RC2_N >= 2 && `RC2_N <= 1024);
  localparam int unsigned N = FitsN ? `RC2_N : 2;  // cells per side and voxels per column
  localparam bit FitsF = (`RC2_F >= 0 && `RC2_F <= 8);
  localparam int unsigned F = FitsF ? `RC2_F : 4;  // vertices are multiples of 2^-F voxel
  localparam bit FitsLmax = (`RC2_LMAX >= 2 && `RC2_LMAX <= 4096);
  localparam int unsigned LMAX = FitsLmax ? `RC2_LMAX : 4 * N;  // largest distance of the virtual faces
  localparam bit FitsFamax = (`RC2_FAMAX >= 1 && `RC2_FAMAX <= 4093);
  localparam int unsigned FAMAX = FitsFamax ? `RC2_FAMAX : 32;  // places in a cell's beam queue (FA)
  localparam bit FitsFeeders =
      (`RC2_FEEDERS >= 1 && `RC2_FEEDERS <= N && (`RC2_FEEDERS & (`RC2_FEEDERS - 1)) == 0);
  localparam int unsigned FEEDERS = FitsFeeders ? `RC2_FEEDERS : 1;  // words per cycle from the host

  localparam bit LAYERS = (`RC2_LAYERS != 0);  // columns know shown, inside and guard, not only armour
  localparam bit THESIS = (`RC2_THESIS != 0);  // light as in thesis 4.4, else in lanes (rtl/lanes)
  localparam bit COUNTS = (`RC2_COUNTS != 0);  // columns count targets, else they know only lit or not
  localparam bit SKIPS = (`RC2_SKIPS != 0);    // in lanes: light that can meet nothing ends early
  localparam bit FitsLayers = (`RC2_LAYERS == 0 || `RC2_LAYERS == 1);
  localparam bit FitsThesis = (`RC2_THESIS == 0 || `RC2_THESIS == 1);
  localparam bit FitsCounts = (`RC2_COUNTS == 0 || `RC2_COUNTS == 1);
  localparam bit FitsSkips = (`RC2_SKIPS == 0 || `RC2_SKIPS == 1);

  // Rays ask for what is inside, and for two neighbours.
  localparam bit FitsRays =
      (`RC2_RAYS == 0 || (`RC2_RAYS == 1 && LAYERS && !THESIS && `RC2_N >= 3));
  localparam bit RAYS = FitsRays && (`RC2_RAYS != 0);  // cells trace rays
  localparam bit FitsRayDepth = (`RC2_RAYDEPTH >= 1 && `RC2_RAYDEPTH <= 7);
  localparam int unsigned RAYDEPTH = FitsRayDepth ? `RC2_RAYDEPTH : 1;  // most bounces of a ray
  localparam bit FitsRayQ = (`RC2_RAYQ >= 1 && `RC2_RAYQ <= 255);
  localparam int unsigned RAYQ = FitsRayQ ? `RC2_RAYQ : 1;  // places of each queue that rays travel through

  // ---- Widths ------------------------------------------------------------------------------
  localparam int unsigned CoordW = (N <= 2) ? 1 : $clog2(N);  // 0 .. N-1
  localparam int unsigned OffW = CoordW + 1;                  // signed -(N-1) .. N-1
  localparam int unsigned CountW = $clog2(N + 1);             // 0 .. N
  localparam int unsigned FacetW = 20;
  // The gap between plane and voxel centre is kept in sixteenths of a voxel, -4 .. 4 voxels. On its
  // way through a box it needs as many fraction bits more as make the error of N steps along each
  // axis, half a unit each, 3/8 of a sixteenth; it is exact modulo eight voxels.
  localparam int unsigned GapFractionW = 4;
  localparam int unsigned GapW = 3 + GapFractionW;
  localparam int unsigned GapValueW = CoordW + 2 + GapW;
  localparam int unsigned ClaimW = 1 + GapW + FacetW;
  localparam int unsigned LayerW = 2;
  localparam int unsigned SurfaceW = 2;
  // A component of an owner's normal, of which the largest is one; signed. With so many fraction bits
  // the plane is right to an eighth of a voxel at every place of the cube.
  localparam int unsigned NormalFractionW = CoordW + 4;
  localparam int unsigned NormalW = NormalFractionW + 2;
  // A plane coefficient is twice a projected area: at most (N*2^F)^2, which is reached; and a sign.
  // The slab's width is at most twice a sum of three and one more.
  localparam int unsigned PlaneW = 2 * (CoordW + F) + 2;
  localparam int unsigned WidthW = PlaneW + 1;
  localparam int unsigned CoefW = (PlaneW > GapValueW) ? PlaneW : GapValueW;
  // A slab's or side's value at any cell: three coefficients times an extent of N voxels, half a
  // slab, sign.
  localparam int unsigned SlabW = 3 * CoordW + 2 * F + 3;
  localparam int unsigned DistW = (SlabW > GapValueW) ? SlabW : GapValueW;
  // A side's coefficient is an edge, at most N*2^F, which is reached; its push half of two.
  localparam int unsigned SideW = CoordW + F + 2;
  localparam int unsigned PushW = CoordW + F + 1;
  localparam int unsigned DistanceW = $clog2(LMAX + 1);        // L
  localparam int unsigned TargetW = DistanceW + 1;             // signed -L .. L
  localparam int unsigned ExtentW = $clog2(2 * LMAX + 2);      // 0 .. 2L+1 targets along one axis
  localparam int unsigned HomeW = $clog2(24 * LMAX * LMAX + 3);  // all targets of a source
  // Beams of a cell: FA; in lanes two FIFOs of FA/2, rounded up, and the beam that is served.
  localparam int unsigned QueueW = $clog2(FAMAX + 3);
  localparam int unsigned HistoryW = 16 + QueueW;  // {signature, deepest} of rc2_history
  // k/L, rounded down: times a target it is right to less than 1/2L. The host gives 1/L.
  localparam int unsigned SlopeF = 2 * DistanceW + 2;
  localparam int unsigned SlopeW = CoordW + SlopeF;
  // A readback value: a claim, or a count of beams (each target visits a column <= N times).
  localparam int unsigned ValueW = (ClaimW > HomeW + CoordW) ? ClaimW : HomeW + CoordW;

  // Rays (docs/render.md; sw/rays/format.h has the same widths).
  localparam int unsigned PlaceFracW = 6;  // of a place: 1/64 voxel
  localparam int unsigned PlaceW = CountW + PlaceFracW + 1;  // signed, -1/2 .. N-1/2 voxels
  localparam int unsigned DirFracW = CoordW + 5;  // of a direction, a unit vector
  localparam int unsigned DirW = DirFracW + 2;    // signed, -1 .. 1
  localparam int unsigned SlopeFormFracW = 10;
  localparam int unsigned SlopeFormW = SlopeFormFracW + 2;  // signed: component of a facet's normal
  localparam int unsigned ShareW = 9;    // share of light, 0 .. 1 in 1/256
  localparam int unsigned IndexFracW = 12;
  localparam int unsigned IndexW = IndexFracW + 3;  // ratio of refractive indices, 0 .. 4
  localparam int unsigned SharesRestW = 2 * ShareW + 2 * IndexW;
  localparam int unsigned RayRestW = 2 + ((3 * PlaceW > SharesRestW) ? 3 * PlaceW : SharesRestW);

  // ---- Words of the loading and readback pipe ------------------------------------------------
  // A word is {kind, payload}. In a packet's words the payload is {lead, rest}: `lead` steers
  // the stage that reads it, `rest` is what the stage hands to the unit beside it. The vertical
  // pipe's rest is a row pipe's payload, so one stage serves both (rc2_facet_stage). A packet is a
  // HEAD, a SLAB, its SIDEs and a GAP; the lead of all but HEAD is the step of d per cell. For rays a HEAD, which says
  // where, is followed by two words RAY.
  localparam int unsigned KindW = 3;
  localparam logic [2:0] KindHead = 3'd0;  // lead {take, skip}, rest {layer, width, facet, zspan, z0}
  localparam logic [2:0] KindSlab = 3'd1;  // rest {c, d}: 0 <= c*z + d <= width
  localparam logic [2:0] KindSide = 3'd2;  // rest {push, c, d}: c*z + d >= 0; core: >= push
  localparam logic [2:0] KindGap = 3'd3;   // rest {surface, b, c, d}: c*z + d is the gap of voxel z
  localparam logic [2:0] KindRead = 3'd4;  // rest {what}: every cell appends its words
  localparam logic [2:0] KindData = 3'd5;  // one word read back: data_t
  localparam logic [2:0] KindEnd = 3'd6;   // of an object: every column adds its parity to inside
  localparam logic [2:0] KindRay = 3'd7;   // rest {sort, what it says}

  localparam int unsigned LeadW = (2 * CountW > CoefW) ? 2 * CountW : CoefW;
  localparam int unsigned HeadRestW = LayerW + WidthW + FacetW + 2 * CoordW;
  localparam int unsigned SlabRestW = CoefW + DistW;
  localparam int unsigned SideRestW = PushW + SideW + DistW;
  localparam int unsigned GapRestW = SurfaceW + NormalW + GapValueW + DistW;
  localparam int unsigned PlaneRestW = (SlabRestW > GapRestW) ? SlabRestW : GapRestW;
  localparam int unsigned LongRestW = (PlaneRestW > SideRestW) ? PlaneRestW : SideRestW;
  localparam int unsigned PacketRestW = (HeadRestW > LongRestW) ? HeadRestW : LongRestW;
  localparam int unsigned RestW = (RAYS && RayRestW > PacketRestW) ? RayRestW : PacketRestW;
  localparam int unsigned RowPayloadW = LeadW + RestW;
  localparam int unsigned HostPayloadW = LeadW + RowPayloadW;
  localparam int unsigned RowWordW = KindW + RowPayloadW;
  localparam int unsigned HostWordW = KindW + HostPayloadW;

  localparam logic [2:0] ReadVoxels = 3'd0;    // claim of the owner of each occupied voxel
  localparam logic [2:0] ReadLight = 3'd1;     // targets arrived at each occupied voxel
  localparam logic [2:0] ReadCounters = 3'd2;  // z=0: beams served; z=1: how deep the queue was
  localparam logic [2:0] ReadLayers = 3'd3;    // {guard, inside, shown, armour} of each voxel in any
  localparam logic [2:0] ReadEnds = 3'd4;      // z=0: targets that ended in voxels of the column
  localparam logic [2:0] ReadHits = 3'd5;      // hits of the cell's pixel, HitWords each; then five counts

  // Sorts of RAY words. Of the HEAD's facet, for its voxels in the HEAD's box: body and normal, then
  // shares and indices. Of the cell's pixel: its ray's origin, then its direction.
  localparam int unsigned SortW = 2;
  localparam logic [1:0] SortNormal = 2'd0;
  localparam logic [1:0] SortShares = 2'd1;
  localparam logic [1:0] SortOrigin = 2'd2;
  localparam logic [1:0] SortDirection = 2'd3;

  // What a packet does with the voxels that it fills.
  localparam logic [1:0] LayerArmour = 2'd0;  // occupies and claims them
  localparam logic [1:0] LayerShown = 2'd1;   // marks them as shown
  localparam logic [1:0] LayerInside = 2'd2;  // flips the parity of them and all above them
  localparam logic [1:0] LayerGuard = 2'd3;   // claims those that are not occupied

  // What a facet is part of.
  localparam logic [1:0] SurfaceSolid = 2'd0;
  localparam logic [1:0] SurfaceSheet = 2'd1;
  localparam logic [1:0] SurfaceCrowd = 2'd2;

  typedef struct packed {
    logic              last;   // of the cell
    logic              empty;  // the cell has nothing to say: z and value are 0
    logic [CoordW-1:0] z;
    logic [ValueW-1:0] value;
  } data_t;
  localparam int unsigned DataW = 2 + CoordW + ValueW;

  // What a facet says of a voxel it fills. The better claim is the lower number: core first, then
  // the nearest plane, then the lowest facet; `distance` is the gap, or ~gap when behind the plane.
  typedef struct packed {
    logic              not_core;
    logic [GapW-2:0]   distance;
    logic [FacetW-1:0] facet;
    logic              behind;
  } claim_t;

  // What a column keeps of the owner's plane beside its claim.
  typedef struct packed {
    logic [SurfaceW-1:0] surface;
    logic [NormalW-1:0]  x;
    logic [NormalW-1:0]  y;
    logic [NormalW-1:0]  z;
  } plane_t;
  localparam int unsigned OwnerPlaneW = SurfaceW + 3 * NormalW;

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
    logic [SlopeW-1:0]    inverse;   // 1/L, rounded down (in lanes)
    logic [CoordW-1:0]    xs;
    logic [CoordW-1:0]    ys;
    logic [CoordW-1:0]    zs;
    logic [DistanceW-1:0] distance;  // L
    logic [QueueW-1:0]    fa;        // places of the queue in use, 1 .. FAMAX
  } light_t;
  localparam int unsigned LightW = SlopeW + 3 * CoordW + DistanceW + QueueW;

  // ---- Light in lanes ------------------------------------------------------------------------
  // Longest list of classes of one axis (sw/cycle/classes.h): the largest L that needs no more than
  // 1, 2, .. classes, whatever n; beyond them a bound.
  localparam int unsigned ClassM =
      (LMAX < 3) ? 1 : (LMAX < 12) ? 2 : (LMAX < 18) ? 3 : (LMAX < 39) ? 4 : (LMAX < 54) ? 5 :
      (LMAX < 84) ? 6 : (LMAX < 120) ? 7 : (LMAX < 135) ? 8 : (LMAX < 196) ? 9 :
      (LMAX < 241) ? 10 : (LMAX < 277) ? 11 : (LMAX < 333) ? 12 : (LMAX < 403) ? 13 :
      (LMAX < 455) ? 14 : (LMAX < 521) ? 15 : (LMAX < 609) ? 16 : 17 + (LMAX - 609) / 70;
  localparam int unsigned ClassW = $clog2(ClassM + 1);  // 0 .. ClassM
  localparam int unsigned MatrixW = ClassM * ClassM;    // a bit for each U class and V class
  localparam int unsigned BoundsW = ClassM * DistanceW;  // a distance for each class
  localparam int unsigned WeightsW = ClassM * ExtentW;   // a number of targets for each class
  // Runs of stops that a cell keeps at hand. Longer columns have more; with six at N = 256, beams above the
  // sixth ask each column on their way anew (docs/light.md).
  localparam int unsigned RUNS = (N > 128) ? 8 : 6;
  // L/2k, rounded up: times an odd number up to 2N-1 it is right to less than 1/2N.
  localparam int unsigned RatioF = 2 * CoordW + 3;
  localparam int unsigned RatioW = DistanceW - 1 + RatioF;
  localparam int unsigned StopW = TargetW + 1;  // signed -L-1 .. L+1

  // What the classes of one axis do in a step: the first `stay` stay, those from `leave` on leave,
  // after the first `come` have come.
  typedef struct packed {
    logic [ClassW-1:0] come;
    logic [ClassW-1:0] stay;
    logic [ClassW-1:0] leave;
    logic              down;  // some leave towards lower coordinates
    logic              up;
  } cut_t;
  localparam int unsigned CutW = 3 * ClassW + 2;

  // Tilt of a ray, layers up or down for each cell outward (rc2_extents): with CoordW + 1 bits of
  // fraction a bound is off by less than half a layer 2N-1 half cells away; 8 and more are all ones.
  localparam int unsigned TiltFracW = CoordW + 1;
  localparam int unsigned TiltSizeW = TiltFracW + 3;
  localparam int unsigned TiltW = TiltSizeW + 1;  // signed
  localparam logic [TiltW-1:0] TiltMost = {1'b0, {TiltSizeW{1'b1}}};

  // What a cell says of its sector: whether it knows, highest and lowest tilt that can meet something;
  // nothing can if the lowest is the higher.
  localparam int unsigned ReachW = 1 + 2 * TiltW;
  localparam logic [ReachW-1:0] NoReach = {1'b1, TiltW'(-TiltMost), TiltMost};

  // A side beam: V targets of a column, U targets of some classes. `edge_u` is one target more, U =
  // L or -L, which only x beams have, on the diagonals.
  typedef struct packed {
    logic               along_y;
    logic [TargetW-1:0] vmin;
    logic [TargetW-1:0] vmax;
    logic               edge_u;
    logic [ClassM-1:0]  classes;
  } lane_t;
  localparam int unsigned LaneW = 2 + 2 * TargetW + ClassM;

  // What all cells hear while the light spreads, step by step (rc2_pace).
  typedef struct packed {
    logic              active;    // the light spreads
    logic              first;     // first of a step's two cycles, that of the lane upwards
    logic [CountW-1:0] step;
    logic              on;        // the lane of this cycle is still in the cube
    logic              last;      // and leaves it in this step
    logic [CoordW-1:0] next_layer;  // where the lane of the next cycle is
    logic              tell;      // cells that are tell_step away from the light: for you
    logic [CountW-1:0] tell_step;
    logic [RatioW-1:0] ratio;
    logic [SlopeW-1:0] slope;
  } pace_t;
  localparam int unsigned PaceW = 5 + 2 * CountW + CoordW + RatioW + SlopeW;

  // ---- Rays ----------------------------------------------------------------------------------
  localparam int unsigned WayW = CoordW + PlaceFracW + 1;    // from a place to a side, 0 .. N voxels
  localparam int unsigned RiseFracW = (CoordW + 1 > PlaceFracW) ? CoordW + 1 : PlaceFracW;
  localparam int unsigned RiseW = RiseFracW + CoordW + 3;  // signed: dz/dx, and z on the side of a column
  localparam int unsigned DecisionW = DirFracW + PlaceFracW + 2;  // signed: |E| <= |d| times one cell
  // Of a ray's origin over a plane, 1/64 voxel times 1/1024: three terms of N voxels; N >= 3.
  localparam int unsigned HeightW = CoordW + PlaceFracW + SlopeFormFracW + 3;
  // How fast a ray comes nearer to a plane: three terms of at most one, unsigned.
  localparam int unsigned ApproachW = DirFracW + SlopeFormFracW + 2;
  localparam int unsigned WeightW = 13;  // worth of a ray, 0 .. 1 in 1/4096
  // Quotients. A slope is told from steeper ones up to 2*2^CoordW; 64 times that times two, so that even a
  // 64th of what stands for infinity is beyond it.
  localparam int unsigned RiseQuotientW = RiseFracW + CoordW + 8;
  // Of height and approach: beyond it any ray has left the cube along each axis that it moves in.
  localparam int unsigned MeetFracW = DirFracW + 1;
  localparam int unsigned MeetQuotientW = MeetFracW + PlaceW;
  // Of what a direction turns by and the normal's square, which is 1 at least.
  localparam int unsigned BendFracW = SlopeFormFracW + 1;
  localparam int unsigned BendQuotientW = DirFracW + BendFracW - SlopeFormFracW + 4;
  // |N|^2 * 2^(2 DirFracW), below 2^22 times that, and its root.
  localparam int unsigned RootW = SlopeFormFracW + 1 + DirFracW;

  // Bits of a quotient or a root in a cycle: as many as the slowest unit of a cell leaves time for. A slope's
  // divisor is narrow.
  localparam int unsigned RiseStep = 4;
  localparam int unsigned MeetStep = 2;
  localparam int unsigned BendStep = 2;
  localparam int unsigned RootStep = 2;
  localparam int unsigned SquareW = 2 * SlopeFormFracW + 2;  // |N|^2: three at most
  localparam int unsigned AmountW = ApproachW + 3;  // signed: root - ratio * approach
  localparam int unsigned BentW = DirW + 4;  // signed: a direction times a ratio

  // What a facet belongs to: a solid, a room, a sheet (sw/rays/ray.h).
  localparam logic [1:0] BodyRoom = 2'd1;
  localparam logic [1:0] BodySheet = 2'd2;

  // What a column keeps of an owner for rays.
  typedef struct packed {
    logic [1:0]            body;
    logic [SlopeFormW-1:0] x;  // normal, outward
    logic [SlopeFormW-1:0] y;
    logic [SlopeFormW-1:0] z;
    logic [ShareW-1:0]     mirror;
    logic [ShareW-1:0]     clear;
    logic [IndexW-1:0]     enter;  // index outside over that inside, and the inverse
    logic [IndexW-1:0]     leave;
  } optics_t;
  localparam int unsigned OpticsW = 2 + 3 * SlopeFormW + 2 * ShareW + 2 * IndexW;

  // A plane that a ray could have stopped at: turned to face it, and what becomes of a ray there.
  typedef struct packed {
    logic [SlopeFormW-1:0] x;
    logic [SlopeFormW-1:0] y;
    logic [SlopeFormW-1:0] z;
    logic [HeightW-1:0]    height;
    logic [ApproachW-1:0]  approach;
    logic                  back;  // the facet's inner side is seen
    logic [FacetW-1:0]     facet;
    logic [ShareW-1:0]     mirror;
    logic [ShareW-1:0]     clear;
    logic                  glass;  // a solid's facet that lets light through
    logic [IndexW-1:0]     ratio;  // of the index before it over that behind it
  } face_t;
  localparam int unsigned FaceW =
      3 * SlopeFormW + HeightW + ApproachW + 2 + FacetW + 2 * ShareW + IndexW;

  // A ray at its start. Node 1 of a pixel's tree is its first ray, 2i what i reflects, 2i+1 what it lets
  // through.
  localparam int unsigned NodeW = RAYDEPTH + 1;
  typedef struct packed {
    logic [CoordW-1:0]  home_x;
    logic [CoordW-1:0]  home_y;
    logic [NodeW-1:0]   node;
    logic               in_glass;
    logic [WeightW-1:0] weight;
    logic [PlaceW-1:0]  ox;
    logic [PlaceW-1:0]  oy;
    logic [PlaceW-1:0]  oz;
    logic [DirW-1:0]    dx;
    logic [DirW-1:0]    dy;
    logic [DirW-1:0]    dz;
  } start_t;
  localparam int unsigned StartW = 2 * CoordW + NodeW + 1 + WeightW + 3 * PlaceW + 3 * DirW;

  // A ray on its way, with the plane that it last could have stopped at.
  typedef struct packed {
    logic [StartW-1:0]    start;
    logic [DecisionW-1:0] decision;  // E < 0: on through the side in x
    logic [RiseW-1:0]     exit_x;
    logic [RiseW-1:0]     exit_y;
    logic [RiseW-1:0]     slope_x;
    logic [RiseW-1:0]     slope_y;
    logic [CoordW-1:0]    z;
    logic                 along_y;  // the way from the cell that has probed it
    logic                 in_room;
    logic                 touched;
    logic [CoordW-1:0]    vx;  // voxel of that plane
    logic [CoordW-1:0]    vy;
    logic [CoordW-1:0]    vz;
    logic [FaceW-1:0]     face;
  } ray_t;
  localparam int unsigned RayW = StartW + DecisionW + 4 * RiseW + 4 * CoordW + 3 + FaceW;

  // A ray that goes no further: where, and by which plane.
  typedef struct packed {
    logic [StartW-1:0] start;
    logic              escaped;  // it left the cube
    logic              rescued;  // by the safety net
    logic [CoordW-1:0] hx;  // voxel in which it stopped
    logic [CoordW-1:0] hy;
    logic [CoordW-1:0] hz;
    logic [CoordW-1:0] vx;  // voxel of the plane
    logic [CoordW-1:0] vy;
    logic [CoordW-1:0] vz;
    logic [FaceW-1:0]  face;
  } stop_t;

  // How a ray has ended.
  typedef struct packed {
    logic              escaped;  // it left the cube
    logic              rescued;  // by the safety net
    logic              back;
    logic [FacetW-1:0] facet;
    logic [CoordW-1:0] vx;
    logic [CoordW-1:0] vy;
    logic [CoordW-1:0] vz;
    logic [PlaceW-1:0] px;
    logic [PlaceW-1:0] py;
    logic [PlaceW-1:0] pz;
    logic [1:0]        too_light;  // children not sent
    logic [1:0]        too_deep;
  } end_t;
  localparam int unsigned EndW = 7 + FacetW + 3 * CoordW + 3 * PlaceW;

  // What goes home: the ray, its end, and new rays for which there was no room.
  typedef struct packed {
    logic [StartW-1:0]  start;
    logic [EndW-1:0]    ended;
    logic [PlaceW-1:0]  ex;  // where the new rays start
    logic [PlaceW-1:0]  ey;
    logic [PlaceW-1:0]  ez;
    logic               mirrored;  // there is one
    logic [WeightW-1:0] mirrored_weight;
    logic [DirW-1:0]    mx;
    logic [DirW-1:0]    my;
    logic [DirW-1:0]    mz;
    logic               cleared;  // likewise of what is let through
    logic               cleared_inside;
    logic [WeightW-1:0] cleared_weight;
    logic [DirW-1:0]    cx;
    logic [DirW-1:0]    cy;
    logic [DirW-1:0]    cz;
  } answer_t;
  localparam int unsigned AnswerW = StartW + EndW + 3 * PlaceW + 3 + 2 * WeightW + 6 * DirW;

  // A link of the network: for which queue the message is, a bit each, and the message.
  localparam int unsigned LongerW = (RayW > AnswerW) ? RayW : AnswerW;
  // In whole words of 32 bits, which simulators copy best; what nothing fills is no hardware.
  localparam int unsigned MessageW = 32 * ((LongerW + 31) / 32);
  localparam int unsigned LinkRoomW = 6;  // rays of each quadrant {south, west}, answers, starts
  localparam int unsigned LinkW = RAYS ? LinkRoomW + MessageW : 1;

  // What a cell says to those of the next rows (rc2_row), its reach in front, where a border says
  // nothing; and, apart, for it depends on nothing that is said, what it has room for.
  localparam int unsigned SpokenW = ReachW + 8 + 2 * LaneW + 2 * MatrixW + 4 + 2 * LinkW;
  localparam int unsigned RoomW = 8 + 4 * LinkRoomW;
  localparam logic [SpokenW-1:0] Silence = SpokenW'(NoReach) << (SpokenW - ReachW);

  // What a home keeps of each ray of its tree, and how many words of readback that is.
  localparam int unsigned HitW = StartW - 2 * CoordW + EndW;
  localparam int unsigned HitWords = (HitW + ValueW - 1) / ValueW;

  // What all cells hear while rays are traced.
  localparam int unsigned DepthW = 3;
  localparam int unsigned RayCountW = $clog2(RAYQ + 1);
  typedef struct packed {
    logic [DepthW-1:0]    depth;   // most bounces
    logic [WeightW-1:0]   least;   // worth of a ray that is followed
    logic [RayCountW-1:0] places;  // of each queue in use, 1 .. RAYQ
  } limits_t;
  localparam int unsigned LimitsW = DepthW + WeightW + RayCountW;

  // ---- Directions: 0 E, 1 NE, 2 N, 3 NW, 4 W, 5 SW, 6 S, 7 SE; x grows east, y north ----------
  // The opposite of d is (d + 4) mod 8. Bit d is set where direction d has that component.
  localparam logic [7:0] Eastward = 8'b1000_0011;
  localparam logic [7:0] Northward = 8'b0000_1110;
  localparam logic [7:0] Westward = 8'b0011_1000;
  localparam logic [7:0] Southward = 8'b1110_0000;

endpackage
