// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_ray_turns: rays in and out of either unit, alone and at once.

module ray_turns_points (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       take_i,
    input logic       leave_i,
    input logic [1:0] in_o,
    input logic [1:0] out_o
);
  for (genvar u = 0; u < 2; u++) begin : g_unit
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        takes : cover (take_i && in_o[u]);
        leaves : cover (leave_i && out_o[u]);
        leaves_for_the_next : cover (leave_i && take_i && in_o[u] && out_o[u]);
      end
    end
  end
endmodule

bind rc2_ray_turns ray_turns_points u_points (.*);
