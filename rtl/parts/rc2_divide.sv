// SPDX-License-Identifier: Apache-2.0
//
// Division, a bit of the quotient in each cycle: floor(num / div) for `bits_i` bits, all ones if it
// has more (or div is 0). What was given in the cycle of start_i is divided in the bits_i cycles
// after it; done_o is high in the last of them, and from the next on the quotient stays.

module rc2_divide #(
    parameter int unsigned NumW = 16,
    parameter int unsigned DivW = 8,
    parameter int unsigned QuotW = 8,
    localparam int unsigned BitsW = $clog2(QuotW + 1)
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             start_i,
    input  logic [ NumW-1:0] num_i,
    input  logic [ DivW-1:0] div_i,
    input  logic [BitsW-1:0] bits_i,  // 1 .. QuotW
    output logic             done_o,
    output logic [QuotW-1:0] quot_o,
    output logic             rest_o   // the division leaves a rest
);
  // The divisor, moved up by all bits of the quotient, comes down by one in each cycle.
  localparam int unsigned UpW = DivW + QuotW;
  localparam int unsigned RestW = (NumW > UpW) ? NumW : UpW;

  logic [BitsW-1:0] left_q;
  logic [RestW-1:0] rest_q, divisor, next;
  logic [UpW-1:0] up_q;
  logic [QuotW-1:0] quot_q;
  logic fits;

  assign divisor = RestW'(up_q >> 1);
  assign fits = (rest_q >= divisor);
  assign next = fits ? rest_q - divisor : rest_q;
  assign done_o = (left_q == BitsW'(1));
  assign quot_o = quot_q;
  assign rest_o = (rest_q != 0);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) left_q <= '0;
    else if (start_i) left_q <= bits_i;
    else if (left_q != 0) left_q <= left_q - 1'b1;
    if (start_i) begin
      rest_q <= RestW'(num_i);
      up_q   <= UpW'(div_i) << bits_i;
      quot_q <= '0;
    end else if (left_q != 0) begin
      rest_q <= next;
      up_q   <= up_q >> 1;
      quot_q <= {quot_q[QuotW-2:0], fits};
    end
  end

  // Contract: one division at a time.
  always_ff @(posedge clk_i) begin
    if (rst_ni && start_i) assert (left_q == 0 && bits_i != 0);
  end
endmodule
