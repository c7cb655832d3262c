// SPDX-License-Identifier: Apache-2.0
//
// Counts the targets that arrive at each voxel of a column in thesis mode. A count takes a new
// arrival every cycle, also at the same voxel: the sum written in the cycle before is bypassed, as
// the RAM still shows the old one. A count means something where lit, so that the RAM needs no
// clearing.

module rc2_arrivals (
    input  logic                       clk_i,
    input  logic                       rst_ni,
    input  logic                       start_i,      // forget the light
    // absorb_i announces an arrival at absorb_z_i, its number of targets follows in the next cycle
    input  logic                       absorb_i,
    input  logic [rc2_pkg::CoordW-1:0] absorb_z_i,
    input  logic [ rc2_pkg::HomeW-1:0] area_i,
    input  logic [rc2_pkg::CoordW-1:0] read_addr_i,  // while no light is under way
    output logic [ rc2_pkg::HomeW-1:0] count_o,      // of the address in the cycle before
    output logic                       busy_o
);
  localparam int unsigned N = rc2_pkg::N;
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned HomeW = rc2_pkg::HomeW;

  logic arriving_q, bypass_q;
  logic [N-1:0] lit_q;
  logic [CoordW-1:0] arriving_z_q;
  logic [HomeW-1:0] count_read, count_before, count_sum, bypass_count_q;
  rc2_ram #(
      .Width(HomeW),
      .Depth(N)
  ) u_count (
      .clk_i       (clk_i),
      .write_i     (arriving_q),
      .write_addr_i(arriving_z_q),
      .write_data_i(count_sum),
      .read_addr_i (absorb_i ? absorb_z_i : read_addr_i),
      .read_data_o (count_read)
  );
  assign count_before = !lit_q[arriving_z_q] ? '0 : bypass_q ? bypass_count_q : count_read;
  assign count_sum = count_before + area_i;
  assign busy_o = arriving_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      arriving_q <= 1'b0;
      lit_q      <= '0;
    end else begin
      arriving_q <= absorb_i;
      if (start_i) lit_q <= '0;
      else if (arriving_q) lit_q[arriving_z_q] <= 1'b1;
    end
    arriving_z_q   <= absorb_i ? absorb_z_i : read_addr_i;
    bypass_q       <= arriving_q && (absorb_z_i == arriving_z_q);
    bypass_count_q <= count_sum;
  end
  // The address read is that of arriving_z_q too, so its lit bit says whether the count counts.
  assign count_o = lit_q[arriving_z_q] ? count_read : '0;

  // Contract: a new light never interrupts the old one.
  always_ff @(posedge clk_i) if (rst_ni) assert (!(start_i && arriving_q));
endmodule
