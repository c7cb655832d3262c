// SPDX-License-Identifier: Apache-2.0
//
// rc2_matrix_in joins exactly: along each axis the classes that have come, then those that stayed. (i,j)
// is any one bit of the next front.

module matrix_in_joins (
    input logic [ rc2_pkg::ClassW-1:0] u_come_i,
    input logic [ rc2_pkg::ClassW-1:0] v_come_i,
    input logic [rc2_pkg::MatrixW-1:0] own_i,
    input logic [rc2_pkg::MatrixW-1:0] x_i,
    input logic [rc2_pkg::MatrixW-1:0] y_i,
    input logic [rc2_pkg::MatrixW-1:0] xy_i,
    input logic [ rc2_pkg::ClassW-1:0] i,
    input logic [ rc2_pkg::ClassW-1:0] j
);
  localparam int unsigned M = rc2_pkg::ClassM;
  localparam int unsigned WideW = $clog2(2 * M * M + 2 * M + 1);
  localparam logic [WideW-1:0] Row = WideW'(M);

  logic [rc2_pkg::MatrixW-1:0] front;
  rc2_matrix_in u_in (
      .u_come_i(u_come_i),
      .v_come_i(v_come_i),
      .own_i   (own_i),
      .x_i     (x_i),
      .y_i     (y_i),
      .xy_i    (xy_i),
      .front_o (front)
  );

  logic u_came, v_came, joined;
  logic [WideW-1:0] from;
  assign u_came = (i < u_come_i);
  assign v_came = (j < v_come_i);
  assign from = (u_came ? WideW'(i) : WideW'(i) - WideW'(u_come_i)) * Row +
                (v_came ? WideW'(j) : WideW'(j) - WideW'(v_come_i));
  assign joined = u_came ? (v_came ? xy_i[from] : x_i[from]) : (v_came ? y_i[from] : own_i[from]);
  always_comb begin
    assume (WideW'(u_come_i) <= Row && WideW'(v_come_i) <= Row);
    assume (WideW'(i) < Row && WideW'(j) < Row);
    assert (front[WideW'(i)*Row+WideW'(j)] == joined);
  end
endmodule
