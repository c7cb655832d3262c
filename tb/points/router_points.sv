// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_router: each of the eight links and the column's own light, moving
// and held up.

module router_points (
    input logic       clk_i,
    input logic       rst_ni,
    input logic [7:0] link_valid_i,
    input logic [7:0] link_ready_o,
    input logic [7:0] link_valid_o,
    input logic [7:0] link_ready_i,
    input logic [7:0] send_i,
    input logic [8:0] waiting,
    input logic [8:0] grant,
    input logic       arrival_take_i
);
  for (genvar d = 0; d < 8; d++) begin : g_link
    logic comes, goes;
    assign comes = link_valid_i[d] && link_ready_o[d];
    assign goes = link_valid_o[d] && link_ready_i[d];
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        in_moves : cover (comes);
        in_waits : cover (link_valid_i[d] && !link_ready_o[d]);
        out_moves : cover (goes);
        out_waits : cover (link_valid_o[d] && !link_ready_i[d]);
        emptied_and_filled : cover (goes && send_i[d]);
      end
    end
  end
  for (genvar d = 0; d < 9; d++) begin : g_arrival
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        taken : cover (grant[d] && arrival_take_i);
        refused : cover (grant[d] && !arrival_take_i);
      end
    end
    // Light never comes back to its source, whose own beams have nobody beside them.
    if (d < 8) begin : g_others
      always_ff @(posedge clk_i) begin
        if (rst_ni) passed_over : cover (waiting[d] && arrival_take_i && !grant[d]);
      end
    end
  end
endmodule

bind rc2_router router_points u_points (.*);
