// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_column: every kind of READ, of columns with nothing, one word and
// several to say, moving and held up; and what is written while what else is there.

module column_points (
    input logic                  clk_i,
    input logic                  rst_ni,
    input logic                  clear_i,
    input logic                  fill_i,
    input logic                  guard_i,
    input logic                  show_i,
    input logic                  flip_i,
    input logic                  end_i,
    input logic [rc2_pkg::N-1:0] occupied_q,
    input logic [           2:0] read_what_i,
    input logic                  read_i,
    input logic                  reading_q,
    input logic                  any,
    input logic                  fetched_q,
    input logic [rc2_pkg::N-1:0] rest,
    input logic                  data_ready_i
);
  for (genvar what = 0; what < 5; what++) begin : g_read
    logic here;
    assign here = rst_ni && fetched_q && data_ready_i && read_what_i == what;
    // A machine whose light is in lanes is asked for ends, the thesis's is not.
    if (what != rc2_pkg::ReadEnds || !rc2_pkg::THESIS) begin : g_asked
      always_ff @(posedge clk_i) asked : cover (here);
    end
    if (what < rc2_pkg::ReadCounters || what == rc2_pkg::ReadLayers) begin : g_voxels
      always_ff @(posedge clk_i) begin
        empty : cover (here && !any);
        a_word : cover (here && any && rest != 0);
        last_word : cover (here && any && rest == 0);
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      word_waits : cover (fetched_q && !data_ready_i);
      fills : cover (fill_i);
      guards : cover (guard_i);
      shows : cover (show_i);
      flips : cover (flip_i);
      object_ends : cover (end_i);
      forgets : cover (clear_i && occupied_q != 0);
      full : cover (&occupied_q);
    end
  end
endmodule

bind rc2_column column_points u_points (.*);
