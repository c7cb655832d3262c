// SPDX-License-Identifier: Apache-2.0
//
// rc2_slot is a queue of one place: what it accepts it shows, unchanged, from the next cycle on until
// it is taken, and only then it accepts again.

module slot_keeps (
    input logic clk_i,
    input logic valid_i,
    input logic data_i,
    input logic take_i
);
  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  logic ready, valid, data;
  rc2_slot #(
      .Width(1)
  ) u_slot (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .valid_i(valid_i),
      .data_i (data_i),
      .ready_o(ready),
      .valid_o(valid),
      .data_o (data),
      .take_i (take_i)
  );
  always_comb assume (!take_i || valid);

  logic full_q, word_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) full_q <= 1'b0;
    else if (take_i) full_q <= 1'b0;
    else if (valid_i && ready) full_q <= 1'b1;
    if (valid_i && ready) word_q <= data_i;
  end
  always_comb begin
    if (rst_ni) begin
      assert (valid == full_q);
      assert (ready == !full_q);
      assert (!full_q || data == word_q);
    end
  end
endmodule
