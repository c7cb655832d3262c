// SPDX-License-Identifier: Apache-2.0
//
// Rotating arbiter: grants the first request at or after the place that follows the last grant
// taken, so that nobody who keeps asking waits for more than Ways-1 others. Combinational grant;
// the place moves in the cycle in which take_i is set.

module rc2_rotate #(
    parameter int unsigned Ways = 8
) (
    input  logic            clk_i,
    input  logic            rst_ni,
    input  logic [Ways-1:0] request_i,
    input  logic            take_i,
    output logic [Ways-1:0] grant_o     // one-hot, or 0 when nobody asks
);
  // One bit per way at or after the preferred place.
  logic [Ways-1:0] after_q;
  logic [Ways-1:0] preferred, chosen;

  assign preferred = request_i & after_q;
  assign chosen = (preferred != 0) ? preferred : request_i;
  assign grant_o = chosen & (~chosen + 1'b1);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) after_q <= '1;
    // grant-1 marks the ways below the grant; the ways above it come next, or all of them again.
    else if (take_i && grant_o != 0) after_q <= ~(grant_o | (grant_o - 1'b1));
  end

  // Contract: at most one grant, only to who asks, and somebody is granted if anybody asks.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert ((grant_o & (grant_o - 1'b1)) == 0);
      assert ((grant_o & ~request_i) == 0);
      assert ((request_i == 0) || (grant_o != 0));
    end
  end
endmodule
