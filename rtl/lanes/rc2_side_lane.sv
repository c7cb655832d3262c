// SPDX-License-Identifier: Apache-2.0
//
// The cell's part of the side lanes: light towards the x and y faces. A side beam is at a whole
// column at once: its V targets are an interval, its U targets a set of classes (rc2_axis). It comes
// from the neighbour towards the light in the same row or column, or from the diagonal one, and goes
// outward in the same two ways, so a beam's way never turns back and nobody waits for a neighbour
// that waits for him. Each of the two has a FIFO here.
//
// A hop takes two cycles. First the heads of the FIFOs, joined if they are at the same V targets,
// become the beam that is served; then that beam is cut at the column's stops (rc2_stops): in each
// cycle one interval of free targets goes on, to all who get a part of it or to none. room_i tells
// which neighbours have a free place; what is sent to them is in their FIFO in the next cycle.

module rc2_side_lane (
    /*verilator tracing_off*/
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              start_i,
    input  rc2_pkg::light_t                   light_i,
    input  logic        [rc2_pkg::CoordW-1:0] x_i,
    input  logic        [rc2_pkg::CoordW-1:0] y_i,
    input  logic signed [rc2_pkg::OffW-1:0] dx_i,       // from the light
    input  logic signed [rc2_pkg::OffW-1:0] dy_i,
    input  logic        [rc2_pkg::CountW-1:0] step_i,     // the larger of the two, as a distance
    input  rc2_pkg::pace_t                    pace_i,
    input  rc2_pkg::cut_t                     along_x_i,  // classes of this step's x targets
    input  rc2_pkg::cut_t                     along_y_i,
    input  logic        [rc2_pkg::N-1:0] stops_i,
    // layers in which light can still meet something, if there are any; what counts is what the cell
    // knows in the cycle before it is told of its step
    input  logic                              beyond_i,
    input  logic        [rc2_pkg::CoordW-1:0] low_i,
    input  logic        [rc2_pkg::CoordW-1:0] high_i,
    // links, bit d for direction d of rc2_pkg
    input  logic        [7:0] valid_i,
    input  rc2_pkg::lane_t                    straight_i,
    input  rc2_pkg::lane_t                    diagonal_i,
    output logic        [7:0] room_o,
    output logic        [7:0] valid_o,
    output rc2_pkg::lane_t                    straight_o,
    output rc2_pkg::lane_t                    diagonal_o,
    input  logic        [7:0] room_i,
    // voxels that light reaches
    output logic        [rc2_pkg::N-1:0] marks_o,
    // what happens in this cycle, for who counts: the classes of the side beams are here; a beam
    // is chosen and clipped to what is worth while; a beam is served
    output logic                              here_o,
    output logic        [3:0] ways_o,     // in the cube: {y down, y up, x down, x up}
    output logic                              load_o,
    output rc2_pkg::lane_t                    load_beam_o,
    output rc2_pkg::lane_t                    loaded_o,
    output logic                              left_o,      // something is left of it
    output logic                              serve_o,
    output rc2_pkg::lane_t                    served_o,
    /*verilator tracing_on*/
    output logic signed [rc2_pkg::StopW-1:0] free_min_o,
    output logic signed [rc2_pkg::StopW-1:0] free_max_o,
    /*verilator tracing_off*/
    output logic signed [rc2_pkg::StopW-1:0] end_o,
    output logic        [rc2_pkg::QueueW-1:0] queue_o,
    output logic                              busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned M = rc2_pkg::ClassM;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned OffW = rc2_pkg::OffW;
  localparam int unsigned StopW = rc2_pkg::StopW;
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned LaneW = rc2_pkg::LaneW;
  localparam int unsigned Depth = (rc2_pkg::FAMAX + 1) / 2;
  localparam int unsigned DepthW = $clog2(Depth + 1);
  localparam int unsigned QueueW = rc2_pkg::QueueW;
  localparam logic [CoordW-1:0] Last = CoordW'(N - 1);

  logic source;
  assign source = (step_i == 0);

  // ---- This light's classes here -----------------------------------------------------------------
  // Those of the step in which side beams come by, from the cycle on in which they are there.
  logic here, set_q;
  rc2_pkg::cut_t along_x_q, along_y_q;
  assign here = pace_i.active && pace_i.first && (pace_i.step == step_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) set_q <= 1'b0;
    else if (here) set_q <= 1'b1;
    if (here) begin
      along_x_q <= along_x_i;
      along_y_q <= along_y_i;
    end
  end

  // ---- FIFOs -------------------------------------------------------------------------------------
  logic [DepthW-1:0] limit, straight_count, diagonal_count;
  logic straight_push, diagonal_push, straight_pop, diagonal_pop;
  logic [LaneW-1:0] straight_bits, diagonal_bits;
  rc2_pkg::lane_t straight, diagonal;
  assign limit = DepthW'((light_i.fa + 1'b1) >> 1);
  assign straight_push = ((valid_i & 8'b0101_0101) != 0);
  assign diagonal_push = ((valid_i & 8'b1010_1010) != 0);
  rc2_fifo #(
      .Width(LaneW),
      .Depth(Depth)
  ) u_straight (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .push_i (straight_push),
      .data_i (straight_i),
      .pop_i  (straight_pop),
      .data_o (straight_bits),
      .count_o(straight_count)
  );
  rc2_fifo #(
      .Width(LaneW),
      .Depth(Depth)
  ) u_diagonal (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .push_i (diagonal_push),
      .data_i (diagonal_i),
      .pop_i  (diagonal_pop),
      .data_o (diagonal_bits),
      .count_o(diagonal_count)
  );
  for (genvar d = 0; d < 8; d++) begin : g_room
    assign room_o[d] = ((d % 2 == 0) ? straight_count : diagonal_count) < limit;
  end

  // What went straight was numbered without those that come diagonally. Beside the light's row and
  // column, what comes diagonally went to the other side too, where there may be nothing to come.
  rc2_pkg::lane_t straight_head, diagonal_head;
  logic [rc2_pkg::ClassW-1:0] straight_come, diagonal_come;
  assign straight_head = straight_bits;
  assign diagonal_head = diagonal_bits;
  assign straight_come = straight_head.along_y ? along_x_q.come : along_y_q.come;
  assign diagonal_come = diagonal_head.along_y ? along_x_q.come : along_y_q.come;
  always_comb begin
    straight = straight_head;
    straight.classes = straight_head.classes << straight_come;
    diagonal = diagonal_head;
    for (int i = 0; i < M; i++) begin
      if (rc2_pkg::ClassW'(i) >= diagonal_come) diagonal.classes[i] = 1'b0;
    end
  end

  // ---- The next beam -----------------------------------------------------------------------------
  logic beam_q, free, load, both, joined, straight_first;
  /*verilator tracing_on*/
  rc2_pkg::lane_t beam;
  /*verilator tracing_off*/
  rc2_pkg::lane_t chosen, clipped;
  logic signed [StopW-1:0] clip_min, clip_max;
  assign both = (straight_count != 0) && (diagonal_count != 0);
  assign joined = both && (straight.vmin == diagonal.vmin) && (straight.vmax == diagonal.vmax);
  assign straight_first = (diagonal_count == 0) ||
      ((straight_count != 0) &&
       (($signed(straight.vmin) < $signed(diagonal.vmin)) ||
        ((straight.vmin == diagonal.vmin) && ($signed(straight.vmax) < $signed(diagonal.vmax)))));
  assign load = set_q && free && (straight_count != 0 || diagonal_count != 0);
  assign straight_pop = load && (joined || straight_first);
  assign diagonal_pop = load && (joined || !straight_first);
  always_comb begin
    chosen = straight_first ? straight : diagonal;
    if (joined) chosen.classes = straight.classes | diagonal.classes;
    clipped = chosen;
    if (StopW'($signed(chosen.vmin)) < clip_min) clipped.vmin = TargetW'(clip_min);
    if (StopW'($signed(chosen.vmax)) > clip_max) clipped.vmax = TargetW'(clip_max);
  end
  logic left;
  assign left = ($signed(clipped.vmin) <= $signed(clipped.vmax));

  // ---- The beam that is served -------------------------------------------------------------------
  /*verilator tracing_on*/
  logic serve;
  /*verilator tracing_off*/
  logic known, go, passes, more;
  logic signed [StopW-1:0] free_min, free_max, last, end_all;
  logic stops_busy;
  rc2_stops u_stops (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .start_i   (start_i),
      .set_i     (pace_i.tell && (pace_i.tell_step == step_i)),
      .step_i    (step_i),
      .ratio_i   (pace_i.ratio),
      .slope_i   (pace_i.slope),
      .zs_i      (light_i.zs),
      .distance_i(light_i.distance),
      .stops_i   (stops_i),
      .beyond_i  (beyond_i),
      .low_i     (low_i),
      .high_i    (high_i),
      .clip_min_o(clip_min),
      .clip_max_o(clip_max),
      .ask_i     (beam_q),
      .min_i     ($signed(beam.vmin)),
      .max_i     ($signed(beam.vmax)),
      .known_o   (known),
      .free_min_o(free_min),
      .free_max_o(free_max),
      .end_o     (end_all),
      .mark_i    (serve && !source),
      .marks_o   (marks_o),
      .busy_o    (stops_busy)
  );
  // The light's own voxel is free, and all its beams are in it.
  logic signed [StopW-1:0] beam_min, beam_max;
  assign beam_min = StopW'($signed(beam.vmin));
  assign beam_max = StopW'($signed(beam.vmax));
  assign free_min_o = source ? beam_min : free_min;
  assign free_max_o = source ? beam_max : free_max;
  assign last = source ? beam_max : end_all;
  assign end_o = last;
  assign passes = (free_min_o <= free_max_o);
  assign more = (last < beam_max);

  // ---- Its children ------------------------------------------------------------------------------
  rc2_pkg::cut_t cut;
  logic [M-1:0] stays, leaves;
  logic ahead_up, ahead_down, aside_up, aside_down;  // ways that are outward and in the cube
  logic straight_some, up_some, down_some;
  logic x_up, x_down, y_up, y_down;
  assign cut = beam.along_y ? along_x_q : along_y_q;
  assign here_o = here;
  assign ways_o = {y_down, y_up, x_down, x_up};
  assign x_up = !dx_i[OffW-1] && (x_i != Last);
  assign x_down = (dx_i <= 0) && (x_i != 0);
  assign y_up = !dy_i[OffW-1] && (y_i != Last);
  assign y_down = (dy_i <= 0) && (y_i != 0);
  assign ahead_up = beam.along_y ? y_up : x_up;
  assign ahead_down = beam.along_y ? y_down : x_down;
  assign aside_up = beam.along_y ? x_up : y_up;
  assign aside_down = beam.along_y ? x_down : y_down;
  for (genvar i = 0; i < M; i++) begin : g_stays
    assign stays[i] = beam.classes[i] && (rc2_pkg::ClassW'(i) < cut.stay);
  end
  assign leaves = beam.classes >> cut.leave;
  assign straight_some = (stays != 0);
  assign up_some = aside_up && ((cut.up && leaves != 0) || beam.edge_u);
  assign down_some = aside_down && ((cut.down && leaves != 0) || beam.edge_u);

  // For a beam along x: ahead is x, aside is y; else the other way round.
  logic [7:0] wanted;
  assign wanted[0] = beam.along_y ? 1'b0 : ahead_up && straight_some;
  assign wanted[4] = beam.along_y ? 1'b0 : ahead_down && straight_some;
  assign wanted[2] = beam.along_y ? ahead_up && straight_some : 1'b0;
  assign wanted[6] = beam.along_y ? ahead_down && straight_some : 1'b0;
  assign wanted[1] = ahead_up && up_some;
  assign wanted[3] = beam.along_y ? ahead_up && down_some : ahead_down && up_some;
  assign wanted[5] = ahead_down && down_some;
  assign wanted[7] = beam.along_y ? ahead_down && up_some : ahead_up && down_some;

  assign go = !passes || ((wanted & ~room_i) == 0);
  assign serve = beam_q && set_q && (source || known) && go;
  assign valid_o = (serve && passes) ? wanted : 8'd0;
  always_comb begin
    straight_o.along_y = beam.along_y;
    straight_o.vmin    = TargetW'(free_min_o);
    straight_o.vmax    = TargetW'(free_max_o);
    straight_o.edge_u  = 1'b0;
    straight_o.classes = stays;
    diagonal_o         = straight_o;
    diagonal_o.edge_u  = beam.edge_u;
    diagonal_o.classes = leaves;
  end

  // ---- State -------------------------------------------------------------------------------------
  logic [TargetW-1:0] far;
  assign far = TargetW'(light_i.distance);
  logic second_q;  // the light's beam along y is still to come
  assign free = !beam_q || (serve && !more && !second_q);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      beam_q   <= 1'b0;
      second_q <= 1'b0;
    end else if (start_i) begin
      beam_q   <= source;
      second_q <= source;
    end else begin
      if (load) beam_q <= left;
      else if (serve) beam_q <= more || second_q;
      if (serve) second_q <= 1'b0;
    end
    if (start_i) begin
      beam.along_y <= 1'b0;
      beam.vmin    <= -far;
      beam.vmax    <= far;
      beam.edge_u  <= 1'b1;
      beam.classes <= M'(1);
    end else if (load) begin
      beam <= clipped;
    end else if (serve) begin
      if (second_q) begin
        beam.along_y <= 1'b1;
        beam.edge_u  <= 1'b0;
      end else begin
        beam.vmin <= TargetW'(last + 1'b1);
      end
    end
  end

  assign load_o = load;
  assign load_beam_o = chosen;
  assign loaded_o = clipped;
  assign left_o = left;
  assign serve_o = serve;
  assign served_o = beam;
  assign queue_o = QueueW'(straight_count) + QueueW'(diagonal_count) + QueueW'(beam_q);
  assign busy_o = (queue_o != 0) || stops_busy;
endmodule
