// SPDX-License-Identifier: Apache-2.0
//
// Two of rc2_ray_launch, by turns: two rays in the time of one.

module rc2_ray_launches (
    input  logic            clk_i,
    input  logic            rst_ni,
    input  logic            begin_i,  // a ray
    input  rc2_pkg::start_t begin_ray_i,
    output logic            taken_o,
    output logic            busy_o,
    output logic            ready_o,  // the oldest can go on, as ray_o
    output rc2_pkg::ray_t   ray_o,
    input  logic            leave_i,
    output logic [     1:0] work_o    // of each
);
  localparam int unsigned RayW = rc2_pkg::RayW;
  logic [1:0] in, out, take, busy, ready, leave;
  logic [2*RayW-1:0] ray;
  rc2_ray_turns u_turns (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .take_i (taken_o),
      .leave_i(leave_i),
      .in_o   (in),
      .out_o  (out)
  );
  assign leave = out & {2{leave_i}};
  assign take = in & {2{begin_i}} & (~busy | leave);
  assign taken_o = (take != 0);
  for (genvar u = 0; u < 2; u++) begin : g_unit
    rc2_ray_launch u_launch (
        .clk_i  (clk_i),
        .rst_ni (rst_ni),
        .take_i (take[u]),
        .begin_i(begin_ray_i),
        .busy_o (busy[u]),
        .ready_o(ready[u]),
        .ray_o  (ray[u*RayW+:RayW]),
        .leave_i(leave[u]),
        .work_o (work_o[u])
    );
  end
  assign busy_o = (busy != 0);
  assign ready_o = (ready & out) != 0;
  assign ray_o = out[1] ? ray[RayW+:RayW] : ray[0+:RayW];
endmodule
