// SPDX-License-Identifier: Apache-2.0
//
// What the splitter sends leaves once, over the link of its direction, unchanged until the neighbour is
// ready. `way` is any one of the eight links. A child is the part of U and the part of V that lie that
// way (thesis 4.3.4.1); a side beam's V parts are all the same, as rc2_splitter makes them.

module router_out (
    input logic                      clk_i,
    input logic [               7:0] send_i,
    input rc2_pkg::split_t           split_i,
    input logic [               7:0] link_ready_i
);
  localparam int unsigned BeamW = rc2_pkg::BeamW;
  localparam int unsigned TargetW = rc2_pkg::TargetW;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  logic [7:0] writable, valid;
  logic [BeamW-1:0] link0, link1, link2, link3, link4, link5, link6, link7, link;
  (* anyconst *) rc2_pkg::light_t light;
  rc2_router u_router (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .x_i           ('0),
      .y_i           ('0),
      .start_i       (1'b0),
      .light_i       (light),
      .link_valid_i  (8'd0),
      .link0_i       ('0),
      .link1_i       ('0),
      .link2_i       ('0),
      .link3_i       ('0),
      .link4_i       ('0),
      .link5_i       ('0),
      .link6_i       ('0),
      .link7_i       ('0),
      .link_valid_o  (valid),
      .link_ready_i  (link_ready_i),
      .link0_o       (link0),
      .link1_o       (link1),
      .link2_o       (link2),
      .link3_o       (link3),
      .link4_o       (link4),
      .link5_o       (link5),
      .link6_o       (link6),
      .link7_o       (link7),
      .arrival_take_i(1'b0),
      .writable_o    (writable),
      .split_i       (split_i),
      .send_i        (send_i)
  );
  always_comb begin
    assume ((send_i & ~writable) == 0);
    assume (split_i.dir[2] || (split_i.v_low_min == split_i.v_mid_min && split_i.v_mid_min == split_i.v_high_min));
    assume (split_i.dir[2] || (split_i.v_low_max == split_i.v_mid_max && split_i.v_mid_max == split_i.v_high_max));
  end

  // ---- Any one way, E first, counter-clockwise ---------------------------------------------------
  (* anyconst *) logic [2:0] way;
  logic [1:0] x_part, y_part, u_part;  // 0 low, 1 middle, 2 high
  always_comb begin
    case (way)
      3'd0: {x_part, y_part, link} = {2'd2, 2'd1, link0};
      3'd1: {x_part, y_part, link} = {2'd2, 2'd2, link1};
      3'd2: {x_part, y_part, link} = {2'd1, 2'd2, link2};
      3'd3: {x_part, y_part, link} = {2'd0, 2'd2, link3};
      3'd4: {x_part, y_part, link} = {2'd0, 2'd1, link4};
      3'd5: {x_part, y_part, link} = {2'd0, 2'd0, link5};
      3'd6: {x_part, y_part, link} = {2'd1, 2'd0, link6};
      default: {x_part, y_part, link} = {2'd2, 2'd0, link7};
    endcase
  end
  // U runs along y on the x faces, else along x; V along y on the z faces, else along z.
  assign u_part = (split_i.dir[2:1] == 2'd0) ? y_part : x_part;
  logic [2*TargetW-1:0] u, v;
  always_comb begin
    case (u_part)
      2'd0: u = {split_i.u_low_min, split_i.u_low_max};
      2'd1: u = {split_i.u_mid_min, split_i.u_mid_max};
      default: u = {split_i.u_high_min, split_i.u_high_max};
    endcase
    case (split_i.dir[2] ? y_part : 2'd0)
      2'd0: v = {split_i.v_low_min, split_i.v_low_max};
      2'd1: v = {split_i.v_mid_min, split_i.v_mid_max};
      default: v = {split_i.v_high_min, split_i.v_high_max};
    endcase
  end

  logic full_q;
  logic [BeamW-1:0] child_q;
  always_ff @(posedge clk_i) begin
    full_q <= rst_ni && (send_i[way] || (full_q && !link_ready_i[way]));
    if (send_i[way]) child_q <= {split_i.dir, split_i.z, u, v};
  end
  always_comb begin
    if (rst_ni) begin
      assert (valid[way] == full_q);
      assert (!full_q || link == child_q);
      assert (writable[way] == (!full_q || link_ready_i[way]));
    end
  end
endmodule
