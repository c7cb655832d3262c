// SPDX-License-Identifier: Apache-2.0
//
// East end of a row on the readback's way to the host: passes the row's own words down, then those
// of the rows above. A READ word ends each of the two; the one from above ends the whole and goes
// on, so row 0 gives the host rows 0, 1, .. n-1 and one READ word at the end. One word per cycle,
// one cycle per row.

module rc2_collector (
    input  logic                         clk_i,
    input  logic                         rst_ni,
    // end of the row's pipe
    input  logic                         row_valid_i,
    input  logic [rc2_pkg::RowWordW-1:0] row_word_i,
    output logic                         row_ready_o,
    // collector above
    input  logic                         above_valid_i,
    input  logic [rc2_pkg::RowWordW-1:0] above_word_i,
    output logic                         above_ready_o,
    // collector below, or the host
    output logic                         valid_o,
    output logic [rc2_pkg::RowWordW-1:0] word_o,
    input  logic                         ready_i,
    output logic                         busy_o
);
  localparam int unsigned RowWordW = rc2_pkg::RowWordW;

  logic [1:0] held;
  logic room, row_drops, row_ends, above_ends, row_taken, above_taken, push;
  logic own_done_q;

  assign room = (held != 2'd2);
  // The end of an object has told every cell of the row; nobody waits for it here.
  assign row_drops = (row_word_i[RowWordW-1-:rc2_pkg::KindW] == rc2_pkg::KindEnd);
  assign row_ends = (row_word_i[RowWordW-1-:rc2_pkg::KindW] == rc2_pkg::KindRead);
  assign above_ends = (above_word_i[RowWordW-1-:rc2_pkg::KindW] == rc2_pkg::KindRead);
  assign row_ready_o = room && !own_done_q;
  assign above_ready_o = room && own_done_q;
  assign row_taken = row_valid_i && row_ready_o;
  assign above_taken = above_valid_i && above_ready_o;
  assign push = (row_taken && !row_ends && !row_drops) || above_taken;

  rc2_fifo #(
      .Width(RowWordW),
      .Depth(2)
  ) u_buffer (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .push_i (push),
      .data_i (own_done_q ? above_word_i : row_word_i),
      .pop_i  (valid_o && ready_i),
      .data_o (word_o),
      .count_o(held)
  );
  assign valid_o = (held != 0);
  assign busy_o = (held != 0) || own_done_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) own_done_q <= 1'b0;
    else if (row_taken && row_ends) own_done_q <= 1'b1;
    else if (above_taken && above_ends) own_done_q <= 1'b0;
  end

  // Contract: only readback comes out of a row: facet packets end inside their box.
  always_ff @(posedge clk_i) begin
    if (rst_ni && row_valid_i) begin
      assert (row_word_i[RowWordW-1-:rc2_pkg::KindW] == rc2_pkg::KindData || row_ends ||
              row_drops);
    end
  end
endmodule
