// SPDX-License-Identifier: Apache-2.0
//
// How far down and up a scene reaches, seen from a cell: for each of the four quadrants of the array
// that the cell is the corner of, the lowest and the highest layer with an occupied voxel. Light
// never turns back along x or y, so the quadrant away from a light holds all that a beam can still
// meet here and further on; on the light's own row or column it is two quadrants.
//
// A quadrant's extent is that of the cell's own column joined with those of two neighbours. What a
// column learns is known to all cells after less than 2n cycles (rc2_machine waits for that), once
// for each scene and whatever the light.

module rc2_extents (
    input  logic                             clk_i,
    input  logic                             rst_ni,
    input  logic                             clear_i,
    input  logic                             fill_i,    // voxel fill_z_i is occupied from now on
    input  logic [rc2_pkg::CoordW-1:0]       fill_z_i,
    // {highest, lowest} of each quadrant, from the neighbour in direction e, n, w, s
    input  logic [rc2_pkg::ReachW-1:0]       ne_e_i,
    input  logic [rc2_pkg::ReachW-1:0]       ne_n_i,
    input  logic [rc2_pkg::ReachW-1:0]       nw_w_i,
    input  logic [rc2_pkg::ReachW-1:0]       nw_n_i,
    input  logic [rc2_pkg::ReachW-1:0]       sw_w_i,
    input  logic [rc2_pkg::ReachW-1:0]       sw_s_i,
    input  logic [rc2_pkg::ReachW-1:0]       se_e_i,
    input  logic [rc2_pkg::ReachW-1:0]       se_s_i,
    output logic [rc2_pkg::ReachW-1:0]       ne_o,
    output logic [rc2_pkg::ReachW-1:0]       nw_o,
    output logic [rc2_pkg::ReachW-1:0]       sw_o,
    output logic [rc2_pkg::ReachW-1:0]       se_o,
    // where the cell is, seen from the light, and what its light can meet: layers min .. max, one
    // cycle after the light is there
    input  logic                             east_i,
    input  logic                             west_i,
    input  logic                             north_i,
    input  logic                             south_i,
    output logic [rc2_pkg::CoordW-1:0]       min_o,
    output logic [rc2_pkg::CoordW-1:0]       max_o
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned ReachW = rc2_pkg::ReachW;

  // ---- The own column ------------------------------------------------------------------------------
  logic [CoordW-1:0] min_q, max_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      {max_q, min_q} <= rc2_pkg::NoReach;
    end else if (fill_i) begin
      if (fill_z_i < min_q) min_q <= fill_z_i;
      if (fill_z_i > max_q) max_q <= fill_z_i;
    end
  end

  // ---- Quadrants 0 ne, 1 nw, 2 sw, 3 se ------------------------------------------------------------
  logic [ReachW-1:0] along_x[0:3];
  logic [ReachW-1:0] along_y[0:3];
  logic [ReachW-1:0] reach[0:3];
  assign along_x[0] = ne_e_i;
  assign along_y[0] = ne_n_i;
  assign along_x[1] = nw_w_i;
  assign along_y[1] = nw_n_i;
  assign along_x[2] = sw_w_i;
  assign along_y[2] = sw_s_i;
  assign along_x[3] = se_e_i;
  assign along_y[3] = se_s_i;
  for (genvar i = 0; i < 4; i++) begin : g_quadrant
    logic [CoordW-1:0] x_min, x_max, y_min, y_max, both_min, both_max;
    logic [ReachW-1:0] reach_q;
    assign {x_max, x_min} = along_x[i];
    assign {y_max, y_min} = along_y[i];
    assign both_min = (x_min < y_min) ? x_min : y_min;
    assign both_max = (x_max > y_max) ? x_max : y_max;
    always_ff @(posedge clk_i) begin
      if (!rst_ni || clear_i) reach_q <= rc2_pkg::NoReach;
      else reach_q <= {(both_max > max_q) ? both_max : max_q, (both_min < min_q) ? both_min : min_q};
    end
    assign reach[i] = reach_q;
  end
  assign ne_o = reach[0];
  assign nw_o = reach[1];
  assign sw_o = reach[2];
  assign se_o = reach[3];

  // ---- Away from the light ---------------------------------------------------------------------------
  // One quadrant twice, or the two on both sides of the light's row or column; in the light's own
  // cell all four.
  logic [ReachW-1:0] one, other;
  logic [CoordW-1:0] one_min, one_max, other_min, other_max, away_min, away_max;
  assign one = west_i ? (south_i ? reach[2] : reach[1]) : (south_i ? reach[3] : reach[0]);
  assign other = east_i ? (north_i ? reach[0] : reach[3]) : (north_i ? reach[1] : reach[2]);
  assign {one_max, one_min} = one;
  assign {other_max, other_min} = other;
  assign away_min = (one_min < other_min) ? one_min : other_min;
  assign away_max = (one_max > other_max) ? one_max : other_max;
  logic source;
  logic [CoordW-1:0] nw_min, nw_max, se_min, se_max, rest_min, rest_max;
  assign source = !(east_i || west_i || north_i || south_i);
  assign {nw_max, nw_min} = reach[1];
  assign {se_max, se_min} = reach[3];
  assign rest_min = (nw_min < se_min) ? nw_min : se_min;
  assign rest_max = (nw_max > se_max) ? nw_max : se_max;
  always_ff @(posedge clk_i) begin
    min_o <= (source && rest_min < away_min) ? rest_min : away_min;
    max_o <= (source && rest_max > away_max) ? rest_max : away_max;
  end

  // Contract: until the next clear an extent only grows, and holds the own column's.
  logic [CoordW-1:0] ne_min, ne_max, ne_min_q, ne_max_q;
  logic grows_q;
  assign {ne_max, ne_min} = reach[0];
  always_ff @(posedge clk_i) begin
    grows_q <= rst_ni && !clear_i;
    ne_min_q <= ne_min;
    ne_max_q <= ne_max;
    if (rst_ni && grows_q) assert (ne_min <= ne_min_q && ne_max >= ne_max_q);
  end
endmodule
