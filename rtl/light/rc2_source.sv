// SPDX-License-Identifier: Apache-2.0
//
// The light: on start, the cell whose column holds the source offers its six first beams, one per
// cube face, side faces first so that the array fills quickly (thesis 4.4.3). A target on an edge
// shared by two faces belongs to one of them: x faces keep all their edges, y faces those with z,
// z faces none. All faces together are 24*L*L + 2 targets.

module rc2_source (
    input  logic                               clk_i,
    input  logic                               rst_ni,
    input  logic                               start_i,
    input  logic           [rc2_pkg::CoordW-1:0] x_i,
    input  logic           [rc2_pkg::CoordW-1:0] y_i,
    input  rc2_pkg::light_t                    light_i,
    output logic                               valid_o,
    output rc2_pkg::beam_t                     beam_o,
    input  logic                               take_i
);
  localparam int unsigned TargetW = rc2_pkg::TargetW;

  logic active_q;
  logic [2:0] dir_q;
  logic [TargetW-1:0] full, inner, u_max, v_max;

  assign full = {1'b0, light_i.distance};
  assign inner = full - 1'b1;
  assign u_max = (dir_q[2:1] == 2'd0) ? full : inner;
  assign v_max = dir_q[2] ? inner : full;

  assign valid_o = active_q;
  assign beam_o.dir = dir_q;
  assign beam_o.z = light_i.zs;
  assign beam_o.umin = -u_max;
  assign beam_o.umax = u_max;
  assign beam_o.vmin = -v_max;
  assign beam_o.vmax = v_max;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      dir_q    <= 3'd0;
    end else if (start_i) begin
      active_q <= (x_i == light_i.xs) && (y_i == light_i.ys);
      dir_q    <= 3'd0;
    end else if (active_q && take_i) begin
      active_q <= (dir_q != 3'd5);
      dir_q    <= dir_q + 1'b1;
    end
  end

  // Contract: a new light never interrupts the old one; its constants make sense.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(start_i && active_q));
      assert (!active_q || (light_i.distance != 0 && light_i.fa != 0));
    end
  end
endmodule
