// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_dexel: a bound of every kind (of a slab or a side, the facet's or
// its core's, C > 0, C < 0, C = 0) with every outcome, in packets of every layer.

module dexel_points (
    input logic                       clk_i,
    input logic                       rst_ni,
    input logic                       begins,
    input logic                       dividing_q,
    input logic                       valid_i,
    input logic                       valid_o,
    input logic                       ready_i,
    input logic                       ready_o,
    input logic                       take_i,
    input logic                       nothing,
    input logic                       no_core,
    input logic                       is_gap,
    input logic                       is_slab,
    input logic                       is_side,
    input logic                       flat,
    input logic                       lower_a,
    input logic                       fails_a,
    input logic                       fails_b,
    input logic                       divides_a,
    input logic                       divides_b,
    input logic                       frontless,
    input logic [rc2_pkg::LayerW-1:0] layer_q
);
  for (genvar sign = 0; sign < 3; sign++) begin : g_sign  // 0: C < 0, 1: C = 0, 2: C > 0
    logic here, slab, side;
    assign here = rst_ni && begins && (sign == 1 ? flat : !flat && lower_a == (sign == 2));
    assign slab = here && is_slab;
    assign side = here && is_side;
    always_ff @(posedge clk_i) begin
      back_of_a_slab_empties : cover (slab && fails_a);
      back_of_a_slab_keeps : cover (slab && !fails_a && !divides_a);
      front_of_a_slab_empties : cover (slab && fails_b && !frontless);
      front_of_a_slab_keeps : cover (slab && !fails_b && !divides_b && !frontless);
      front_of_a_slab_is_left_out : cover (slab && frontless);
      side_empties : cover (side && fails_a);
      side_keeps : cover (side && !fails_a && !divides_a);
      side_empties_the_core : cover (side && !fails_a && fails_b);
      side_keeps_the_core : cover (side && !fails_b && !divides_b && !no_core);
    end
    if (sign != 1) begin : g_divides
      always_ff @(posedge clk_i) begin
        back_of_a_slab_divides : cover (slab && divides_a);
        front_of_a_slab_divides : cover (slab && divides_b);
        side_divides : cover (side && divides_a);
        side_divides_the_core : cover (side && divides_b);
        side_divides_both : cover (side && divides_a && divides_b);
      end
    end
  end
  for (genvar layer = 0; layer < 4; layer++) begin : g_layer
    always_ff @(posedge clk_i) if (rst_ni) offers : cover (valid_o && take_i && layer_q == layer);
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      offers_nothing : cover (valid_i && is_gap && nothing && take_i);
      offers_without_core : cover (valid_o && take_i && no_core);
      waits_for_fill : cover (valid_o && !ready_i);
      waits_for_a_quotient : cover (valid_i && dividing_q && !ready_o);
      waits_for_the_stage : cover (valid_i && ready_o && !take_i);
    end
  end
endmodule

bind rc2_dexel dexel_points u_points (.*);
