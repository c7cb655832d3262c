// SPDX-License-Identifier: Apache-2.0
//
// What the rays from a hit are worth, and which of them are sent (rays::split, thesis 1.2.5.1): not those
// beyond the limit of depth, nor those worth too little. What glass cannot let through it mirrors.
// Combinational.

module rc2_ray_share (
    input  rc2_pkg::limits_t                limits_i,
    input  logic [   rc2_pkg::NodeW-1:0] node_i,
    input  logic [ rc2_pkg::WeightW-1:0] weight_i,
    input  logic [  rc2_pkg::ShareW-1:0] mirror_i,
    input  logic [  rc2_pkg::ShareW-1:0] clear_i,
    input  logic                         all_back_i,
    output logic                         mirrored_o,
    output logic [ rc2_pkg::WeightW-1:0] mirrored_weight_o,
    output logic                         cleared_o,
    output logic [ rc2_pkg::WeightW-1:0] cleared_weight_o,
    output logic [                  1:0] too_light_o,
    output logic [                  1:0] too_deep_o
);
  localparam int unsigned ShareW = rc2_pkg::ShareW;
  localparam int unsigned WeightW = rc2_pkg::WeightW;
  localparam int unsigned ProductW = WeightW + ShareW;
  localparam logic [ShareW:0] All = (ShareW + 1)'(1) << (ShareW - 1);

  logic [ShareW:0] both;
  logic [ShareW-1:0] mirror, clear;
  logic [ProductW-1:0] mirrored, cleared;
  logic deep, mirror_light, clear_light;
  assign both = (ShareW + 1)'(mirror_i) + (all_back_i ? (ShareW + 1)'(clear_i) : '0);
  assign mirror = (both > All) ? ShareW'(All) : ShareW'(both);
  assign clear = all_back_i ? '0 : clear_i;
  assign mirrored = ProductW'(weight_i) * ProductW'(mirror);
  assign cleared = ProductW'(weight_i) * ProductW'(clear);
  assign mirrored_weight_o = WeightW'(mirrored >> (ShareW - 1));
  assign cleared_weight_o = WeightW'(cleared >> (ShareW - 1));
  assign mirror_light = (mirrored_weight_o == 0) || (mirrored_weight_o < limits_i.least);
  assign clear_light = (cleared_weight_o == 0) || (cleared_weight_o < limits_i.least);
  // A node of depth d has bit d as its highest.
  assign deep = ((node_i >> limits_i.depth) != 0);

  assign mirrored_o = !mirror_light && !deep;
  assign cleared_o = !clear_light && !deep;
  assign too_light_o = 2'(mirror_light && mirror != 0) + 2'(clear_light && clear != 0);
  assign too_deep_o = 2'(!mirror_light && deep) + 2'(!clear_light && deep);
endmodule
