// SPDX-License-Identifier: Apache-2.0
//
// A buffer of one message: the input buffer of a link (thesis 1.3, 4.4.1).
// ready_o depends on the slot's own register only, so a message passes every second cycle.

module rc2_slot #(
    parameter int unsigned Width = 8
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             valid_i,
    input  logic [Width-1:0] data_i,
    output logic             ready_o,
    output logic             valid_o,
    output logic [Width-1:0] data_o,
    input  logic             take_i
);
  logic valid_q;
  logic [Width-1:0] data_q;

  assign ready_o = !valid_q;
  assign valid_o = valid_q;
  assign data_o  = data_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= 1'b0;
    else valid_q <= valid_q ? !take_i : valid_i;
    if (valid_i && !valid_q) data_q <= data_i;
  end

  // Contract: only what is there is taken.
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (!(take_i && !valid_q));
  end
endmodule
