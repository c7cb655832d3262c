// SPDX-License-Identifier: Apache-2.0
//
// The next front of a z lane in one voxel: along each axis the classes that have come, then those
// that have stayed. The converse of rc2_matrix_out. Combinational.

module rc2_matrix_in (
    input  logic [rc2_pkg::ClassW-1:0] u_come_i,
    input  logic [rc2_pkg::ClassW-1:0] v_come_i,
    input  logic [rc2_pkg::MatrixW-1:0] own_i,
    input  logic [rc2_pkg::MatrixW-1:0] x_i,
    input  logic [rc2_pkg::MatrixW-1:0] y_i,
    input  logic [rc2_pkg::MatrixW-1:0] xy_i,
    output logic [rc2_pkg::MatrixW-1:0] front_o
);
  localparam int unsigned M = rc2_pkg::ClassM;
  localparam int unsigned ClassW = rc2_pkg::ClassW;
  localparam int unsigned MatrixW = rc2_pkg::MatrixW;
  logic [M-1:0] v_comes;
  for (genvar j = 0; j < M; j++) begin : g_comes
    assign v_comes[j] = (ClassW'(j) < v_come_i);
  end

  logic [MatrixW-1:0] own, y;  // moved outward to make room
  always_comb begin
    own = own_i;
    y   = y_i;
    for (int b = 0; b < ClassW; b++) begin
      if (u_come_i[b]) begin
        own = own << (M << b);
        y   = y << (M << b);
      end
    end
  end
  for (genvar i = 0; i < M; i++) begin : g_row
    logic [M-1:0] stayed, came;  // along V
    assign stayed = (ClassW'(i) < u_come_i) ? x_i[i*M+:M] : own[i*M+:M];
    assign came = (ClassW'(i) < u_come_i) ? xy_i[i*M+:M] : y[i*M+:M];
    assign front_o[i*M+:M] = (came & v_comes) | ((stayed << v_come_i) & ~v_comes);
  end
endmodule
