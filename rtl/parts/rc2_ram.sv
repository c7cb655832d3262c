// SPDX-License-Identifier: Apache-2.0
//
// One write port, one read port; the word read appears one cycle after its address, as it was
// before a write in the same cycle. Not reset: whoever reads it knows what was written.

module rc2_ram #(
    parameter int unsigned Width = 8,
    parameter int unsigned Depth = 16,
    localparam int unsigned AddrW = (Depth <= 2) ? 1 : $clog2(Depth)
) (
    input  logic             clk_i,
    input  logic             write_i,
    input  logic [AddrW-1:0] write_addr_i,
    input  logic [Width-1:0] write_data_i,
    input  logic [AddrW-1:0] read_addr_i,
    output logic [Width-1:0] read_data_o
);
  logic [Width-1:0] mem_q[0:Depth-1];
  logic [Width-1:0] read_q;

  assign read_data_o = read_q;

  always_ff @(posedge clk_i) begin
    if (write_i) mem_q[write_addr_i] <= write_data_i;
    read_q <= mem_q[read_addr_i];
  end
endmodule
