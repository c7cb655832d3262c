// SPDX-License-Identifier: Apache-2.0
//
// The stops of a column, seen as V targets: what a side beam needs to know of it, in comparisons
// only. All side beams of a light meet the column after the same number of steps k, so each run of
// stopping voxels is one interval of targets (rc2_border). A table holds RUNS of them; a column with
// more has it filled anew from the voxel that a beam asks for.
//
// set_i gives k. The clip is known two cycles later, the table can be used three cycles later and
// one more for each run in it. A miss costs two cycles more. The same two multipliers mark the
// voxels that a served beam lights, two cycles after it is served.

module rc2_stops (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              start_i,
    input  logic                              set_i,
    input  logic        [rc2_pkg::CountW-1:0] step_i,   // k, steady
    input  logic        [rc2_pkg::RatioW-1:0] ratio_i,  // L/2k
    input  logic        [rc2_pkg::SlopeW-1:0] slope_i,  // k/L
    input  logic        [rc2_pkg::CoordW-1:0] zs_i,
    input  logic        [rc2_pkg::DistanceW-1:0] distance_i,
    input  logic        [rc2_pkg::N-1:0] stops_i,
    // layers in which light can still meet something, if there are any: those in the cycle before set_i
    input  logic                              beyond_i,
    input  logic        [rc2_pkg::CoordW-1:0] low_i,
    input  logic        [rc2_pkg::CoordW-1:0] high_i,
    // targets that are in those layers here
    output logic signed [rc2_pkg::StopW-1:0] clip_min_o,
    output logic signed [rc2_pkg::StopW-1:0] clip_max_o,
    // what becomes of targets min_i .. max_i, see StopTable::Passage in sw/cycle/stop_table.h
    input  logic                              ask_i,
    input  logic signed [rc2_pkg::TargetW-1:0] min_i,
    input  logic signed [rc2_pkg::TargetW-1:0] max_i,
    output logic                              known_o,
    output logic signed [rc2_pkg::StopW-1:0] free_min_o,
    output logic signed [rc2_pkg::StopW-1:0] free_max_o,
    output logic signed [rc2_pkg::StopW-1:0] end_o,
    // voxels that targets min_i .. end_o reach
    input  logic                              mark_i,
    output logic        [rc2_pkg::N-1:0] marks_o,
    output logic                              busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned StopW = rc2_pkg::StopW;
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam int unsigned RUNS = rc2_pkg::RUNS;
  localparam int unsigned RunsW = $clog2(RUNS + 1);
  localparam int unsigned OddW = CoordW + 2;
  localparam int unsigned WideW = CoordW + 3;  // offsets of voxels from the light, signed
  localparam int unsigned OffW = rc2_pkg::OffW;

  typedef enum logic [2:0] {
    Idle, Find, Fill, Ready, Locate
  } state_e;
  state_e state_q;

  logic [rc2_pkg::RatioW-1:0] ratio_q;
  logic [rc2_pkg::SlopeW-1:0] slope_q;
  logic signed [StopW-1:0] clip_min_q, clip_max_q, known_min_q;
  logic clipped_q;
  assign clip_min_o = clip_min_q;
  assign clip_max_o = clip_max_q;

  // ---- The voxels that rays can be at, as far as it is worth while ---------------------------------
  logic signed [WideW-1:0] source_z, steps, lowest, highest, low, high;
  logic [CountW-1:0] first_z, last_z, from_q, last_q;
  logic some, some_q;
  assign source_z = WideW'(zs_i);
  assign steps = WideW'(step_i);
  assign lowest = source_z - steps;
  assign highest = source_z + steps;
  assign low = WideW'(low_i);
  assign high = WideW'(high_i);
  // A register takes them off the search's path.
  always_ff @(posedge clk_i) begin
    first_z <= (lowest < low) ? CountW'(low) : CountW'(lowest);
    last_z  <= (highest > high) ? CountW'(high) : CountW'(highest);
    some    <= beyond_i && (low <= highest) && (lowest <= high);
  end

  // ---- Runs --------------------------------------------------------------------------------------
  logic run_found, run_q, run_here;
  logic [CountW-1:0] run_first, run_end, run_first_q, run_end_q;
  rc2_run u_run (
      .stops_i(stops_i),
      .from_i ((state_q == Find) ? from_q : run_end_q),
      .found_o(run_found),
      .first_o(run_first),
      .end_o  (run_end)
  );
  assign run_here = run_found && (run_first <= last_q);

  // ---- From voxels to targets: the lowest target at or above a voxel, and of the one above it ----
  logic [CountW-1:0] low_voxel, high_voxel;
  logic signed [WideW-1:0] low_z, high_z;
  assign low_voxel = (state_q == Find) ? from_q : run_first_q;
  assign high_voxel = (state_q == Find) ? last_q + 1'b1 : run_end_q;
  assign low_z = WideW'(low_voxel) - source_z;
  assign high_z = WideW'(high_voxel) - source_z;
  logic signed [StopW-1:0] low_border, high_border, low_target, high_target, far;
  rc2_border u_low (
      .odd_i  (OddW'({low_z, 1'b1} - (WideW + 1)'(2))),
      .ratio_i(ratio_q),
      .last_o (low_border)
  );
  rc2_border u_high (
      .odd_i  (OddW'({high_z, 1'b1} - (WideW + 1)'(2))),
      .ratio_i(ratio_q),
      .last_o (high_border)
  );
  assign far = $signed(StopW'(distance_i));
  // No run begins above the voxels that rays can be at, and none ends below them.
  assign low_target = (low_z <= -steps) ? -far : low_border + 1'b1;
  assign high_target = (high_z > steps) ? far + 1'b1 : high_border + 1'b1;

  // ---- The table ---------------------------------------------------------------------------------
  logic [RunsW-1:0] count_q;
  logic partial_q;
  logic signed [StopW-1:0] run_min_q[0:RUNS-1];
  logic signed [StopW-1:0] run_max_q[0:RUNS-1];
  logic fill;
  assign fill = (state_q == Fill) && run_q && (count_q != RunsW'(RUNS));

  // ---- A beam's question -------------------------------------------------------------------------
  logic signed [StopW-1:0] from, upto, last;
  logic [RUNS-1:0] holds, above, next;
  assign from = StopW'(min_i);
  assign upto = partial_q ? run_max_q[RUNS-1] : far;
  assign last = (StopW'(max_i) < upto) ? StopW'(max_i) : upto;
  assign known_o = (state_q == Ready) && (from >= known_min_q) && (from <= upto);
  for (genvar i = 0; i < RUNS; i++) begin : g_compare
    logic here;
    assign here = (RunsW'(i) < count_q);
    assign holds[i] = here && (run_min_q[i] <= from) && (from <= run_max_q[i]);
    assign above[i] = here && (run_min_q[i] > from);
  end
  assign next = above & (~above + 1'b1);
  logic signed [StopW-1:0] hold_max, next_min, next_max;
  always_comb begin
    hold_max = '0;
    next_min = '0;
    next_max = '0;
    for (int i = 0; i < RUNS; i++) begin
      if (holds[i]) hold_max = hold_max | run_max_q[i];
      if (next[i]) next_min = next_min | run_min_q[i];
      if (next[i]) next_max = next_max | run_max_q[i];
    end
  end
  assign free_min_o = (holds != 0) ? hold_max + 1'b1 : from;
  assign free_max_o = (next != 0 && next_min <= last) ? next_min - 1'b1 : last;
  assign end_o = (next != 0 && next_max < last) ? next_max : last;

  // ---- Marks: targets -> voxels ------------------------------------------------------------------
  logic marking_q, marked_q;
  logic signed [TargetW-1:0] mark_min_q, mark_max_q;
  logic signed [OffW-1:0] mark_low, mark_high;
  logic [CoordW-1:0] low_q, high_q;
  rc2_place u_first (
      .target_i((state_q == Locate) ? min_i : mark_min_q),
      .slope_i (slope_q),
      .offset_o(mark_low)
  );
  rc2_place u_last (
      .target_i(mark_max_q),
      .slope_i (slope_q),
      .offset_o(mark_high)
  );
  assign marks_o = !marked_q ? '0 :
      ({N{1'b1}} << low_q) & ({N{1'b1}} >> (CoordW'(N - 1) - high_q));
  assign busy_o = marking_q || marked_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q   <= Idle;
      marking_q <= 1'b0;
      marked_q  <= 1'b0;
    end else begin
      case (state_q)
        Find:    state_q <= Fill;
        Fill:    if (!fill) state_q <= Ready;
        Ready:   if (ask_i && !known_o) state_q <= Locate;
        Locate:  state_q <= Find;
        default: ;
      endcase
      if (start_i) state_q <= Idle;
      if (set_i) state_q <= Find;
      marking_q <= mark_i;
      marked_q  <= marking_q;
    end

    if (set_i) begin
      ratio_q   <= ratio_i;
      slope_q   <= slope_i;
      from_q    <= first_z;
      last_q    <= last_z;
      some_q    <= some;
      clipped_q <= 1'b0;
    end
    if (state_q == Find) begin
      count_q     <= '0;
      clipped_q   <= 1'b1;
      known_min_q <= low_target;
      if (!clipped_q) begin
        clip_min_q <= some_q ? low_target : '0;
        clip_max_q <= some_q ? high_target - 1'b1 : '1;  // -1
      end
    end
    if (state_q == Find || fill) begin
      run_q       <= run_here;
      run_first_q <= run_first;
      run_end_q   <= run_end;
    end
    if (fill) begin
      count_q <= count_q + 1'b1;
      for (int i = 0; i < RUNS; i++) begin
        if (count_q == RunsW'(i)) begin
          run_min_q[i] <= low_target;
          run_max_q[i] <= high_target - 1'b1;
        end
      end
    end
    if (state_q == Fill) partial_q <= run_q;
    if (state_q == Locate) from_q <= CountW'($signed(CountW'(zs_i)) + CountW'(mark_low));

    mark_min_q <= min_i;
    mark_max_q <= TargetW'(end_o);
    low_q      <= zs_i + CoordW'(mark_low);
    high_q     <= zs_i + CoordW'(mark_high);
  end
endmodule
