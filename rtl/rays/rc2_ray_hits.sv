// SPDX-License-Identifier: Apache-2.0
//
// Two of rc2_ray_hit, by turns: two rays in the time of one.

module rc2_ray_hits (
    input  logic              clk_i,
    input  logic              rst_ni,
    input  rc2_pkg::limits_t limits_i,
    input  logic              stop_i,     // a ray
    input  rc2_pkg::stop_t   stop_ray_i,
    output logic              taken_o,
    output logic              answer_o,   // what is to be answered, of the oldest
    output rc2_pkg::answer_t answer_ray_o,
    input  logic              free_i,     // it is taken
    output logic              busy_o,
    output logic [       1:0] work_o      // of each
);
  localparam int unsigned AnswerW = rc2_pkg::AnswerW;
  logic [1:0] in, out, taken, answers, busy;
  logic [2*AnswerW-1:0] answer;
  rc2_ray_turns u_turns (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .take_i (taken_o),
      .leave_i(answer_o && free_i),
      .in_o   (in),
      .out_o  (out)
  );
  for (genvar u = 0; u < 2; u++) begin : g_unit
    rc2_ray_hit u_hit (
        .clk_i       (clk_i),
        .rst_ni      (rst_ni),
        .limits_i    (limits_i),
        .stop_i      (stop_i && in[u]),
        .stop_ray_i  (stop_ray_i),
        .taken_o     (taken[u]),
        .answer_o    (answers[u]),
        .answer_ray_o(answer[u*AnswerW+:AnswerW]),
        .free_i      (free_i && out[u]),
        .busy_o      (busy[u]),
        .work_o      (work_o[u])
    );
  end
  assign taken_o = (taken != 0);
  assign answer_o = (answers & out) != 0;
  assign answer_ray_o = out[1] ? answer[AnswerW+:AnswerW] : answer[0+:AnswerW];
  assign busy_o = (busy != 0);
endmodule
