// Replays on the gates of rc2_machine, with four states, what a bench saw at the pins of its RTL
// (systemc_machine --record): every line of the record is a clock cycle. A pin that the RTL drives
// must have its value: a ready or valid always, a beat while it is valid. So nothing unknown leaves
// the machine after its reset. Verilog for Icarus.
//
//   vvp REPLAY +record=FILE
`timescale 1ns / 1ns
module replay;
  parameter FEEDERS = 2;
  parameter PACKET_W = 64;
  parameter READ_W = 32;

  reg clk = 1'b0, rst_n = 1'b0;
  reg awvalid = 0, wvalid = 0, arvalid = 0, bready = 0, rready = 0, read_ready = 0;
  reg [6:0] awaddr = 0, araddr = 0;
  reg [31:0] wdata = 0;
  reg [FEEDERS-1:0] packet_valid = 0;
  reg [FEEDERS*PACKET_W-1:0] packets = 0;
  wire awready, wready, arready, bvalid, rvalid, read_valid, read_last;
  wire [1:0] bresp, rresp;
  wire [31:0] rdata;
  wire [FEEDERS-1:0] packet_ready;
  wire [READ_W-1:0] read;

  rc2_machine dut (
      .clk_i(clk), .rst_ni(rst_n),
      .s_axil_awvalid(awvalid), .s_axil_awready(awready), .s_axil_awaddr(awaddr),
      .s_axil_wvalid(wvalid), .s_axil_wready(wready), .s_axil_wdata(wdata),
      .s_axil_bvalid(bvalid), .s_axil_bready(bready), .s_axil_bresp(bresp),
      .s_axil_arvalid(arvalid), .s_axil_arready(arready), .s_axil_araddr(araddr),
      .s_axil_rvalid(rvalid), .s_axil_rready(rready), .s_axil_rdata(rdata), .s_axil_rresp(rresp),
      .s_axis_tvalid(packet_valid), .s_axis_tready(packet_ready), .s_axis_tdata(packets),
      .m_axis_tvalid(read_valid), .m_axis_tready(read_ready), .m_axis_tdata(read), .m_axis_tlast(read_last)
  );

  integer file, cycle = 0, compared = 0, wrong = 0, more = 1, k;
  reg [8*256-1:0] path;
  // What a line holds: of an input stream its valid, beat and ready, of an output its ready, valid and beat.
  reg valid, ready;
  reg [127:0] beat;

  task of_input;  // of a stream into the machine
    more = more & ($fscanf(file, "%h %h %h", valid, beat, ready) == 3);
  endtask

  task of_output;
    more = more & ($fscanf(file, "%h %h %h", ready, valid, beat) == 3);
  endtask

  reg [7:0] expected_ready, expected_valid;  // of each stream, in the order of the line
  reg [127:0] expected_b, expected_r, expected_read;

  task line;
    begin
      of_input; awvalid = valid; awaddr = beat; expected_ready[0] = ready;
      of_input; wvalid = valid; wdata = beat; expected_ready[1] = ready;
      of_input; arvalid = valid; araddr = beat; expected_ready[2] = ready;
      for (k = 0; k < FEEDERS; k = k + 1) begin
        of_input; packet_valid[k] = valid; packets[k*PACKET_W+:PACKET_W] = beat; expected_ready[3+k] = ready;
      end
      of_output; bready = ready; expected_valid[0] = valid; expected_b = beat;
      of_output; rready = ready; expected_valid[1] = valid; expected_r = beat;
      of_output; read_ready = ready; expected_valid[2] = valid; expected_read = beat;
    end
  endtask

  task compare(input [8*12-1:0] pin, input [127:0] got, input [127:0] expected);
    begin
      compared = compared + 1;
      if (got !== expected) begin
        wrong = wrong + 1;
        if (wrong <= 10) $display("cycle %0d, %0s: expected %h, got %h", cycle, pin, expected, got);
      end
    end
  endtask

  task check;
    begin
      compare("awready", awready, expected_ready[0]);
      compare("wready", wready, expected_ready[1]);
      compare("arready", arready, expected_ready[2]);
      for (k = 0; k < FEEDERS; k = k + 1) compare("tready", packet_ready[k], expected_ready[3+k]);
      compare("bvalid", bvalid, expected_valid[0]);
      compare("rvalid", rvalid, expected_valid[1]);
      compare("tvalid", read_valid, expected_valid[2]);
      if (expected_valid[0]) compare("bresp", bresp, expected_b);
      if (expected_valid[1]) compare("rdata", {rresp, rdata}, expected_r);
      if (expected_valid[2]) begin
        compare("tlast", read_last, expected_read[63]);
        compare("tdata", read, expected_read[READ_W-1:0]);
      end
    end
  endtask

  initial begin
    if (!$value$plusargs("record=%s", path)) begin
      $display("say which record to replay: +record=FILE");
      $finish;
    end
    file = $fopen(path, "r");
    repeat (2) begin
      #5 clk = 1'b1;
      #5 clk = 1'b0;
    end
    rst_n = 1'b1;
    line;
    while (more) begin
      #4 check;
      #1 clk = 1'b1;
      #5 clk = 1'b0;
      cycle = cycle + 1;
      line;
    end
    $display("%0d cycles, %0d values compared, %0d differences", cycle, compared, wrong);
    $finish;
  end
endmodule
