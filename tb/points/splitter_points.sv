// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_splitter: every direction with every shape of split. A beam is cut
// into one to three parts along U and along V, so it has as many children as a product of two such
// numbers: 1, 2, 3, 4, 6 or 9, never 5, 7 or 8.

module splitter_points (
    input logic             valid_i,
    input rc2_pkg::beam_t   beam_i,
    input logic       [2:0] u_part,
    input logic       [2:0] v_part,
    input logic       [7:0] send_o,
    input logic             own_o,
    input logic             more_o,
    input logic             leaves,
    input logic       [2:0] u_kept,
    input logic       [2:0] v_kept
);
  logic [1:0] u_parts, v_parts;
  assign u_parts = 2'(u_part[0]) + 2'(u_part[1]) + 2'(u_part[2]);
  assign v_parts = 2'(v_part[0]) + 2'(v_part[1]) + 2'(v_part[2]);
  logic [3:0] children;
  always_comb begin
    children = 4'(own_o);
    for (int d = 0; d < 8; d++) children = children + 4'(send_o[d]);
  end

  for (genvar d = 0; d < 6; d++) begin : g_direction
    always_comb begin
      split : cover (valid_i && beam_i.dir == d);
      leaves_the_cube : cover (valid_i && beam_i.dir == d && leaves);
    end
  end
  for (genvar u = 1; u <= 3; u++) begin : g_u
    for (genvar v = 1; v <= 3; v++) begin : g_v
      always_comb begin
        z_beam : cover (valid_i && beam_i.dir[2] && u_parts == u && v_parts == v);
        side_beam : cover (valid_i && !beam_i.dir[2] && u_parts == u && v_parts == v);
      end
    end
  end
  for (genvar n = 0; n <= 9; n++) begin : g_children
    if (n != 5 && n != 7 && n != 8) begin : g_possible
      always_comb made : cover (valid_i && children == n);
    end
  end
  always_comb begin
    remainder_stays : cover (valid_i && more_o);
    u_low_escapes : cover (valid_i && !leaves && u_part[0] && !u_kept[0]);
    u_high_escapes : cover (valid_i && !leaves && u_part[2] && !u_kept[2]);
    v_escapes : cover (valid_i && !leaves && v_kept == 0);
  end
endmodule

bind rc2_splitter splitter_points u_points (.*);
