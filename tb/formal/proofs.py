"""The proofs of scripts/formal, in the order of docs/proofs.md."""

from prove import Fault, Proof

SMALL = (("N", 4), ("LMAX", 8))
USUAL = (("N", 16), ("LMAX", 64))
RAYS = (("N", 3), ("F", 0), ("RAYS", 1), ("RAYDEPTH", 1), ("RAYQ", 1))
LARGE = (("N", 64), ("LMAX", 256))

PROOFS = [
    # Buffers
    *(Proof("fifo_order", "same words, same order, same number as a queue that shifts", "rc2_fifo", "induction",
            Fault("parts/rc2_fifo.sv", "if (pop_i && !push_i) count_q", "if (pop_i) count_q"), 2,
            params=(("Depth", depth),))
      for depth in (1, 2, 3, 4, 8, 16)),
    Proof("slot_keeps", "what is accepted is shown unchanged until it is taken", "rc2_slot", "induction",
          Fault("parts/rc2_slot.sv", "if (valid_i && !valid_q) data_q", "if (valid_i) data_q"), 2),
    Proof("half_table", "1/2k rounded up, for every k", "rc2_half", "all inputs",
          Fault("parts/rc2_half.sv", "if (rest != 0) quotient", "if (rest == 0) quotient"),
          params=(("Most", 16), ("FracW", 16))),
    # Router
    Proof("rotate_fair", "who keeps asking waits for at most Ways − 1 others", "rc2_rotate", "induction",
          Fault("parts/rc2_rotate.sv", "~(grant_o | (grant_o - 1'b1))", "~(grant_o - 1'b1)"), 2, reach=16,
          params=(("Ways", 9),)),
    *(Proof("router_in", "of every beam as many reach the queue as were accepted", "rc2_router", "induction",
            Fault("net/rc2_router.sv", "arrival_take_i && grant[d]", "arrival_take_i && waiting[d]"), 2, macros=size,
            fast=size == SMALL) for size in (SMALL, USUAL)),
    *(Proof("router_out", "a child leaves once, by its link, unchanged until it is taken", "rc2_router, rc2_link",
            "induction", Fault("net/rc2_link.sv", "beam_q.umin <= u_is_y ? y_min : x_min",
                               "beam_q.umin <= u_is_y ? x_min : y_min"), 2, macros=size,
            fast=size == SMALL) for size in (SMALL, USUAL)),
    Proof("source_six", "the six first beams part the surface of the virtual cube", "rc2_source", "bounded",
          Fault("light/rc2_source.sv", "dir_q[2] ? inner : full", "dir_q[2] ? full : full"), 12, macros=USUAL),
    # Lanes: fronts, runs, extents
    *(Proof("matrix_out_goes", "every bit of a front goes where its two classes go", "rc2_matrix_out", "all inputs",
            Fault("lanes/rc2_matrix_out.sv", "assign y_o[i*M+:M] = u_stay[i*M+:M] >> v_leave_i;",
                  "assign y_o[i*M+:M] = u_stay[i*M+:M] >> v_stay_i;"), macros=size,
            fast=size == USUAL) for size in (USUAL, LARGE)),
    *(Proof("matrix_in_joins", "the next front is what has come, then what stayed, along both axes", "rc2_matrix_in",
            "all inputs", Fault("lanes/rc2_matrix_in.sv", "(came & v_comes)", "came"),
            macros=size, fast=size == USUAL) for size in (USUAL, LARGE)),
    *(Proof("run_maximal", "the first maximal interval of stops from a voxel on", "rc2_run", "all inputs",
            Fault("lanes/rc2_run.sv", "assign above = stops_i & ({N{1'b1}} << from_i);", "assign above = stops_i;"),
            macros=size, fast=size == USUAL) for size in (USUAL, LARGE)),
    *(Proof("extents_hull", "a sector's tilts are the hull of its column's and of the neighbours' away from the light",
            "rc2_extents", "induction",
            Fault("lanes/rc2_extents.sv", "(corner_low < third_low) ? corner_low : third_low", "corner_low"),
            6, macros=size, fast=size == USUAL) for size in (USUAL, LARGE)),
    # Splitter
    Proof("ymed_formula", "Y_med equals a real division, rounded down and up, for every k, w, L", "rc2_ymed",
          "all inputs",
          Fault("light/rc2_ymed.sv", "scaled[FracW-1:ProdW] == 0", "scaled[FracW-1:0] == 0"), macros=USUAL),
    Proof("split_axis_parts", "each target is in exactly one part, that of Y_med", "rc2_split_axis", "all inputs",
          Fault("light/rc2_split_axis.sv", "(min_i > up) ? min_i : up + 1'b1", "(min_i > up) ? min_i : up"),
          macros=LARGE),
    Proof("extent_counts", "the numbers of targets served and kept", "rc2_extent", "all inputs",
          Fault("light/rc2_extent.sv", "ExtentW'(max_i) - ExtentW'(high_min_i) + 1'b1",
                "ExtentW'(max_i) - ExtentW'(high_min_i)"),
          macros=LARGE),
    Proof("splitter_rays", "a target goes to the next voxel of its digital ray, in exactly one child, or leaves the cube",
          "rc2_splitter", "all inputs", Fault("light/rc2_splitter.sv", "along_z ? !negative : v_served[2]",
                                              "along_z ? !negative : v_served[1]"),
          macros=SMALL, fast=False),
    *(Proof("border_formula", "the border between two voxels, in targets, equals a real division, for every k, w, L",
            "rc2_ratio, rc2_border", "bounded", Fault("lanes/rc2_border.sv", "~quotient + BorderW'(exact)", "~quotient"), 2,
            macros=size, fast=size == SMALL) for size in (SMALL, USUAL)),
    *(Proof("place_ray", "a target's voxel is that of its digital ray, for every k and L", "rc2_place", "all inputs",
            Fault("lanes/rc2_place.sv", "negative ? Half : Half - 1'b1", "Half"), macros=size, fast=size == SMALL)
      for size in (SMALL, USUAL)),
    Proof("stops_answer", "of a beam's targets just those that the table calls free are at free voxels", "rc2_stops",
          "bounded", Fault("lanes/rc2_stops.sv", "(run_min_q[i] <= from)", "(run_min_q[i] < from)"), 13,
          macros=(("N", 4), ("LMAX", 4)), abc=True, fast=False),
    # Loading
    Proof("dexel_interval", "the dexel is what every word allows, the core likewise, for any packets and stalls",
          "rc2_dexel", "induction", Fault("load/rc2_dexel.sv", "fits_a ? bit_q", "fits_b ? bit_q"), 2,
          macros=(("N", 4), ("F", 0)), fast=False),
    # The end of a light
    *(Proof("tally_counts", "what has left a cell is what came home to it and ended in it", "rc2_tally", "induction",
            Fault("light/rc2_tally.sv", "served_q ? area_o - kept : '0", "served_i ? area_o - kept : '0"), 2,
            macros=(("N", 2), ("LMAX", far)), fast=far == 1) for far in (1, 2)),
    Proof("arrivals_sum", "a voxel's count is the sum of its arrivals since the start", "rc2_arrivals", "induction",
          Fault("light/rc2_arrivals.sv", "bypass_q ? bypass_count_q : count_read", "count_read"), 2, macros=SMALL),
    Proof("pace_steps", "the light goes on until the farthest face or until no cell has any; layers by step", "rc2_pace",
          "induction", Fault("lanes/rc2_pace.sv", "idle_i && (step_q != 0)", "idle_i"), 2, macros=USUAL),
    # Rays
    *(Proof("ray_queue_order", "same rays, same order as a queue that shifts; the oldest is what it was probed to",
            "rc2_ray_queue", "induction",
            Fault("rays/rc2_ray_queue.sv", "if (pop_i) probed_q <= 1'b0;", "if (pop_i) probed_q <= probed_q;"), 2,
            params=(("Depth", depth),), macros=RAYS)
      for depth in (1, 2, 3, 4)),
    Proof("ray_way_nearer", "one way or there, each step nearer by a cell, x first", "rc2_ray_way", "all inputs",
          Fault("rays/rc2_ray_way.sv", "assign way_o[2] = valid_i && same_x", "assign way_o[2] = valid_i"), macros=USUAL),
    *(Proof("divide_exact", "the quotient and whether there is a rest, or all ones", "rc2_divide", "bounded",
            Fault("parts/rc2_divide.sv", "down[BitsW-2:0], !less[DivW]", "down[BitsW-2:0], less[DivW]"), 9,
            params=(("NumW", 8), ("DivW", 4), ("QuotW", bits), ("Step", step)))
      for bits, step in ((6, 1), (5, 2))),
    *(Proof("root_exact", "the root, rounded down", "rc2_root", "bounded",
            Fault("parts/rc2_root.sv", "{root, 2'b01}", "{root, 2'b10}"), 9, params=(("RootW", bits), ("Step", step)))
      for bits, step in ((6, 1), (5, 2))),
    *(Proof("ray_run_voxels", "the voxels from where a ray came in to where it leaves, the next one first",
            "rc2_ray_run", "all inputs",
            Fault("rays/rc2_ray_run.sv", "(far < $signed(FloorW'(from)))", "(far > $signed(FloorW'(from)))"), macros=size,
            fast=size == RAYS) for size in (RAYS, (("N", 16),), (("N", 128),))),
    Proof("ray_net_keeps", "of any message as many are there as came and did not go; it goes its way, x first, where is room",
          "rc2_ray_net", "induction",
          Fault("rays/rc2_ray_net.sv", "assign start_taken[w] = sent[Starts+w] || begins[w];",
                "assign start_taken[w] = sent[Starts+w];"), 2, reach=6,
          macros=RAYS, stubs=("ray_cell",), bits=True, fast=False),
    Proof("ray_net_moves", "while there are rays one moves, whatever engines and homes do", "rc2_ray_net", "induction",
          Fault("rays/rc2_ray_net.sv", "(starts != 0) ? starts : able;", "(starts != 0) ? starts : starts;"), 2, reach=8,
          params=(("Side", 2),), macros=RAYS, stubs=("ray_cell",), bits=True, fast=False),
    # The whole array
    Proof("thesis_light_ends", "no target is lost, the light ends, all targets are home then and not before",
          "rc2_grid_thesis", "bounded", Fault("light/rc2_diffuser.sv", "assign own_push = go && own;",
                                              "assign own_push = go && own && (count != 1);"),
          41, params=(("Cycles", 40),), macros=(("N", 2), ("LMAX", 2), ("FAMAX", 1), ("THESIS", 1)),
          stubs=("any_voxels",), abc=True, fast=False),
    Proof("lanes_light_ends", "the light ends, nothing moves afterwards, every voxel where a target's ray ends is lit",
          "rc2_grid", "bounded", Fault("lanes/rc2_side_lane.sv", "assign go = !passes || ((wanted & ~room_i) == 0);",
                                       "assign go = !passes || ((wanted & ~room_i) != wanted);"),
          41, params=(("Cycles", 40),), macros=(("N", 2), ("LMAX", 2), ("FAMAX", 1), ("COUNTS", 0), ("SKIPS", 0)),
          stubs=("any_voxels",), abc=True, fast=False),
]
