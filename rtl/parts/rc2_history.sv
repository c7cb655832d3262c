// SPDX-License-Identifier: Apache-2.0
//
// What a queue has been through since the start: its greatest depth and, where COUNTS, a signature
// of its depth in every cycle, the sum of depth * cycle * cycle modulo 2^16. Two queues of equal
// signature have, for all that a test will meet, been equally deep all the time.

module rc2_history #(
    parameter int unsigned Width = 4
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             start_i,
    input  logic [Width-1:0] depth_i,
    output logic [Width-1:0] deepest_o,
    output logic [     15:0] signature_o
);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) deepest_o <= '0;
    else if (depth_i > deepest_o) deepest_o <= depth_i;
  end

  if (rc2_pkg::COUNTS) begin : g_signature
    logic [15:0] cycle_q;  // 1 in the cycle after the start
    always_ff @(posedge clk_i) begin
      if (!rst_ni || start_i) begin
        cycle_q     <= 16'd1;
        signature_o <= '0;
      end else begin
        cycle_q <= cycle_q + 1'b1;
        if (depth_i != 0) signature_o <= signature_o + 16'(depth_i) * cycle_q * cycle_q;
      end
    end
  end else begin : g_none
    assign signature_o = '0;
  end
endmodule
