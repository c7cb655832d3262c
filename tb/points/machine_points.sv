// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_machine: every pattern of valid and ready on each stream of the host
// port, every command and light rule, and of machines that skip and that do not.

module machine_points (
    input logic                        clk_i,
    input logic                        rst_ni,
    input logic                        s_axil_awvalid,
    input logic                        s_axil_wvalid,
    input logic                        s_axil_bvalid,
    input logic                        s_axil_bready,
    input logic                        s_axil_arvalid,
    input logic                        s_axil_rvalid,
    input logic                        s_axil_rready,
    input logic [rc2_pkg::FEEDERS-1:0] s_axis_tvalid,
    input logic [rc2_pkg::FEEDERS-1:0] s_axis_tready,
    input logic                        m_axis_tvalid,
    input logic                        m_axis_tready,
    input logic                        m_axis_tlast,
    input logic                        clear_q,
    input logic                        prepare_q,
    input logic                        start_q,
    input logic                        accurate_q,
    input logic [  rc2_pkg::HomeW-1:0] home,
    input logic [  rc2_pkg::HomeW-1:0] skipped,
    input logic                        light_busy,
    input logic                        settling
);
  // {valid, ready} of the streams where they are free of each other.
  for (genvar p = 0; p < 4; p++) begin : g_valid_ready
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        b : cover ({s_axil_bvalid, s_axil_bready} == p);
        r : cover ({s_axil_rvalid, s_axil_rready} == p);
        readback : cover ({m_axis_tvalid, m_axis_tready} == p);
      end
    end
    for (genvar k = 0; k < rc2_pkg::FEEDERS; k++) begin : g_packets
      always_ff @(posedge clk_i) packets : cover (rst_ni && {s_axis_tvalid[k], s_axis_tready[k]} == p);
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      aw_waits_for_w : cover (s_axil_awvalid && !s_axil_wvalid);
      w_waits_for_aw : cover (!s_axil_awvalid && s_axil_wvalid);
      aw_and_w_wait_for_b : cover (s_axil_awvalid && s_axil_wvalid && s_axil_bvalid);
      aw_and_w_move : cover (s_axil_awvalid && s_axil_wvalid && !s_axil_bvalid);
      ar_waits_for_r : cover (s_axil_arvalid && s_axil_rvalid);
      ar_moves : cover (s_axil_arvalid && !s_axil_rvalid);
      end_of_readback_waits : cover (m_axis_tvalid && m_axis_tlast && !m_axis_tready);
      end_of_readback_moves : cover (m_axis_tvalid && m_axis_tlast && m_axis_tready);
      forgets : cover (clear_q);
    end
  end
  if (rc2_pkg::THESIS) begin : g_thesis
    always_ff @(posedge clk_i) lights : cover (rst_ni && start_q);
  end else begin : g_lanes
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        prepares : cover (prepare_q);
        lights_by_the_thesis_rule : cover (start_q && !accurate_q);
        lights_by_the_accurate_rule : cover (start_q && accurate_q);
        light_is_busy : cover (light_busy);
      end
    end
    if (rc2_pkg::SKIPS) begin : g_skips
      always_ff @(posedge clk_i) begin
        learns_the_extents : cover (rst_ni && settling);
        skips_all : cover (rst_ni && home != 0 && skipped == home);
        skips_some : cover (rst_ni && skipped != 0 && skipped != home);
        skips_none : cover (rst_ni && home != 0 && skipped == 0);
      end
    end else begin : g_skips_nothing
      always_ff @(posedge clk_i) comes_home : cover (rst_ni && home != 0);
    end
  end
endmodule

bind rc2_machine machine_points u_points (.*);
