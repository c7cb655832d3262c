// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_ray_share: mirrors, glass and both, total reflection, the limit of depth
// and that of weight, a node of each level.

module ray_share_points (
    input rc2_pkg::limits_t              limits_i,
    input logic [  rc2_pkg::NodeW-1:0] node_i,
    input logic [ rc2_pkg::ShareW-1:0] mirror_i,
    input logic [ rc2_pkg::ShareW-1:0] clear_i,
    input logic                        all_back_i,
    input logic                        mirrored_o,
    input logic                        cleared_o,
    input logic [                 1:0] too_light_o,
    input logic [                 1:0] too_deep_o
);
  for (genvar l = 0; l <= rc2_pkg::RAYDEPTH; l++) begin : g_level
    always_comb node : cover ((node_i >> l) == 1);
  end
  always_comb begin
    mirrors : cover (mirrored_o && clear_i == 0);
    lets_through : cover (cleared_o && mirror_i == 0);
    does_both : cover (mirrored_o && cleared_o);
    does_neither : cover (mirror_i == 0 && clear_i == 0);
    reflects_totally : cover (all_back_i && clear_i != 0 && mirrored_o);
    mirrored_alone_is_too_light : cover (too_light_o == 2'd1 && cleared_o);
    cleared_alone_is_too_light : cover (too_light_o == 2'd1 && mirrored_o);
    both_are_too_light : cover (too_light_o == 2'd2);
    is_too_deep : cover (too_deep_o != 0);
    no_bounce_at_all : cover (limits_i.depth == 0 && too_deep_o != 0);
  end
endmodule

bind rc2_ray_share ray_share_points u_points (.*);
