// SPDX-License-Identifier: Apache-2.0
//
// The cell's part of the two z lanes: light towards the z faces, a layer of the cube in each step.
// The front of a lane in a voxel is a matrix of bits, one for each pair of a U class and a V class
// (rc2_axis); a class is stopped whole or not at all, so the front needs no queue, nothing waits and
// nothing is compared. One engine serves the lane upwards in the first cycle of a step, the lane
// downwards in the second.
//
// What a cell sends goes outward from the light to the neighbours along x, along y and diagonally;
// what it gets comes from the opposite sides. Latency one step; thesis 4.3.4 is the voxel-by-voxel
// way to the same targets.

module rc2_z_lanes (
    input  logic                             clk_i,
    input  logic                             rst_ni,
    input  logic                             start_i,
    input  logic                             source_i,   // the light is in this column
    input  rc2_pkg::pace_t                   pace_i,
    input  rc2_pkg::cut_t                    u_i,
    input  rc2_pkg::cut_t                    v_i,
    input  logic       [rc2_pkg::ClassW-1:0] u_come_i,
    input  logic       [rc2_pkg::ClassW-1:0] v_come_i,
    input  logic       [rc2_pkg::N-1:0] stops_i,
    // layers with anything that light can still meet, if there is anything
    input  logic                             beyond_i,
    input  logic       [rc2_pkg::CoordW-1:0] min_i,
    input  logic       [rc2_pkg::CoordW-1:0] max_i,
    output logic       [rc2_pkg::MatrixW-1:0] x_o,
    output logic       [rc2_pkg::MatrixW-1:0] y_o,
    output logic       [rc2_pkg::MatrixW-1:0] xy_o,
    input  logic       [rc2_pkg::MatrixW-1:0] x_i,
    input  logic       [rc2_pkg::MatrixW-1:0] y_i,
    input  logic       [rc2_pkg::MatrixW-1:0] xy_i,
    // the front of this cycle: it reaches voxel z_o, and is stopped there; or it is dropped, as there
    // is nothing more to meet
    output logic       [rc2_pkg::MatrixW-1:0] front_o,
    output logic                             reached_o,
    output logic                             stopped_o,
    output logic                             dropped_o,
    output logic       [rc2_pkg::CoordW-1:0] z_o,
    output logic                             busy_o
);
  localparam int unsigned MatrixW = rc2_pkg::MatrixW;
  logic [MatrixW-1:0] up_q, down_q, passing, own, next;
  logic up_any_q, down_any_q, any, next_any;  // whether a front has light
  logic stop_q, worth_q;
  logic [rc2_pkg::CoordW-1:0] z_q;

  assign front_o = pace_i.first ? up_q : down_q;
  assign any = pace_i.on && (pace_i.first ? up_any_q : down_any_q);
  assign reached_o = any && worth_q;
  assign dropped_o = any && !worth_q;
  assign stopped_o = reached_o && stop_q;
  assign z_o = z_q;
  assign passing = (reached_o && !stop_q) ? front_o : '0;
  assign busy_o = up_any_q || down_any_q;

  rc2_matrix_out u_out (
      .front_i  (passing),
      .u_stay_i (u_i.stay),
      .u_leave_i(u_i.leave),
      .v_stay_i (v_i.stay),
      .v_leave_i(v_i.leave),
      .own_o    (own),
      .x_o      (x_o),
      .y_o      (y_o),
      .xy_o     (xy_o)
  );
  rc2_matrix_in u_in (
      .u_come_i(u_come_i),
      .v_come_i(v_come_i),
      .own_i   (own),
      .x_i     (x_i),
      .y_i     (y_i),
      .xy_i    (xy_i),
      .front_o (next)
  );

  // After its last layer a front is out of the cube. A cell without light keeps its registers still.
  assign next_any = !pace_i.last && (next != 0);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      up_q       <= '0;
      down_q     <= '0;
      up_any_q   <= 1'b0;
      down_any_q <= 1'b0;
    end else if (start_i) begin
      up_q       <= MatrixW'(source_i);
      down_q     <= MatrixW'(source_i);
      up_any_q   <= source_i;
      down_any_q <= source_i;
    end else if (pace_i.on && (any || next_any)) begin
      if (pace_i.first) begin
        up_q     <= next;
        up_any_q <= next_any;
      end else begin
        down_q     <= next;
        down_any_q <= next_any;
      end
    end
    stop_q  <= stops_i[pace_i.next_layer];
    worth_q <= beyond_i && (min_i <= pace_i.next_layer) && (pace_i.next_layer <= max_i);
    z_q     <= pace_i.next_layer;
  end

  // Contract: a front that says it has light has some.
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert ((!up_any_q || up_q != 0) && (!down_any_q || down_q != 0));
  end
endmodule
