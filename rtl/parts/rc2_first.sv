// SPDX-License-Identifier: Apache-2.0
//
// The lowest bit that is set, by a tree of choices: log2 Width levels deep. Combinational.

module rc2_first #(
    parameter int unsigned Width = 2,
    parameter int unsigned IndexW = $clog2(Width)
) (
    input  logic [ Width-1:0] bits_i,
    output logic              found_o,
    output logic [IndexW-1:0] index_o  // 0 if there is none
);
  for (genvar l = 0; l <= IndexW; l++) begin : g_level
    localparam int unsigned Nodes = 1 << (IndexW - l);
    logic [Nodes-1:0] found;
    logic [Nodes*IndexW-1:0] index;
    for (genvar i = 0; i < Nodes; i++) begin : g_node
      if (l == 0) begin : g_leaf
        if (i < Width) assign found[i] = bits_i[i];
        else assign found[i] = 1'b0;
        assign index[i*IndexW+:IndexW] = '0;
      end else begin : g_choice
        assign found[i] = g_level[l-1].found[2*i] || g_level[l-1].found[2*i+1];
        assign index[i*IndexW+:IndexW] = g_level[l-1].found[2*i] ? g_level[l-1].index[2*i*IndexW+:IndexW]
            : (g_level[l-1].index[(2*i+1)*IndexW+:IndexW] | (IndexW'(g_level[l-1].found[2*i+1]) << (l - 1)));
      end
    end
  end
  assign found_o = g_level[IndexW].found[0];
  assign index_o = g_level[IndexW].index[0+:IndexW];
endmodule
