// SPDX-License-Identifier: Apache-2.0
//
// Counts targets. One cycle after targets are served, area_o is their number, and those that do
// not travel on (absorbed, or out of the cube) start their way home: every cell adds its own to
// the running sum that comes from its neighbour and passes it on, one cell per cycle. The root
// adds up what arrives; when it holds 24*L*L + 2 the light is done (thesis 4.4.4 asks for such a
// test and has none).

module rc2_tally (
    input  logic                        clk_i,
    input  logic                        rst_ni,
    input  logic                        served_i,
    input  logic [rc2_pkg::ExtentW-1:0] served_u_i,
    input  logic [rc2_pkg::ExtentW-1:0] served_v_i,
    input  logic [rc2_pkg::ExtentW-1:0] kept_u_i,
    input  logic [rc2_pkg::ExtentW-1:0] kept_v_i,
    output logic [  rc2_pkg::HomeW-1:0] area_o,
    input  logic [  rc2_pkg::HomeW-1:0] home_i,
    output logic [  rc2_pkg::HomeW-1:0] home_o,
    output logic                        busy_o
);
  localparam int unsigned HomeW = rc2_pkg::HomeW;

  logic served_q;
  logic [rc2_pkg::ExtentW-1:0] served_u_q, served_v_q, kept_u_q, kept_v_q;
  logic [HomeW-1:0] kept, done, home_q;

  assign area_o = HomeW'(served_u_q) * HomeW'(served_v_q);
  assign kept = HomeW'(kept_u_q) * HomeW'(kept_v_q);
  assign done = served_q ? area_o - kept : '0;
  assign home_o = home_q;
  assign busy_o = served_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      served_q <= 1'b0;
      home_q   <= '0;
    end else begin
      served_q <= served_i;
      home_q   <= home_i + done;
    end
    if (served_i) begin
      served_u_q <= served_u_i;
      served_v_q <= served_v_i;
      kept_u_q   <= kept_u_i;
      kept_v_q   <= kept_v_i;
    end
  end

  // Contract: nobody keeps more than was served.
  always_ff @(posedge clk_i) begin
    if (rst_ni && served_q) assert (kept <= area_o);
  end
endmodule
