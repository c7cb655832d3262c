// SPDX-License-Identifier: Apache-2.0
//
// Which of two units takes the next ray, and which one gives back the oldest: they take by turns, so rays
// come out in the order in which they went in.

module rc2_ray_turns (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic       take_i,   // in this cycle a ray goes in
    input  logic       leave_i,  // one comes out
    output logic [1:0] in_o,     // one-hot
    output logic [1:0] out_o
);
  logic in_q, out_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      in_q  <= 1'b0;
      out_q <= 1'b0;
    end else begin
      in_q  <= in_q ^ take_i;
      out_q <= out_q ^ leave_i;
    end
  end
  assign in_o  = {in_q, !in_q};
  assign out_o = {out_q, !out_q};
endmodule
