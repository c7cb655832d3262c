// SPDX-License-Identifier: Apache-2.0
//
// Stands for rc2_voxels where the proof is about light: a column that holds any voxels, which do not
// change, and into which nothing is loaded.

module rc2_voxels (
    input  logic                               clk_i,
    input  logic                               rst_ni,
    input  logic           [rc2_pkg::CoordW-1:0] x_i,
    input  logic           [rc2_pkg::CoordW-1:0] y_i,
    input  logic                               clear_i,
    input  logic                               prepare_i,
    input  logic                               accurate_i,
    input  rc2_pkg::light_t                    source_i,
    input  logic                               word_valid_i,
    input  logic           [rc2_pkg::RowWordW-1:0] word_i,
    output logic                               word_ready_o,
    output logic                               word_valid_o,
    output logic           [rc2_pkg::RowWordW-1:0] word_o,
    input  logic                               word_ready_i,
    output logic           [     rc2_pkg::N-1:0] occupied_o,
    output logic                               fill_o,
    output logic           [rc2_pkg::CoordW-1:0] fill_z_o,
    output logic           [     rc2_pkg::N-1:0] stops_o,
    output logic           [rc2_pkg::CoordW-1:0] light_addr_o,
    input  logic           [ rc2_pkg::HomeW-1:0] light_i,
    input  logic           [ rc2_pkg::HomeW-1:0] ends_i,
    input  logic           [rc2_pkg::ValueW-1:0] visits_i,
    input  logic [rc2_pkg::HistoryW-1:0] history_i,
    output logic                               ray_word_o,
    output logic           [ rc2_pkg::KindW-1:0] ray_kind_o,
    output logic           [ rc2_pkg::RestW-1:0] ray_rest_o,
    input  logic                               ray_ready_i,
    input  logic                               ray_reads_i,
    input  logic           [rc2_pkg::CoordW-1:0] ray_addr_i,
    output rc2_pkg::claim_t                    owner_o,
    output logic           [     rc2_pkg::N-1:0] solid_o,
    output logic                               ray_read_o,
    input  logic                               ray_read_done_i,
    output logic                               ray_read_done_taken_o,
    input  logic                               ray_data_valid_i,
    input  rc2_pkg::data_t                     ray_data_i,
    output logic                               busy_o
);
  (* anyconst *) logic [rc2_pkg::N-1:0] occupied;
  assign occupied_o = occupied;
  assign stops_o = occupied;
  assign word_ready_o = 1'b1;
  assign word_valid_o = 1'b0;
  assign word_o = '0;
  assign fill_o = 1'b0;
  assign fill_z_o = '0;
  assign light_addr_o = '0;
  assign busy_o = 1'b0;
  assign ray_word_o = 1'b0;
  assign ray_kind_o = '0;
  assign ray_rest_o = '0;
  assign owner_o = '0;
  assign solid_o = '0;
  assign ray_read_o = 1'b0;
  assign ray_read_done_taken_o = 1'b0;
endmodule
