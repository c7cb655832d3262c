// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_ray_home: answers with each number of rays, those that wait for one another,
// first rays, rays sent again, readback that is held up.

module ray_home_points (
    input logic             clk_i,
    input logic             rst_ni,
    input logic             clear_i,
    input logic             run_i,
    input logic             first_i,
    input logic             waits_o,
    input rc2_pkg::start_t  ray_o,
    input logic             taken_i,
    input logic [      4:0] arrived_i,
    input logic [      4:0] arrived_taken_o,
    input rc2_pkg::answer_t answer,
    input logic             read_i,
    input logic             data_valid_o,
    input rc2_pkg::data_t   data_o,
    input logic             data_ready_i
);
  logic taken;
  assign taken = (arrived_taken_o != 0);
  always_ff @(posedge clk_i) begin
    if (rst_ni && !clear_i) begin
      first_ray : cover (first_i);
      waits_for_the_start : cover (first_i && !run_i);
      sends_a_first_ray : cover (taken_i && ray_o.node == 1);
      sends_again : cover (taken_i && ray_o.node != 1);
      ray_waits : cover (waits_o && !taken_i);
      brings_none : cover (taken && !answer.mirrored && !answer.cleared);
      brings_the_mirrored : cover (taken && answer.mirrored && !answer.cleared);
      brings_the_other : cover (taken && !answer.mirrored && answer.cleared);
      brings_both : cover (taken && answer.mirrored && answer.cleared);
      others_wait_meanwhile : cover (arrived_i != 0 && arrived_i != arrived_taken_o);
      takes_and_sends : cover (taken && taken_i);
      read : cover (read_i);
      read_waits : cover (data_valid_o && !data_ready_i);
      read_ends : cover (data_valid_o && data_ready_i && data_o.last);
    end
  end
endmodule

bind rc2_ray_home ray_home_points u_points (.*);
