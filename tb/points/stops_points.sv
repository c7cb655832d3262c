// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_stops: tables of every size, and every answer to a beam.

module stops_points (
    input logic                              clk_i,
    input logic                              rst_ni,
    input logic                              ask_i,
    input logic                              known_o,
    input logic                        [2:0] state_q,
    input logic [$clog2(rc2_pkg::RUNS+1)-1:0] count_q,
    input logic                              partial_q,
    input logic            [rc2_pkg::RUNS-1:0] holds,
    input logic            [rc2_pkg::RUNS-1:0] next,
    input logic signed    [rc2_pkg::StopW-1:0] free_min_o,
    input logic signed    [rc2_pkg::StopW-1:0] free_max_o,
    input logic signed    [rc2_pkg::StopW-1:0] next_min,
    input logic signed    [rc2_pkg::StopW-1:0] last,
    input logic                              mark_i
);
  logic ready, answers;
  assign ready = rst_ni && state_q == 3;
  assign answers = ready && ask_i && known_o;
  // A column of n voxels has at most n/2 runs, rounded up.
  for (genvar runs = 0; runs <= rc2_pkg::RUNS; runs++) begin : g_runs
    if (runs <= (rc2_pkg::N + 1) / 2) begin : g_possible
      always_ff @(posedge clk_i) holds_runs : cover (ready && count_q == runs);
    end
  end
  if ((rc2_pkg::N + 1) / 2 > rc2_pkg::RUNS) begin : g_partial
    always_ff @(posedge clk_i) begin
      partial : cover (ready && partial_q);
      filled_anew : cover (rst_ni && state_q == 4);
    end
  end
  always_ff @(posedge clk_i) begin
    free_to_the_end : cover (answers && holds == 0 && (next == 0 || next_min > last));
    free_up_to_a_run : cover (answers && holds == 0 && next != 0 && next_min <= last);
    begins_in_a_run : cover (answers && holds != 0 && free_min_o <= free_max_o);
    all_in_a_run : cover (answers && holds != 0 && free_min_o > free_max_o);
    marks : cover (rst_ni && mark_i);
  end
endmodule

bind rc2_stops stops_points u_points (.*);
