// SPDX-License-Identifier: Apache-2.0
//
// A queue of rays on their way. The cell looks at the ray at its head once, and may then write what has
// become of it in its place: from the next cycle on it is probed, until it leaves.

module rc2_ray_queue #(
    parameter int unsigned Depth = rc2_pkg::RAYQ,
    localparam int unsigned CountW = $clog2(Depth + 1)
) (
    input  logic                     clk_i,
    input  logic                     rst_ni,
    input  logic                     push_i,
    input  logic [rc2_pkg::RayW-1:0] data_i,
    input  logic                     probe_i,  // the head becomes probe_data_i
    input  logic [rc2_pkg::RayW-1:0] probe_data_i,
    input  logic                     pop_i,
    output logic [rc2_pkg::RayW-1:0] data_o,
    output logic                     probed_o,
    output logic                     along_y_o,  // the way that it goes then
    output logic [       CountW-1:0] count_o
);
  localparam int unsigned PtrW = (Depth <= 1) ? 1 : $clog2(Depth);
  localparam logic [PtrW-1:0] Last = PtrW'(Depth - 1);

  logic [rc2_pkg::RayW-1:0] mem_q[0:Depth-1];
  logic [PtrW-1:0] head_q, tail_q;
  logic [CountW-1:0] count_q;
  logic probed_q;
  rc2_pkg::ray_t head;
  assign head = mem_q[head_q];
  assign data_o = head;
  assign along_y_o = head.along_y;
  assign probed_o = probed_q;
  assign count_o  = count_q;

  always_ff @(posedge clk_i) begin
    if (push_i) mem_q[tail_q] <= data_i;
    if (probe_i) mem_q[head_q] <= probe_data_i;
    if (!rst_ni) begin
      head_q   <= '0;
      tail_q   <= '0;
      count_q  <= '0;
      probed_q <= 1'b0;
    end else begin
      if (push_i) tail_q <= (tail_q == Last) ? '0 : tail_q + 1'b1;
      if (pop_i) head_q <= (head_q == Last) ? '0 : head_q + 1'b1;
      if (push_i && !pop_i) count_q <= count_q + 1'b1;
      if (pop_i && !push_i) count_q <= count_q - 1'b1;
      if (pop_i) probed_q <= 1'b0;
      else if (probe_i) probed_q <= 1'b1;
    end
  end

  // Contract: a ray that is there is probed once; a place is free before it is taken.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!((pop_i || probe_i) && count_q == 0));
      assert (!(probe_i && (probed_q || pop_i)));
      assert (!(push_i && count_q == CountW'(Depth)));
    end
  end
endmodule
