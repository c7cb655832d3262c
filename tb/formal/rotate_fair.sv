// SPDX-License-Identifier: Apache-2.0
//
// rc2_rotate is fair: any one way that keeps asking is granted after at most Ways-1 grants to others.
// Induction goes through because the preferred place is the number of ways that after_q leaves out,
// and each grant to another brings it nearer to the way that asks: waited + distance never grows.

module rotate_fair #(
    parameter int unsigned Ways = 9
) (
    input logic            clk_i,
    input logic [Ways-1:0] request_i,
    input logic            take_i
);
  localparam int unsigned PlaceW = $clog2(2 * Ways + 1);

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  logic [Ways-1:0] grant;
  rc2_rotate #(
      .Ways(Ways)
  ) u_rotate (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .request_i(request_i),
      .take_i   (take_i),
      .grant_o  (grant)
  );

  (* anyconst *) logic [PlaceW-1:0] way;
  always_comb assume (way < PlaceW'(Ways));
  logic asks, granted;
  assign asks = request_i[way];
  assign granted = grant[way];

  // Grants to others since it asks.
  logic [PlaceW-1:0] waited_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || !asks || (take_i && granted)) waited_q <= '0;
    else if (take_i) waited_q <= waited_q + 1'b1;
  end

  (* hierconn *) wire [Ways-1:0] \u_rotate.after_q ;
  logic [Ways-1:0] left_out;
  logic [PlaceW-1:0] place, distance;
  assign left_out = ~\u_rotate.after_q ;
  always_comb begin
    place = '0;
    for (int i = 0; i < Ways; i++) place = place + PlaceW'(left_out[i]);
    if (place == PlaceW'(Ways)) place = '0;
  end
  assign distance = (way >= place) ? way - place : way + PlaceW'(Ways) - place;

  always_comb begin
    assert ((left_out & (left_out + 1'b1)) == 0 || !rst_ni);
    assert (waited_q < PlaceW'(Ways) || !rst_ni);
    assert (waited_q + distance < PlaceW'(Ways) || !rst_ni);
  end
endmodule
