// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_collector: words of the row and of those above, the ends of both,
// moving and held up. A host
// asks again only when it has the answer, so a row that has ended has nothing to say.

module collector_points (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       row_valid_i,
    input logic       row_taken,
    input logic       row_drops,
    input logic       row_ends,
    input logic       above_valid_i,
    input logic       above_taken,
    input logic       above_ends,
    input logic       own_done_q,
    input logic       room,
    input logic [1:0] held,
    input logic       valid_o,
    input logic       ready_i
);
  for (genvar level = 0; level < 3; level++) begin : g_level
    always_ff @(posedge clk_i) if (rst_ni) holds : cover (held == level);
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      row_word : cover (row_taken && !row_ends && !row_drops);
      row_end : cover (row_taken && row_ends);
      object_end : cover (row_taken && row_drops);
      row_waits_for_room : cover (row_valid_i && !room && !own_done_q);
      word_from_above : cover (above_taken && !above_ends);
      end_from_above : cover (above_taken && above_ends);
      above_waits_for_room : cover (above_valid_i && !room && own_done_q);
      above_waits_for_the_row : cover (above_valid_i && !own_done_q);
      waits : cover (valid_o && !ready_i);
      moves : cover (valid_o && ready_i);
    end
  end
endmodule

bind rc2_collector collector_points u_points (.*);
