// SPDX-License-Identifier: Apache-2.0
//
// The output buffer of one direction (thesis 4.4.1), with the child beam that belongs there: the
// U and V parts that lie in that direction. A beam written in cycle t is on the link from t+1 on,
// unchanged until the neighbour is ready; the buffer can be written in the cycle in which it is
// emptied.

module rc2_link #(
    parameter int unsigned Dir = 0  // 0 .. 7, E first, counter-clockwise
) (
    input  logic            clk_i,
    input  logic            rst_ni,
    input  logic            send_i,
    input  rc2_pkg::split_t split_i,
    output logic            writable_o,
    output logic            valid_o,
    output rc2_pkg::beam_t  beam_o,
    input  logic            ready_i
);
  localparam int unsigned TargetW = rc2_pkg::TargetW;
  localparam int unsigned XPart = (((rc2_pkg::Eastward >> Dir) & 8'd1) != 0) ? 2 :
                                  (((rc2_pkg::Westward >> Dir) & 8'd1) != 0) ? 0 : 1;
  localparam int unsigned YPart = (((rc2_pkg::Northward >> Dir) & 8'd1) != 0) ? 2 :
                                  (((rc2_pkg::Southward >> Dir) & 8'd1) != 0) ? 0 : 1;

  logic valid_q;
  rc2_pkg::beam_t beam_q;

  assign valid_o = valid_q;
  assign beam_o = beam_q;
  assign writable_o = !valid_q || ready_i;

  // U runs along y for the x faces, else along x; V along y for the z faces (else one part only).
  logic u_is_y;
  assign u_is_y = (split_i.dir[2:1] == 2'd0);
  logic [TargetW-1:0] x_min, x_max, y_min, y_max, v_min, v_max;
  assign x_min = (XPart == 0) ? split_i.u_low_min : (XPart == 1) ? split_i.u_mid_min : split_i.u_high_min;
  assign x_max = (XPart == 0) ? split_i.u_low_max : (XPart == 1) ? split_i.u_mid_max : split_i.u_high_max;
  assign y_min = (YPart == 0) ? split_i.u_low_min : (YPart == 1) ? split_i.u_mid_min : split_i.u_high_min;
  assign y_max = (YPart == 0) ? split_i.u_low_max : (YPart == 1) ? split_i.u_mid_max : split_i.u_high_max;
  assign v_min = (YPart == 0) ? split_i.v_low_min : (YPart == 1) ? split_i.v_mid_min : split_i.v_high_min;
  assign v_max = (YPart == 0) ? split_i.v_low_max : (YPart == 1) ? split_i.v_mid_max : split_i.v_high_max;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= 1'b0;
    else valid_q <= send_i || (valid_q && !ready_i);
    if (send_i) begin
      beam_q.dir  <= split_i.dir;
      beam_q.z    <= split_i.z;
      beam_q.umin <= u_is_y ? y_min : x_min;
      beam_q.umax <= u_is_y ? y_max : x_max;
      beam_q.vmin <= v_min;
      beam_q.vmax <= v_max;
    end
  end

  // Contract: nothing is overwritten; what is on the link stays until it is taken.
  rc2_pkg::beam_t before_q;
  logic held_q;
  always_ff @(posedge clk_i) begin
    held_q   <= rst_ni && valid_q && !ready_i;
    before_q <= beam_q;
    if (rst_ni) begin
      assert (!send_i || writable_o);
      assert (!held_q || (valid_q && beam_q == before_q));
    end
  end
endmodule
