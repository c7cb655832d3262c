// SPDX-License-Identifier: Apache-2.0
//
// One cell (thesis 1.3) with light in lanes: a column of voxels, a side lane towards the x and y
// faces, two z lanes. A hop of light takes two cycles (P = 2).
//
// Every port that leaves the cell comes from a register or depends on the cell's own state and
// inputs only; no room depends on a neighbour's. Coordinates are ports, so that the whole array is
// one module, and the cell calls no function: with rtl/rc2.vlt that lets Verilator share one body
// among all cells. A waveform shows what the tracing marks let through: of 256 cells one wants the
// story, not every wire.

module rc2_cell (
    /*verilator tracing_off*/
    input  logic                               clk_i,
    input  logic                               rst_ni,
    input  logic           [rc2_pkg::CoordW-1:0] x_i,
    input  logic           [rc2_pkg::CoordW-1:0] y_i,
    input  logic                               clear_i,
    input  logic                               prepare_i,
    input  logic                               start_i,
    input  logic                               accurate_i,
    input  rc2_pkg::light_t                    light_i,
    input  logic                               ray_clear_i,
    input  logic                               ray_start_i,
    input  rc2_pkg::limits_t                   limits_i,
    // row pipe: from the west, to the east
    /*verilator tracing_on*/
    input  logic                               word_valid_i,
    input  logic           [rc2_pkg::RowWordW-1:0] word_i,
    /*verilator tracing_off*/
    output logic                               word_ready_o,
    output logic                               word_valid_o,
    output logic           [rc2_pkg::RowWordW-1:0] word_o,
    input  logic                               word_ready_i,
    // what all cells hear, and those of this column and row
    input  rc2_pkg::pace_t                     pace_i,
    input  rc2_pkg::cut_t                      x_cut_i,
    input  rc2_pkg::cut_t                      y_cut_i,
    input  logic           [rc2_pkg::ClassW-1:0] x_come_i,
    input  logic           [rc2_pkg::ClassW-1:0] y_come_i,
    input  logic           [rc2_pkg::WeightsW-1:0] x_all_i,
    input  logic           [rc2_pkg::WeightsW-1:0] x_kept_i,
    input  logic           [rc2_pkg::WeightsW-1:0] y_all_i,
    input  logic           [rc2_pkg::WeightsW-1:0] y_kept_i,
    // side lane, bit d for direction d: E NE N NW W SW S SE. An input of direction d comes from there.
    /*verilator tracing_on*/
    input  logic           [               7:0] side_valid_i,
    output logic           [               7:0] side_room_o,
    /*verilator tracing_off*/
    input  rc2_pkg::lane_t                     side0_i,
    input  rc2_pkg::lane_t                     side1_i,
    input  rc2_pkg::lane_t                     side2_i,
    input  rc2_pkg::lane_t                     side3_i,
    input  rc2_pkg::lane_t                     side4_i,
    input  rc2_pkg::lane_t                     side5_i,
    input  rc2_pkg::lane_t                     side6_i,
    input  rc2_pkg::lane_t                     side7_i,
    /*verilator tracing_on*/
    output logic           [               7:0] side_valid_o,
    input  logic           [               7:0] side_room_i,
    /*verilator tracing_off*/
    output rc2_pkg::lane_t                     straight_o,  // for directions 0, 2, 4, 6
    output rc2_pkg::lane_t                     diagonal_o,  // for directions 1, 3, 5, 7
    // z lanes: to all neighbours along x, along y, diagonally
    input  logic           [rc2_pkg::MatrixW-1:0] z0_i,
    input  logic           [rc2_pkg::MatrixW-1:0] z1_i,
    input  logic           [rc2_pkg::MatrixW-1:0] z2_i,
    input  logic           [rc2_pkg::MatrixW-1:0] z3_i,
    input  logic           [rc2_pkg::MatrixW-1:0] z4_i,
    input  logic           [rc2_pkg::MatrixW-1:0] z5_i,
    input  logic           [rc2_pkg::MatrixW-1:0] z6_i,
    input  logic           [rc2_pkg::MatrixW-1:0] z7_i,
    output logic           [rc2_pkg::MatrixW-1:0] z_x_o,
    output logic           [rc2_pkg::MatrixW-1:0] z_y_o,
    output logic           [rc2_pkg::MatrixW-1:0] z_xy_o,
    // how far the scene reaches (rc2_extents): in each quadrant, and seen from the light
    input  logic           [               1:0] quadrants_e_i,
    input  logic           [               1:0] quadrants_n_i,
    input  logic           [               1:0] quadrants_w_i,
    input  logic           [               1:0] quadrants_s_i,
    output logic           [               3:0] quadrants_o,
    input  logic           [rc2_pkg::ReachW-1:0] reach0_i,
    input  logic           [rc2_pkg::ReachW-1:0] reach1_i,
    input  logic           [rc2_pkg::ReachW-1:0] reach2_i,
    input  logic           [rc2_pkg::ReachW-1:0] reach3_i,
    input  logic           [rc2_pkg::ReachW-1:0] reach4_i,
    input  logic           [rc2_pkg::ReachW-1:0] reach5_i,
    input  logic           [rc2_pkg::ReachW-1:0] reach6_i,
    input  logic           [rc2_pkg::ReachW-1:0] reach7_i,
    output logic           [rc2_pkg::ReachW-1:0] reach_o,
    // links of the rays, by the way that a message goes: E W N S
    input  logic           [ rc2_pkg::LinkW-1:0] ray0_i,
    input  logic           [ rc2_pkg::LinkW-1:0] ray1_i,
    input  logic           [ rc2_pkg::LinkW-1:0] ray2_i,
    input  logic           [ rc2_pkg::LinkW-1:0] ray3_i,
    output logic           [4*rc2_pkg::LinkRoomW-1:0] ray_room_o,
    output logic           [ rc2_pkg::LinkW-1:0] ray0_o,
    output logic           [ rc2_pkg::LinkW-1:0] ray1_o,
    output logic           [ rc2_pkg::LinkW-1:0] ray2_o,
    output logic           [ rc2_pkg::LinkW-1:0] ray3_o,
    input  logic           [4*rc2_pkg::LinkRoomW-1:0] ray_room_i,
    // targets on their way home: all that ended, and those of them that were skipped
    input  logic           [rc2_pkg::HomeW-1:0] home_i,
    output logic           [rc2_pkg::HomeW-1:0] home_o,
    input  logic           [rc2_pkg::HomeW-1:0] skipped_i,
    output logic           [rc2_pkg::HomeW-1:0] skipped_o,
    /*verilator tracing_on*/
    output logic                               busy_o
    /*verilator tracing_off*/
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned OffW = rc2_pkg::OffW;
  localparam int unsigned CountW = rc2_pkg::CountW;
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam int unsigned LaneW = rc2_pkg::LaneW;
  localparam int unsigned MatrixW = rc2_pkg::MatrixW;
  localparam int unsigned StopW = rc2_pkg::StopW;

  rc2_limits u_limits ();

  // ---- The column ----------------------------------------------------------------------------------
  logic voxels_busy;
  logic [N-1:0] occupied, stops;
  logic fill;
  logic [CoordW-1:0] light_addr, fill_z;
  logic [HomeW-1:0] arrived, ends;
  logic [rc2_pkg::ValueW-1:0] visits_q;
  logic [rc2_pkg::QueueW-1:0] deepest;
  logic [15:0] signature;
  logic ray_word, ray_ready, ray_reads, ray_read, ray_read_done, ray_read_taken, ray_valid, rays_busy;
  logic [rc2_pkg::KindW-1:0] ray_kind;
  logic [rc2_pkg::RestW-1:0] ray_rest;
  logic [CoordW-1:0] ray_addr;
  logic [N-1:0] solid;
  rc2_pkg::claim_t owner;
  rc2_pkg::data_t ray_data;
  /*verilator tracing_on*/
  rc2_voxels u_voxels (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .x_i         (x_i),
      .y_i         (y_i),
      .clear_i     (clear_i),
      .prepare_i   (prepare_i),
      .accurate_i  (accurate_i),
      .source_i    (light_i),
      .word_valid_i(word_valid_i),
      .word_i      (word_i),
      .word_ready_o(word_ready_o),
      .word_valid_o(word_valid_o),
      .word_o      (word_o),
      .word_ready_i(word_ready_i),
      .occupied_o  (occupied),
      .fill_o      (fill),
      .fill_z_o    (fill_z),
      .stops_o     (stops),
      .light_addr_o(light_addr),
      .light_i     (arrived),
      .ends_i      (ends),
      .visits_i    (visits_q),
      .history_i   ({signature, deepest}),
      .ray_word_o           (ray_word),
      .ray_kind_o           (ray_kind),
      .ray_rest_o           (ray_rest),
      .ray_ready_i          (ray_ready),
      .ray_reads_i          (ray_reads),
      .ray_addr_i           (ray_addr),
      .owner_o              (owner),
      .solid_o              (solid),
      .ray_read_o           (ray_read),
      .ray_read_done_i      (ray_read_done),
      .ray_read_done_taken_o(ray_read_taken),
      .ray_data_valid_i     (ray_valid),
      .ray_data_i           (ray_data),
      .busy_o      (voxels_busy)
  );
  /*verilator tracing_off*/

  // ---- Rays ----------------------------------------------------------------------------------------
  if (rc2_pkg::RAYS) begin : g_rays
    rc2_rays u_rays (
        .clk_i            (clk_i),
        .rst_ni           (rst_ni),
        .clear_i          (ray_clear_i),
        .start_i          (ray_start_i),
        .x_i              (x_i),
        .y_i              (y_i),
        .limits_i         (limits_i),
        .occupied_i       (occupied),
        .solid_i          (solid),
        .addr_o           (ray_addr),
        .reads_o          (ray_reads),
        .owner_i          (owner),
        .word_i           (ray_word),
        .kind_i           (ray_kind),
        .rest_i           (ray_rest),
        .ready_o          (ray_ready),
        .read_i           (ray_read),
        .read_done_o      (ray_read_done),
        .read_done_taken_i(ray_read_taken),
        .data_valid_o     (ray_valid),
        .data_o           (ray_data),
        .data_ready_i     (word_ready_i),
        .link_i           ({ray3_i, ray2_i, ray1_i, ray0_i}),
        .room_o           (ray_room_o),
        .link_o           ({ray3_o, ray2_o, ray1_o, ray0_o}),
        .room_i           (ray_room_i),
        .busy_o           (rays_busy)
    );
  end else begin : g_no_rays
    assign {ray_addr, ray_reads, ray_read_done, ray_valid, rays_busy} = '0;
    assign ray_ready = 1'b1;
    assign ray_data = '0;
    assign ray_room_o = '0;
    assign {ray3_o, ray2_o, ray1_o, ray0_o} = '0;
  end

  // ---- Where the cell is, seen from the light ------------------------------------------------------
  logic signed [OffW-1:0] dx, dy;
  logic [OffW-1:0] far_x, far_y;
  logic [CountW-1:0] distance;
  logic east, west, north, south;  // of the light
  assign dx = $signed({1'b0, x_i}) - $signed({1'b0, light_i.xs});
  assign dy = $signed({1'b0, y_i}) - $signed({1'b0, light_i.ys});
  assign west = dx[OffW-1];
  assign south = dy[OffW-1];
  assign east = !west && (dx != 0);
  assign north = !south && (dy != 0);
  assign far_x = west ? $unsigned(-dx) : $unsigned(dx);
  assign far_y = south ? $unsigned(-dy) : $unsigned(dy);
  assign distance = CountW'((far_x > far_y) ? far_x : far_y);

  // ---- What light can still meet here and further on ---------------------------------------------
  logic [CoordW-1:0] beyond_min, beyond_max;
  logic beyond;  // there is anything
  if (rc2_pkg::SKIPS) begin : g_extents
    rc2_extents u_extents (
        .clk_i      (clk_i),
        .rst_ni     (rst_ni),
        .clear_i    (clear_i),
        .fill_i     (fill),
        .fill_z_i   (fill_z),
        .e_i        (quadrants_e_i),
        .n_i        (quadrants_n_i),
        .w_i        (quadrants_w_i),
        .s_i        (quadrants_s_i),
        .quadrants_o(quadrants_o),
        .start_i    (start_i),
        .active_i   (pace_i.active),
        .zs_i       (light_i.zs),
        .distance_i (distance),
        .east_i     (east),
        .west_i     (west),
        .north_i    (north),
        .south_i    (south),
        .wide_i     (far_x > far_y),
        .tall_i     (far_y > far_x),
        .reach0_i   (reach0_i),
        .reach1_i   (reach1_i),
        .reach2_i   (reach2_i),
        .reach3_i   (reach3_i),
        .reach4_i   (reach4_i),
        .reach5_i   (reach5_i),
        .reach6_i   (reach6_i),
        .reach7_i   (reach7_i),
        .reach_o    (reach_o),
        .beyond_o   (beyond),
        .min_o      (beyond_min),
        .max_o      (beyond_max)
    );
  end else begin : g_anything
    assign quadrants_o = '0;
    assign reach_o = rc2_pkg::NoReach;
    assign beyond = 1'b1;
    assign beyond_min = '0;
    assign beyond_max = CoordW'(N - 1);
  end

  // ---- z lanes ---------------------------------------------------------------------------------------
  logic [MatrixW-1:0] from_x, from_y, from_xy, front;
  /*verilator tracing_on*/
  logic reached, stopped, dropped, fronts;
  logic [CoordW-1:0] z;
  /*verilator tracing_off*/
  assign from_x = east ? z4_i : z0_i;
  assign from_y = north ? z6_i : z2_i;
  assign from_xy = north ? (east ? z5_i : z7_i) : (east ? z3_i : z1_i);
  rc2_z_lanes u_z_lanes (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .start_i  (start_i),
      .source_i (distance == 0),
      .pace_i   (pace_i),
      .u_i      (x_cut_i),
      .v_i      (y_cut_i),
      .u_come_i (x_come_i),
      .v_come_i (y_come_i),
      .stops_i  (stops),
      .beyond_i (beyond),
      .min_i    (beyond_min),
      .max_i    (beyond_max),
      .x_o      (z_x_o),
      .y_o      (z_y_o),
      .xy_o     (z_xy_o),
      .x_i      (from_x),
      .y_i      (from_y),
      .xy_i     (from_xy),
      .front_o  (front),
      .reached_o(reached),
      .stopped_o(stopped),
      .dropped_o(dropped),
      .z_o      (z),
      .busy_o   (fronts)
  );

  // ---- Side lane: a beam comes from one neighbour of each kind -------------------------------------
  logic [LaneW-1:0] straight, diagonal;
  assign straight = ({LaneW{side_valid_i[0]}} & side0_i) | ({LaneW{side_valid_i[2]}} & side2_i) |
                    ({LaneW{side_valid_i[4]}} & side4_i) | ({LaneW{side_valid_i[6]}} & side6_i);
  assign diagonal = ({LaneW{side_valid_i[1]}} & side1_i) | ({LaneW{side_valid_i[3]}} & side3_i) |
                    ({LaneW{side_valid_i[5]}} & side5_i) | ({LaneW{side_valid_i[7]}} & side7_i);

  logic load, left, served, here, side_busy;
  rc2_pkg::lane_t load_beam, loaded, served_beam;
  logic signed [StopW-1:0] free_min, free_max, served_end;
  logic [N-1:0] marks;
  logic [3:0] ways;
  /*verilator tracing_on*/
  logic [rc2_pkg::QueueW-1:0] queued;
  rc2_side_lane u_side_lane (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .start_i    (start_i),
      .light_i    (light_i),
      .x_i        (x_i),
      .y_i        (y_i),
      .dx_i       (dx),
      .dy_i       (dy),
      .step_i     (distance),
      .pace_i     (pace_i),
      .along_x_i  (x_cut_i),
      .along_y_i  (y_cut_i),
      .stops_i    (stops),
      .beyond_i   (beyond),
      .low_i      (beyond_min),
      .high_i     (beyond_max),
      .valid_i    (side_valid_i),
      .straight_i (straight),
      .diagonal_i (diagonal),
      .room_o     (side_room_o),
      .valid_o    (side_valid_o),
      .straight_o (straight_o),
      .diagonal_o (diagonal_o),
      .room_i     (side_room_i),
      .marks_o    (marks),
      .here_o     (here),
      .ways_o     (ways),
      .load_o     (load),
      .load_beam_o(load_beam),
      .loaded_o   (loaded),
      .left_o     (left),
      .serve_o    (served),
      .served_o   (served_beam),
      .free_min_o (free_min),
      .free_max_o (free_max),
      .end_o      (served_end),
      .queue_o    (queued),
      .busy_o     (side_busy)
  );
  /*verilator tracing_off*/

  // ---- What light reaches --------------------------------------------------------------------------
  logic lit;
  rc2_lit u_lit (
      .clk_i      (clk_i),
      .start_i    (start_i),
      .occupied_i (occupied),
      .marks_i    (marks),
      .reached_i  (reached),
      .z_i        (z),
      .read_addr_i(light_addr),
      .lit_o      (lit)
  );
  if (rc2_pkg::COUNTS) begin : g_counts
    rc2_counts u_counts (
        .clk_i      (clk_i),
        .rst_ni     (rst_ni),
        .start_i    (start_i),
        .light_i    (light_i),
        .step_i     (distance),
        .occupied_i (occupied),
        .here_i     (here),
        .x_all_i    (x_all_i),
        .x_kept_i   (x_kept_i),
        .y_all_i    (y_all_i),
        .y_kept_i   (y_kept_i),
        .front_i    (front),
        .reached_i  (reached),
        .stopped_i  (stopped),
        .dropped_i  (dropped),
        .last_i     (pace_i.last),
        .z_i        (z),
        .load_i     (load),
        .load_beam_i(load_beam),
        .loaded_i   (loaded),
        .left_i     (left),
        .serve_i    (served),
        .served_i   (served_beam),
        .free_min_i (free_min),
        .free_max_i (free_max),
        .end_i      (served_end),
        .ways_i     (ways),
        .read_addr_i(light_addr),
        .count_o    (arrived),
        .ends_o     (ends),
        .home_i     (home_i),
        .home_o     (home_o),
        .skipped_i  (skipped_i),
        .skipped_o  (skipped_o)
    );

    // Contract: light is where targets are; see rc2_lit for small L.
    logic large_q, rests_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) large_q <= 1'b0;
      else if (start_i) large_q <= (32'(light_i.distance) >= N);
      rests_q <= !start_i && !busy_o && !pace_i.active;
      if (rst_ni && large_q && rests_q) assert (lit == (arrived != 0));
    end
  end else begin : g_none
    assign arrived = HomeW'(lit);
    assign ends = '0;
    assign home_o = '0;
    assign skipped_o = '0;
  end

  // Visits of the light and how deep the queues were, for whoever wants to know where the time went.
  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) visits_q <= '0;
    else visits_q <= visits_q + rc2_pkg::ValueW'(served) + rc2_pkg::ValueW'(reached && pace_i.step != 0);
  end
  rc2_history #(
      .Width(rc2_pkg::QueueW)
  ) u_history (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .start_i    (start_i),
      .depth_i    (queued),
      .deepest_o  (deepest),
      .signature_o(signature)
  );

  assign busy_o = voxels_busy || side_busy || fronts || rays_busy;

  // Contract: light finds no loading under way; a beam comes from one neighbour of each kind.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(start_i && busy_o));
      assert ((side_valid_i & 8'h55 & ((side_valid_i & 8'h55) - 8'd1)) == 0);
      assert ((side_valid_i & 8'hAA & ((side_valid_i & 8'hAA) - 8'd1)) == 0);
    end
  end
endmodule
