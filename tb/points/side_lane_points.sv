// SPDX-License-Identifier: Apache-2.0
//
// What tests must have seen of rc2_side_lane: beams from and to all neighbours, every kind of choice
// between the two FIFOs (docs/light.md, "Joining is exact"), their levels, and what a beam waits for.

module side_lane_points (
    input logic                                    clk_i,
    input logic                                    rst_ni,
    input logic                              [7:0] valid_i,
    input logic                              [7:0] valid_o,
    input logic                              [7:0] room_i,
    input logic                              [7:0] wanted,
    input logic signed         [rc2_pkg::OffW-1:0] dx_i,
    input logic signed         [rc2_pkg::OffW-1:0] dy_i,
    input logic [$clog2((rc2_pkg::FAMAX+1)/2+1)-1:0] limit,
    input logic [$clog2((rc2_pkg::FAMAX+1)/2+1)-1:0] straight_count,
    input logic [$clog2((rc2_pkg::FAMAX+1)/2+1)-1:0] diagonal_count,
    input rc2_pkg::lane_t                          beam,
    input rc2_pkg::lane_t                          chosen,
    input logic                                    load,
    input logic                                    both,
    input logic                                    joined,
    input logic                                    straight_first,
    input logic                                    left,
    input logic                                    beyond_i,
    input logic                                    beam_q,
    input logic                                    source,
    input logic                                    known,
    input logic                                    go,
    input logic                                    serve,
    input logic                                    passes,
    input logic                                    more
);
  for (genvar d = 0; d < 8; d++) begin : g_link
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        comes : cover (valid_i[d]);
        goes : cover (valid_o[d]);
        waits_for_room : cover (beam_q && !go && wanted[d] && !room_i[d]);
      end
    end
  end
  for (genvar level = 0; level <= 2; level++) begin : g_level
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        straight : cover (straight_count == level);
        diagonal : cover (diagonal_count == level);
      end
    end
  end
  for (genvar places = 1; places <= 2; places++) begin : g_full
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        straight : cover (straight_count == places && limit == places);
        diagonal : cover (diagonal_count == places && limit == places);
      end
    end
  end

  logic one, on_a_diagonal;
  assign one = load && !both;
  assign on_a_diagonal = (dx_i == dy_i) || (dx_i == -dy_i);
  for (genvar y = 0; y < 2; y++) begin : g_along  // 0: a beam along x, 1: along y
    logic here;
    assign here = (chosen.along_y == (y == 1));
    always_ff @(posedge clk_i) begin
      if (rst_ni) begin
        joined_with_a_diagonal_one : cover (load && joined && here);
        straight_alone : cover (one && straight_first && here);
        diagonal_alone : cover (one && !straight_first && here && !on_a_diagonal);
        diagonal_on_the_arrays_diagonal : cover (one && !straight_first && here && on_a_diagonal);
        lower_straight_first : cover (load && both && !joined && straight_first && here);
        lower_diagonal_first : cover (load && both && !joined && !straight_first && here);
        from_the_source : cover (serve && source && (beam.along_y == (y == 1)));
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      on_an_edge : cover (serve && beam.edge_u && !source);
      all_stopped : cover (serve && !passes);
      free_part_goes_on : cover (serve && passes && more);
      last_part_goes_on : cover (serve && passes && !more);
      nothing_left_of_it : cover (load && !left && beyond_i);
    end
  end
  // The table is there before the beam as long as no column can have a fourth run.
  if ((rc2_pkg::N + 1) / 2 > 3) begin : g_late
    always_ff @(posedge clk_i) if (rst_ni) not_in_the_table : cover (beam_q && !source && !known);
  end
  if (rc2_pkg::SKIPS) begin : g_skips
    always_ff @(posedge clk_i) if (rst_ni) nothing_to_meet : cover (load && !beyond_i);
  end
endmodule

bind rc2_side_lane side_lane_points u_points (.*);
