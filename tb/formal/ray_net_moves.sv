// SPDX-License-Identifier: Apache-2.0
//
// Side x Side cells of rays with queues of one place: while there is a message or a ray, one moves, whatever
// engines and homes do (ray_cell.sv).
//
// Unbounded. That something moves is not shown by following runs, but of each state: who waits longest along
// any chain of waits has nobody to wait for, because a ray's queue waits for the next cell's of its quadrant, one
// that runs along x for one of the same way or for one along y. For that a state must be sound, and this is what
// `sound` says: what lies in a queue goes a way that its queue can go, and not out of the array.

module ray_net_moves #(
    parameter int unsigned Side = 2,
    localparam int unsigned Cells = Side * Side,
    localparam int unsigned WantW = 35 + 7 * rc2_pkg::NodeW + 4 * rc2_pkg::CoordW
) (
    input logic                   clk_i,
    input logic [Cells*WantW-1:0] want_i
);
  localparam int unsigned CoordW = rc2_pkg::CoordW;
  localparam int unsigned LinkW = rc2_pkg::LinkW;
  localparam int unsigned LinkRoomW = rc2_pkg::LinkRoomW;

  logic rst_ni = 1'b0;
  always_ff @(posedge clk_i) rst_ni <= 1'b1;

  // Links by the cell that they leave, and room by the cell that has it; around the array lies nothing. (Yosys
  // 0.23 misreads `c ? x : W'(0)` within braces in a loop, so the zeros are repeated bits.)
  logic [4*Cells*LinkW-1:0] out;
  logic [4*Cells*LinkRoomW-1:0] room;
  logic [Cells-1:0] has_any, moves, sound;
  for (genvar y = 0; y < Side; y++) begin : g_y
    for (genvar x = 0; x < Side; x++) begin : g_x
      localparam int unsigned I = y * Side + x;
      localparam int unsigned West = (x > 0) ? I - 1 : I;
      localparam int unsigned East = (x < Side - 1) ? I + 1 : I;
      localparam int unsigned South = (y > 0) ? I - Side : I;
      localparam int unsigned North = (y < Side - 1) ? I + Side : I;
      logic sound_cell;
      logic [4*LinkW-1:0] link_in;
      logic [4*LinkRoomW-1:0] room_in;
      // What goes east comes from the west.
      assign link_in = {
        (y < Side - 1) ? out[(4*North+3)*LinkW+:LinkW] : {LinkW{1'b0}},
        (y > 0) ? out[(4*South+2)*LinkW+:LinkW] : {LinkW{1'b0}},
        (x < Side - 1) ? out[(4*East+1)*LinkW+:LinkW] : {LinkW{1'b0}},
        (x > 0) ? out[4*West*LinkW+:LinkW] : {LinkW{1'b0}}
      };
      assign room_in = {
        (y > 0) ? room[(4*South+3)*LinkRoomW+:LinkRoomW] : {LinkRoomW{1'b0}},
        (y < Side - 1) ? room[(4*North+2)*LinkRoomW+:LinkRoomW] : {LinkRoomW{1'b0}},
        (x > 0) ? room[(4*West+1)*LinkRoomW+:LinkRoomW] : {LinkRoomW{1'b0}},
        (x < Side - 1) ? room[4*East*LinkRoomW+:LinkRoomW] : {LinkRoomW{1'b0}}
      };
      ray_cell #(
          .Side(Side)
      ) u_cell (
          .clk_i    (clk_i),
          .rst_ni   (rst_ni),
          .want_i   (want_i[WantW*I+:WantW]),
          .x_i      (CoordW'(x)),
          .y_i      (CoordW'(y)),
          .link_i   (link_in),
          .room_o   (room[4*I*LinkRoomW+:4*LinkRoomW]),
          .link_o   (out[4*I*LinkW+:4*LinkW]),
          .room_i   (room_in),
          .has_any_o(has_any[I]),
          .moves_o  (moves[I]),
          .sound_o  (sound_cell)
      );
      (* hierconn *) wire [18:0] \u_cell.u_net.has ;
      (* hierconn *) wire [94:0] \u_cell.u_net.wish ;
      // A sender's ways E W N S, and here; none of them leads out of the array.
      logic [3:0] border;
      assign border = {y == 0, y == Side - 1, x == 0, x == Side - 1};
      logic [18:0] out_of, turned, lost;
      always_comb begin
        for (int s = 0; s < 19; s++) begin
          out_of[s] = (\u_cell.u_net.wish [5*s+:4] & border) != 0;
          // Answers and starts go somewhere.
          lost[s] = (s >= 9) && \u_cell.u_net.has [s] && \u_cell.u_net.wish [5*s+:5] == 0;
        end
        // And on or, from x to y, aside, never back.
        turned = '0;
        for (int s = 9; s < 19; s += 5) begin
          turned[s] = \u_cell.u_net.wish [5*s+1];
          turned[s+1] = \u_cell.u_net.wish [5*(s+1)];
          turned[s+2] = \u_cell.u_net.wish [5*(s+2)+:2] != 0 || \u_cell.u_net.wish [5*(s+2)+3];
          turned[s+3] = \u_cell.u_net.wish [5*(s+3)+:3] != 0;
        end
      end
      assign sound[I] = (out_of | turned | lost) == 0 && sound_cell;
    end
  end

  always_comb begin
    if (rst_ni) begin
      assert (sound == '1);
      assert (has_any == 0 || moves != 0);
    end
  end
endmodule
