// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_diffuser: the queue at every level up to a small FA, and full at it;
// all that can become of a beam, and all that can hold it up.

module diffuser_points (
    input logic                              clk_i,
    input logic                              rst_ni,
    input rc2_pkg::light_t                   light_i,
    input logic        [rc2_pkg::QueueW-1:0] count,
    input logic                              valid_i,
    input logic                              take_o,
    input logic                              stopped,
    input logic                              splits,
    input logic                              go,
    input logic                              more,
    input logic                              resumed_q,
    input logic                              own_push,
    input logic                              pop
);
  for (genvar level = 0; level <= 8; level++) begin : g_level
    always_ff @(posedge clk_i) if (rst_ni) held : cover (count == level);
  end
  for (genvar fa = 1; fa <= 8; fa++) begin : g_fa
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        full : cover (count == fa && light_i.fa == fa);
        refuses : cover (count == fa && light_i.fa == fa && valid_i && !take_o);
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      ends_in_a_voxel : cover (stopped);
      leaves_whole : cover (go && !more && !resumed_q);
      leaves_in_part : cover (go && more);
      leaves_the_rest : cover (go && !more && resumed_q);
      waits_for_a_buffer : cover (splits && !go && !resumed_q);
      rest_waits_for_a_buffer : cover (splits && !go && resumed_q);
      own_child : cover (own_push);
      own_child_comes_first : cover (own_push && valid_i);
      gives_and_takes : cover (pop && take_o);
    end
  end
endmodule

bind rc2_diffuser diffuser_points u_points (.*);
