// SPDX-License-Identifier: Apache-2.0
//
// What comes over the links reaches the queue once and unchanged. `beam` is any one beam: as many of it
// have been accepted and not yet taken as lie in the eight input buffers. A lost, doubled or changed
// beam would break the balance for its own value, or for that which it became.

module router_in (
    input logic                    clk_i,
    input logic                    start_i,
    input logic [             7:0] link_valid_i,
    input logic [             7:0] link_ready_i,
    input logic [rc2_pkg::BeamW-1:0] link0_i,
    input logic [rc2_pkg::BeamW-1:0] link1_i,
    input logic [rc2_pkg::BeamW-1:0] link2_i,
    input logic [rc2_pkg::BeamW-1:0] link3_i,
    input logic [rc2_pkg::BeamW-1:0] link4_i,
    input logic [rc2_pkg::BeamW-1:0] link5_i,
    input logic [rc2_pkg::BeamW-1:0] link6_i,
    input logic [rc2_pkg::BeamW-1:0] link7_i,
    input logic                    take_i
);
  localparam int unsigned BeamW = rc2_pkg::BeamW;
  localparam int unsigned CoordW = rc2_pkg::CoordW;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  (* anyconst *) rc2_pkg::light_t light;
  (* anyconst *) logic [CoordW-1:0] x;
  (* anyconst *) logic [CoordW-1:0] y;
  logic [7:0] ready;
  logic arrival_valid;
  logic [BeamW-1:0] arrival;
  rc2_router u_router (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .x_i            (x),
      .y_i            (y),
      .start_i        (start_i),
      .light_i        (light),
      .link_valid_i   (link_valid_i),
      .link_ready_o   (ready),
      .link0_i        (link0_i),
      .link1_i        (link1_i),
      .link2_i        (link2_i),
      .link3_i        (link3_i),
      .link4_i        (link4_i),
      .link5_i        (link5_i),
      .link6_i        (link6_i),
      .link7_i        (link7_i),
      .link_ready_i   (link_ready_i),
      .arrival_valid_o(arrival_valid),
      .arrival_o      (arrival),
      .arrival_take_i (take_i),
      .split_i        ('0),
      .send_i         (8'd0)
  );
  (* hierconn *) wire [8:0] \u_router.grant ;
  (* hierconn *) wire \u_router.u_source.active_q ;
  (* hierconn *) wire
      \u_router.g_in[0].u_slot.valid_q , \u_router.g_in[1].u_slot.valid_q ,
      \u_router.g_in[2].u_slot.valid_q , \u_router.g_in[3].u_slot.valid_q ,
      \u_router.g_in[4].u_slot.valid_q , \u_router.g_in[5].u_slot.valid_q ,
      \u_router.g_in[6].u_slot.valid_q , \u_router.g_in[7].u_slot.valid_q ;
  (* hierconn *) wire [BeamW-1:0]
      \u_router.g_in[0].u_slot.data_q , \u_router.g_in[1].u_slot.data_q ,
      \u_router.g_in[2].u_slot.data_q , \u_router.g_in[3].u_slot.data_q ,
      \u_router.g_in[4].u_slot.data_q , \u_router.g_in[5].u_slot.data_q ,
      \u_router.g_in[6].u_slot.data_q , \u_router.g_in[7].u_slot.data_q ;

  always_comb begin
    assume (light.distance != 0 && light.fa != 0);
    assume (!take_i || arrival_valid);
    assume (!start_i || !\u_router.u_source.active_q );
  end

  // ---- Any one beam ----------------------------------------------------------------------------
  (* anyconst *) logic [BeamW-1:0] beam;
  logic [7:0] comes, held;
  assign comes = link_valid_i & ready & {
      link7_i == beam, link6_i == beam, link5_i == beam, link4_i == beam,
      link3_i == beam, link2_i == beam, link1_i == beam, link0_i == beam};
  assign held = {
      \u_router.g_in[7].u_slot.valid_q && \u_router.g_in[7].u_slot.data_q == beam,
      \u_router.g_in[6].u_slot.valid_q && \u_router.g_in[6].u_slot.data_q == beam,
      \u_router.g_in[5].u_slot.valid_q && \u_router.g_in[5].u_slot.data_q == beam,
      \u_router.g_in[4].u_slot.valid_q && \u_router.g_in[4].u_slot.data_q == beam,
      \u_router.g_in[3].u_slot.valid_q && \u_router.g_in[3].u_slot.data_q == beam,
      \u_router.g_in[2].u_slot.valid_q && \u_router.g_in[2].u_slot.data_q == beam,
      \u_router.g_in[1].u_slot.valid_q && \u_router.g_in[1].u_slot.data_q == beam,
      \u_router.g_in[0].u_slot.valid_q && \u_router.g_in[0].u_slot.data_q == beam};
  logic goes;
  assign goes = take_i && arrival == beam && !\u_router.grant [8];

  logic [3:0] came, holds, balance_q;
  always_comb begin
    came = 4'd0;
    holds = 4'd0;
    for (int d = 0; d < 8; d++) begin
      came = came + 4'(comes[d]);
      holds = holds + 4'(held[d]);
    end
  end
  always_ff @(posedge clk_i) balance_q <= !rst_ni ? 4'd0 : balance_q + came - 4'(goes);
  always_comb assert (!rst_ni || balance_q == holds);
endmodule
