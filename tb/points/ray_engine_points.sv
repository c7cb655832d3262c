// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_ray_engine: looks at work side by side, and what they wait for; each of the
// units that take rays by turns, both at once, and one that is done before the older one.

module ray_engine_points (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       clear_i,
    input logic [3:0] wants,
    input logic [3:0] takes,
    input logic [3:0] blocks,
    input logic [3:0] begins_in,
    input logic [3:0] look_launches,
    input logic [8:0] held,
    input logic [8:0] work_o,
    input logic       stops,
    input logic       stop_taken,
    input logic       spawned_i,
    input logic       spawned_taken_o
);
  logic several;
  assign several = (work_o[3:0] & (work_o[3:0] - 1'b1)) != 0;
  always_ff @(posedge clk_i) begin
    if (rst_ni && !clear_i) begin
      two_look : cover (several);
      two_want_the_reader : cover ((wants & (wants - 1'b1)) != 0 && takes != 0);
      reader_is_taken : cover (wants != 0 && takes == 0);
      one_passes_beside_the_reader : cover ((blocks & ~work_o[3:0]) != 0 && (work_o[3:0] & ~blocks) != 0);
      begun_ray_is_read : cover (held[8]);
      begun_ray_waits : cover (begins_in != 0 && look_launches == 0);
      two_begin : cover (work_o[6:5] == 2'b11);
      begins_while_another_leaves : cover (spawned_taken_o && look_launches != 0);
      waits_to_begin : cover (spawned_i && !spawned_taken_o);
      two_meet : cover (work_o[8:7] == 2'b11);
      waits_to_meet : cover (stops && !stop_taken);
    end
  end
  for (genvar q = 0; q < 4; q++) begin : g_quadrant
    always_ff @(posedge clk_i) begin
      if (rst_ni && !clear_i) begin
        looks : cover (work_o[q]);
        gives_to_the_reader : cover (takes[q]);
        is_blocked_by_the_reader : cover (blocks[q]);
        begins : cover (look_launches[q]);
      end
    end
  end
endmodule

bind rc2_ray_engine ray_engine_points u_points (.*);
