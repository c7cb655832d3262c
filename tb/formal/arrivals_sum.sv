// SPDX-License-Identifier: Apache-2.0
//
// rc2_arrivals adds up all that arrives at a voxel since the start, one arrival in each cycle, also at the
// same voxel: `z` is any one voxel, which may be read whenever nothing arrives.

module arrivals_sum (
    input logic                       clk_i,
    input logic                       start_i,
    input logic                       absorb_i,
    input logic [rc2_pkg::CoordW-1:0] absorb_z_i,
    input logic [ rc2_pkg::HomeW-1:0] area_i,
    input logic [rc2_pkg::CoordW-1:0] read_addr_i
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned HomeW = rc2_pkg::HomeW;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  logic [HomeW-1:0] count;
  logic busy;
  rc2_arrivals u_arrivals (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .start_i    (start_i),
      .absorb_i   (absorb_i),
      .absorb_z_i (absorb_z_i),
      .area_i     (area_i),
      .read_addr_i(read_addr_i),
      .count_o    (count),
      .busy_o     (busy)
  );

  (* anyconst *) logic [CoordW-1:0] z;
  logic arrives_q, read_q, quiet_q;
  logic [CoordW-1:0] arrives_z_q;
  logic [HomeW-1:0] sum_q;
  // Light neither begins while it arrives nor is read then.
  always_comb begin
    assume (!(start_i && (absorb_i || arrives_q)));
    assume (absorb_z_i < CoordW'(rc2_pkg::N) || rc2_pkg::N == (1 << CoordW));
    assume (read_addr_i < CoordW'(rc2_pkg::N) || rc2_pkg::N == (1 << CoordW));
  end
  always_ff @(posedge clk_i) begin
    arrives_q   <= rst_ni && absorb_i;
    arrives_z_q <= absorb_z_i;
    read_q      <= rst_ni && !absorb_i && !arrives_q && read_addr_i == z;
    quiet_q     <= rst_ni && !absorb_i;
    if (!rst_ni || start_i) sum_q <= '0;
    else if (arrives_q && arrives_z_q == z) sum_q <= sum_q + area_i;
  end

  // The word of any one voxel, N = 4.
  (* hierconn *) wire [HomeW-1:0]
      \u_arrivals.u_count.mem_q[0] , \u_arrivals.u_count.mem_q[1] , \u_arrivals.u_count.mem_q[2] ,
      \u_arrivals.u_count.mem_q[3] ;
  (* hierconn *) wire [3:0] \u_arrivals.lit_q ;
  (* hierconn *) wire [CoordW-1:0] \u_arrivals.arriving_z_q ;
  (* hierconn *) wire [HomeW-1:0] \u_arrivals.count_before ;
  logic [HomeW-1:0] word;
  always_comb begin
    case (z)
      2'd0: word = \u_arrivals.u_count.mem_q[0] ;
      2'd1: word = \u_arrivals.u_count.mem_q[1] ;
      2'd2: word = \u_arrivals.u_count.mem_q[2] ;
      default: word = \u_arrivals.u_count.mem_q[3] ;
    endcase
    if (rst_ni) begin
      assert (busy == arrives_q);
      assert ((\u_arrivals.lit_q [z] ? word : '0) == sum_q);
      if (arrives_q) assert (\u_arrivals.arriving_z_q == arrives_z_q);
      if (arrives_q && arrives_z_q == z) assert (\u_arrivals.count_before == sum_q);
      if (read_q && !start_i) assert (count == sum_q);
    end
  end
endmodule
