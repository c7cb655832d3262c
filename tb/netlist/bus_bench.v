// rc2_machine with two row feeders, its packet streams apart as other people's stream models want
// them. Verilog for Icarus.
`timescale 1ns / 1ns
module bus_bench #(
    parameter PACKET_W = 72,
    parameter READ_W = 32
) (
    input clk,
    input rst_n,
    input s_axil_awvalid,
    output s_axil_awready,
    input [6:0] s_axil_awaddr,
    input s_axil_wvalid,
    output s_axil_wready,
    input [31:0] s_axil_wdata,
    input [3:0] s_axil_wstrb,
    output s_axil_bvalid,
    input s_axil_bready,
    output [1:0] s_axil_bresp,
    input s_axil_arvalid,
    output s_axil_arready,
    input [6:0] s_axil_araddr,
    output s_axil_rvalid,
    input s_axil_rready,
    output [31:0] s_axil_rdata,
    output [1:0] s_axil_rresp,
    input s_axis0_tvalid,
    output s_axis0_tready,
    input [PACKET_W-1:0] s_axis0_tdata,
    input s_axis1_tvalid,
    output s_axis1_tready,
    input [PACKET_W-1:0] s_axis1_tdata,
    output m_axis_tvalid,
    input m_axis_tready,
    output [READ_W-1:0] m_axis_tdata,
    output m_axis_tlast
);
  rc2_machine dut (
      .clk_i(clk), .rst_ni(rst_n),
      .s_axil_awvalid(s_axil_awvalid), .s_axil_awready(s_axil_awready), .s_axil_awaddr(s_axil_awaddr),
      .s_axil_wvalid(s_axil_wvalid), .s_axil_wready(s_axil_wready), .s_axil_wdata(s_axil_wdata),
      .s_axil_bvalid(s_axil_bvalid), .s_axil_bready(s_axil_bready), .s_axil_bresp(s_axil_bresp),
      .s_axil_arvalid(s_axil_arvalid), .s_axil_arready(s_axil_arready), .s_axil_araddr(s_axil_araddr),
      .s_axil_rvalid(s_axil_rvalid), .s_axil_rready(s_axil_rready), .s_axil_rdata(s_axil_rdata),
      .s_axil_rresp(s_axil_rresp),
      .s_axis_tvalid({s_axis1_tvalid, s_axis0_tvalid}), .s_axis_tready({s_axis1_tready, s_axis0_tready}),
      .s_axis_tdata({s_axis1_tdata, s_axis0_tdata}),
      .m_axis_tvalid(m_axis_tvalid), .m_axis_tready(m_axis_tready), .m_axis_tdata(m_axis_tdata),
      .m_axis_tlast(m_axis_tlast)
  );
endmodule
