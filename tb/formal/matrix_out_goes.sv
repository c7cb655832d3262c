// SPDX-License-Identifier: Apache-2.0
//
// rc2_matrix_out sends every bit where its U class and its V class go, and nothing else: (i,j) is any one
// place of the four matrices that leave, and any one bit of the front.

module matrix_out_goes (
    input logic [rc2_pkg::MatrixW-1:0] front_i,
    input logic [ rc2_pkg::ClassW-1:0] u_stay_i,
    input logic [ rc2_pkg::ClassW-1:0] u_leave_i,
    input logic [ rc2_pkg::ClassW-1:0] v_stay_i,
    input logic [ rc2_pkg::ClassW-1:0] v_leave_i,
    input logic [ rc2_pkg::ClassW-1:0] i,
    input logic [ rc2_pkg::ClassW-1:0] j
);
  localparam int unsigned M = rc2_pkg::ClassM;
  localparam int unsigned WideW = $clog2(2 * M * M + 2 * M + 1);
  localparam logic [WideW-1:0] Row = WideW'(M);

  logic [rc2_pkg::MatrixW-1:0] own, along_x, along_y, diagonal;
  rc2_matrix_out u_out (
      .front_i  (front_i),
      .u_stay_i (u_stay_i),
      .u_leave_i(u_leave_i),
      .v_stay_i (v_stay_i),
      .v_leave_i(v_leave_i),
      .own_o    (own),
      .x_o      (along_x),
      .y_o      (along_y),
      .xy_o     (diagonal)
  );

  // A class stays, leaves, or at most one of an axis is divided.
  always_comb begin
    assume (WideW'(u_stay_i) <= Row && (u_stay_i == u_leave_i || u_stay_i == u_leave_i + 1'b1));
    assume (WideW'(v_stay_i) <= Row && (v_stay_i == v_leave_i || v_stay_i == v_leave_i + 1'b1));
    assume (WideW'(i) < Row && WideW'(j) < Row && WideW'(u_leave_i) <= Row && WideW'(v_leave_i) <= Row);
  end

  logic [WideW-1:0] place, from_u, from_v;  // the class that comes to i, to j, if it is one
  logic own_bit, x_bit, y_bit, xy_bit;
  assign place = WideW'(i) * Row + WideW'(j);
  assign from_u = WideW'(i) + WideW'(u_leave_i);
  assign from_v = WideW'(j) + WideW'(v_leave_i);
  assign own_bit = i < u_stay_i && j < v_stay_i && front_i[place];
  assign x_bit = from_u < Row && j < v_stay_i && front_i[from_u*Row+WideW'(j)];
  assign y_bit = i < u_stay_i && from_v < Row && front_i[WideW'(i)*Row+from_v];
  assign xy_bit = from_u < Row && from_v < Row && front_i[from_u*Row+from_v];
  always_comb begin
    assert (own[place] == own_bit);
    assert (along_x[place] == x_bit);
    assert (along_y[place] == y_bit);
    assert (diagonal[place] == xy_bit);
  end

  // Nothing is lost: a bit of the front is in one of the four at least.
  logic u_stays, v_stays;
  logic [WideW-1:0] to_u, to_v;
  assign u_stays = (i < u_stay_i);
  assign v_stays = (j < v_stay_i);
  assign to_u = u_stays ? WideW'(i) : WideW'(i) - WideW'(u_leave_i);
  assign to_v = v_stays ? WideW'(j) : WideW'(j) - WideW'(v_leave_i);
  always_comb begin
    if (front_i[place]) begin
      assert (u_stays ? (v_stays ? own[to_u*Row+to_v] : along_y[to_u*Row+to_v])
                      : (v_stays ? along_x[to_u*Row+to_v] : diagonal[to_u*Row+to_v]));
    end
  end
endmodule
