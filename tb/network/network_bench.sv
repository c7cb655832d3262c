// The networks of every scheme side by side, on the same starts.
module network_bench #(
    parameter int Radius = 4,
    parameter int Columns = 4,
    localparam int CircleBits = (Radius + 1) * (Radius + 2) / 2,
    localparam int SegmentBits = (Columns + 1) * (Columns + 2) / 2
) (
    input  logic [Radius:0]        circle,
    input  logic [Columns:0]       segment,
    output logic [CircleBits-1:0]  circles  [4],
    output logic [SegmentBits-1:0] segments [5]
);
  circles_star u_circles_star (.start(circle), .lit(circles[0]));
  circles_chain u_circles_chain (.start(circle), .lit(circles[1]));
  circles_tree u_circles_tree (.start(circle), .lit(circles[2]));
  circles_tree_4 u_circles_tree_4 (.start(circle), .lit(circles[3]));

  segments_star u_segments_star (.start(segment), .lit(segments[0]));
  segments_chain u_segments_chain (.start(segment), .lit(segments[1]));
  segments_tree u_segments_tree (.start(segment), .lit(segments[2]));
  segments_tree_4 u_segments_tree_4 (.start(segment), .lit(segments[3]));
  segments_nearest u_segments_nearest (.start(segment), .lit(segments[4]));
endmodule
