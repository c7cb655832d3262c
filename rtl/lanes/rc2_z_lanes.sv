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
    output logic       [rc2_pkg::MatrixW-1:0] x_o,
    output logic       [rc2_pkg::MatrixW-1:0] y_o,
    output logic       [rc2_pkg::MatrixW-1:0] xy_o,
    input  logic       [rc2_pkg::MatrixW-1:0] x_i,
    input  logic       [rc2_pkg::MatrixW-1:0] y_i,
    input  logic       [rc2_pkg::MatrixW-1:0] xy_i,
    // the front of this cycle: it reaches voxel z_o, and is stopped there
    output logic       [rc2_pkg::MatrixW-1:0] front_o,
    output logic                             reached_o,
    output logic                             stopped_o,
    output logic       [rc2_pkg::CoordW-1:0] z_o
);
  localparam int unsigned MatrixW = rc2_pkg::MatrixW;
  logic [MatrixW-1:0] up_q, down_q, passing, own, next;
  logic stop_q;
  logic [rc2_pkg::CoordW-1:0] z_q;

  assign front_o = !pace_i.on ? '0 : pace_i.first ? up_q : down_q;
  assign reached_o = (front_o != 0);
  assign stopped_o = reached_o && stop_q;
  assign z_o = z_q;
  assign passing = stop_q ? '0 : front_o;

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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      up_q   <= '0;
      down_q <= '0;
    end else if (start_i) begin
      up_q   <= MatrixW'(source_i);
      down_q <= MatrixW'(source_i);
    end else if (pace_i.on) begin
      if (pace_i.first) up_q <= next;
      else down_q <= next;
    end
    stop_q <= stops_i[pace_i.next_layer];
    z_q    <= pace_i.next_layer;
  end
endmodule
