// SPDX-License-Identifier: Apache-2.0
//
// A sequence of Steps steps, a cycle each but for two: `Wait` lasts until go_i, the last one until the
// next start. One bit for each step, none before the first start; at_o[0] is the cycle after start_i. A
// start while steps are under way begins anew.

module rc2_steps #(
    parameter int unsigned Steps = 3,
    parameter int unsigned Wait = 0
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             start_i,
    input  logic             go_i,
    output logic [Steps-1:0] at_o
);
  logic [Steps-1:0] at_q, next;
  always_comb begin
    next = at_q << 1;
    if (at_q[Steps-1] || (at_q[Wait] && !go_i)) next = at_q;
    if (start_i) next = Steps'(1);
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) at_q <= '0;
    else at_q <= next;
  end
  assign at_o = at_q;

  // Contract: one step at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert ((at_q & (at_q - 1'b1)) == 0);
  end
endmodule
