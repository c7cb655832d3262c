// SPDX-License-Identifier: Apache-2.0
//
// An instrument, for machines built with COUNTS: how many targets arrive at each voxel of a column,
// and how many end their way in this cell, on their way home to the root as in rc2_tally. It looks on
// and slows nobody down; what it costs is not part of the cell. Where a target is it works out by
// division, not by the cell's ratios and slopes.

module rc2_counts (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              start_i,
    input  rc2_pkg::light_t                   light_i,
    input  logic        [rc2_pkg::CountW-1:0] step_i,    // of the side beams here
    input  logic        [rc2_pkg::N-1:0] occupied_i,
    // targets of the classes of this step: all, and those that stay in the cube
    input  logic                              here_i,    // side beams come by in this step
    input  logic        [rc2_pkg::WeightsW-1:0] x_all_i,
    input  logic        [rc2_pkg::WeightsW-1:0] x_kept_i,
    input  logic        [rc2_pkg::WeightsW-1:0] y_all_i,
    input  logic        [rc2_pkg::WeightsW-1:0] y_kept_i,
    // the z lane
    input  logic        [rc2_pkg::MatrixW-1:0] front_i,
    input  logic                              reached_i,
    input  logic                              stopped_i,
    input  logic                              dropped_i,
    input  logic                              last_i,
    input  logic        [rc2_pkg::CoordW-1:0] z_i,
    // the side lane
    input  logic                              load_i,
    input  rc2_pkg::lane_t                    load_beam_i,
    input  rc2_pkg::lane_t                    loaded_i,
    input  logic                              left_i,      // something is left of it
    input  logic                              serve_i,
    input  rc2_pkg::lane_t                    served_i,
    input  logic signed [rc2_pkg::StopW-1:0] free_min_i,
    input  logic signed [rc2_pkg::StopW-1:0] free_max_i,
    input  logic signed [rc2_pkg::StopW-1:0] end_i,
    input  logic        [3:0] ways_i,    // in the cube: {y down, y up, x down, x up}
    // readback
    input  logic        [rc2_pkg::CoordW-1:0] read_addr_i,
    output logic        [rc2_pkg::HomeW-1:0] count_o,   // of the address in the cycle before
    output logic        [rc2_pkg::HomeW-1:0] ends_o,    // targets that ended in voxels of the column
    // targets on their way home
    input  logic        [rc2_pkg::HomeW-1:0] home_i,
    output logic        [rc2_pkg::HomeW-1:0] home_o,
    input  logic        [rc2_pkg::HomeW-1:0] skipped_i,   // those of them that were skipped
    output logic        [rc2_pkg::HomeW-1:0] skipped_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned M = rc2_pkg::ClassM;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam int unsigned WeightsW = rc2_pkg::WeightsW;
  localparam int unsigned ExtentW = rc2_pkg::ExtentW;

  // ---- Targets of the z lane's front ---------------------------------------------------------------
  logic [HomeW-1:0] front_all, front_kept;
  always_comb begin
    front_all  = '0;
    front_kept = '0;
    for (int i = 0; i < M; i++) begin
      for (int j = 0; j < M; j++) begin
        if (front_i[i*M+j]) begin
          front_all = front_all + HomeW'(x_all_i[i*ExtentW+:ExtentW]) * HomeW'(y_all_i[j*ExtentW+:ExtentW]);
          front_kept = front_kept + HomeW'(x_kept_i[i*ExtentW+:ExtentW]) * HomeW'(y_kept_i[j*ExtentW+:ExtentW]);
        end
      end
    end
  end

  // ---- U targets of side beams ---------------------------------------------------------------------
  logic source;
  logic [WeightsW-1:0] x_all_q, x_kept_q, y_all_q, y_kept_q;
  logic [HomeW-1:0] load_all, served_all, served_kept, ahead, aside, faces;
  assign source = (step_i == 0);
  assign faces = source ? HomeW'(2) : HomeW'(1);
  assign ahead = served_i.along_y ? HomeW'(ways_i[2]) + HomeW'(ways_i[3]) : HomeW'(ways_i[0]) + HomeW'(ways_i[1]);
  assign aside = served_i.along_y ? HomeW'(ways_i[0]) + HomeW'(ways_i[1]) : HomeW'(ways_i[2]) + HomeW'(ways_i[3]);
  logic [WeightsW-1:0] load_weights, all_weights, kept_weights;
  assign load_weights = load_beam_i.along_y ? x_all_q : y_all_q;
  assign all_weights = served_i.along_y ? x_all_q : y_all_q;
  assign kept_weights = served_i.along_y ? x_kept_q : y_kept_q;
  always_comb begin
    load_all    = load_beam_i.edge_u ? faces : '0;
    served_all  = served_i.edge_u ? faces : '0;
    served_kept = served_i.edge_u ? aside : '0;
    for (int i = 0; i < M; i++) begin
      if (load_beam_i.classes[i]) begin
        load_all = load_all + HomeW'(load_weights[i*ExtentW+:ExtentW]);
      end
      if (served_i.classes[i]) begin
        served_all = served_all + HomeW'(all_weights[i*ExtentW+:ExtentW]);
        served_kept = served_kept + HomeW'(kept_weights[i*ExtentW+:ExtentW]);
      end
    end
  end

  // ---- V targets -------------------------------------------------------------------------------------
  logic signed [31:0] served_min, served_end, served_v, free_v, load_min, load_max, load_v, loaded_v;
  assign served_min = 32'($signed(served_i.vmin));
  assign served_end = 32'(end_i);
  assign served_v = served_end - served_min + 32'd1;
  assign free_v = (free_max_i >= free_min_i) ? 32'(free_max_i) - 32'(free_min_i) + 32'd1 : 32'd0;
  assign load_min = 32'($signed(load_beam_i.vmin));
  assign load_max = 32'($signed(load_beam_i.vmax));
  assign load_v = load_max - load_min + 32'd1;
  assign loaded_v = !left_i ? 32'd0 :
      32'($signed(loaded_i.vmax)) - 32'($signed(loaded_i.vmin)) + 32'd1;
  // Those in the cube.
  logic signed [31:0] cube_min, cube_max, inside_min, inside_max, inside_v;
  assign inside_min = (load_min < cube_min) ? cube_min : load_min;
  assign inside_max = (load_max > cube_max) ? cube_max : load_max;
  assign inside_v = (inside_max >= inside_min) ? inside_max - inside_min + 32'd1 : 32'd0;

  logic [HomeW-1:0] done, done_q, home_q, dropped, dropped_q, skipped_q, ends_q;
  always_comb begin
    done = '0;
    dropped = '0;
    if (stopped_i || dropped_i || (reached_i && last_i)) done = front_all;
    else if (reached_i) done = front_all - front_kept;
    if (dropped_i) dropped = front_all;
    if (serve_i) done = done + served_all * faces * HomeW'(served_v) - served_kept * ahead * HomeW'(free_v);
    if (load_i) begin
      done = done + load_all * HomeW'(load_v - loaded_v);
      dropped = dropped + load_all * HomeW'(inside_v - loaded_v);
    end
  end

  // ---- Arrivals --------------------------------------------------------------------------------------
  logic signed [31:0] steps, distance;
  assign steps = 32'(step_i);
  assign distance = 32'(light_i.distance);
  logic [HomeW-1:0] count_q[0:N-1];
  for (genvar z = 0; z < N; z++) begin : g_voxel
    // Twice the voxel's lower and upper border, as offsets from the light.
    logic signed [31:0] low, high, low_target, high_target, first, end_of;
    logic [HomeW-1:0] side, lane;
    if (z == 0) assign cube_min = low_target + 32'sd1;
    if (z == N - 1) assign cube_max = high_target;
    assign low = 32'sd2 * (32'(z) - $signed(32'(light_i.zs))) - 32'sd1;
    assign high = low + 32'sd2;
    // The last target at or below a border, rounded down; dividends are made positive.
    assign low_target = source ? 32'sd0 : (low * distance + 32'sd4 * steps * distance) / (32'sd2 * steps) - 32'sd2 * distance;
    assign high_target = source ? 32'sd0 : (high * distance + 32'sd4 * steps * distance) / (32'sd2 * steps) - 32'sd2 * distance;
    assign first = (low_target + 32'sd1 > served_min) ? low_target + 32'sd1 : served_min;
    assign end_of = (high_target < served_end) ? high_target : served_end;
    assign side = (serve_i && !source && occupied_i[z] && end_of >= first) ?
        served_all * HomeW'(end_of - first + 32'sd1) : '0;
    assign lane = (reached_i && occupied_i[z] && z_i == CoordW'(z)) ? front_all : '0;
    always_ff @(posedge clk_i) begin
      if (start_i) count_q[z] <= '0;
      else count_q[z] <= count_q[z] + side + lane;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      done_q    <= '0;
      home_q    <= '0;
      dropped_q <= '0;
      skipped_q <= '0;
    end else begin
      done_q    <= done;
      home_q    <= home_i + done_q;
      dropped_q <= dropped;
      skipped_q <= skipped_i + dropped_q;
    end
    if (here_i) begin
      x_all_q  <= x_all_i;
      x_kept_q <= x_kept_i;
      y_all_q  <= y_all_i;
      y_kept_q <= y_kept_i;
    end
    if (start_i) ends_q <= '0;
    else
      ends_q <= ends_q + (stopped_i ? front_all : '0) +
                (serve_i ? served_all * HomeW'(served_v - free_v) : '0);
    count_o <= count_q[read_addr_i];
  end
  assign home_o = home_q;
  assign skipped_o = skipped_q;
  assign ends_o = ends_q;
endmodule
