// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_facet_stage: every kind of word, and every pattern of stalls at the
// unit beside and the stage after.

module facet_stage_points (
    input logic                      clk_i,
    input logic                      rst_ni,
    input logic                      valid_i,
    input logic                      ready_o,
    input logic                [1:0] held,
    input logic [rc2_pkg::KindW-1:0] kind,
    input logic                      here,
    input logic                      on,
    input logic                      fire,
    input logic                      unit_ready_i,
    input logic                      next_ready_i
);
  for (genvar k = 0; k < 7; k++) begin : g_kind
    logic fires;
    assign fires = rst_ni && fire && kind == k;
    if (k != rc2_pkg::KindData) begin : g_here
      always_ff @(posedge clk_i) to_the_unit : cover (fires && here);
    end
    always_ff @(posedge clk_i) to_the_next : cover (fires && on);
    if (k <= rc2_pkg::KindGap) begin : g_packet
      always_ff @(posedge clk_i) begin
        passes_by : cover (fires && !here && on);
        ends_here : cover (fires && here && !on);
        to_both : cover (fires && here && on);
      end
    end
  end
  for (genvar level = 0; level < 3; level++) begin : g_held
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        nothing_comes : cover (held == level && !valid_i);
        a_word_comes : cover (held == level && valid_i);
      end
    end
  end
  // {unit ready, next ready} while a word for both waits
  for (genvar ready = 0; ready < 4; ready++) begin : g_ready
    always_ff @(posedge clk_i) begin
      for_both : cover (rst_ni && held != 0 && here && on && {unit_ready_i, next_ready_i} == ready);
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      unit_stalls : cover (held != 0 && here && !on && !unit_ready_i);
      next_stalls : cover (held != 0 && !here && on && !next_ready_i);
      full_gives_and_stalls : cover (fire && valid_i && !ready_o);
    end
  end
endmodule

bind rc2_facet_stage facet_stage_points u_points (.*);
