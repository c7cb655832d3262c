// SPDX-License-Identifier: Apache-2.0
//
// What a z lane's front in one voxel sends where: bit (i,j) of the matrix, at i*ClassM + j, is the
// light of U class i and V class j and goes where these two go. Four matrices leave: what stays,
// what goes along x, along y, and both. Combinational.

module rc2_matrix_out (
    input  logic           [rc2_pkg::MatrixW-1:0] front_i,
    input  logic           [rc2_pkg::ClassW-1:0] u_stay_i,   // classes that have targets that stay
    input  logic           [rc2_pkg::ClassW-1:0] u_leave_i,  // first class that has others
    input  logic           [rc2_pkg::ClassW-1:0] v_stay_i,
    input  logic           [rc2_pkg::ClassW-1:0] v_leave_i,
    output logic           [rc2_pkg::MatrixW-1:0] own_o,
    output logic           [rc2_pkg::MatrixW-1:0] x_o,
    output logic           [rc2_pkg::MatrixW-1:0] y_o,
    output logic           [rc2_pkg::MatrixW-1:0] xy_o
);
  localparam int unsigned M = rc2_pkg::ClassM;
  localparam int unsigned MatrixW = rc2_pkg::MatrixW;
  logic [M-1:0] v_stays;
  for (genvar j = 0; j < M; j++) begin : g_stays
    assign v_stays[j] = (rc2_pkg::ClassW'(j) < v_stay_i);
  end

  logic [MatrixW-1:0] u_stay, u_leave;
  always_comb begin
    u_leave = front_i;
    for (int b = 0; b < rc2_pkg::ClassW; b++) if (u_leave_i[b]) u_leave = u_leave >> (M << b);
  end
  for (genvar i = 0; i < M; i++) begin : g_row
    assign u_stay[i*M+:M] = (rc2_pkg::ClassW'(i) < u_stay_i) ? front_i[i*M+:M] : '0;
    assign own_o[i*M+:M] = u_stay[i*M+:M] & v_stays;
    assign x_o[i*M+:M] = u_leave[i*M+:M] & v_stays;
    assign y_o[i*M+:M] = u_stay[i*M+:M] >> v_leave_i;
    assign xy_o[i*M+:M] = u_leave[i*M+:M] >> v_leave_i;
  end
endmodule
