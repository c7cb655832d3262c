// SPDX-License-Identifier: Apache-2.0
//
// Refuses a build that no machine can come of, with one sentence for each macro of rc2_pkg that is out
// of range. In the machine and in both cells; it has no ports, and nothing of it is left in gates.

module rc2_limits;
  if (!rc2_pkg::FitsN) begin : g_n
    $error("RC2_N, cells per side, must be from 2 to 1024");
  end
  if (!rc2_pkg::FitsF) begin : g_f
    $error("RC2_F, fraction bits of a vertex, must be from 0 to 8");
  end
  if (!rc2_pkg::FitsLmax) begin : g_lmax
    $error("RC2_LMAX, largest distance of the virtual faces, must be from 2 to 4096");
  end
  if (!rc2_pkg::FitsFamax) begin : g_famax
    $error("RC2_FAMAX, places in a cell's beam queue, must be from 1 to 4093");
  end
  if (!rc2_pkg::FitsFeeders) begin : g_feeders
    $error("RC2_FEEDERS, words per cycle from the host, must be a power of two, at most RC2_N");
  end
  if (!rc2_pkg::FitsLayers) begin : g_layers
    $error("RC2_LAYERS, columns with layers, must be 0 or 1");
  end
  if (!rc2_pkg::FitsThesis) begin : g_thesis
    $error("RC2_THESIS, light as in the thesis, must be 0 or 1");
  end
  if (!rc2_pkg::FitsCounts) begin : g_counts
    $error("RC2_COUNTS, columns that count targets, must be 0 or 1");
  end
  if (!rc2_pkg::FitsSkips) begin : g_skips
    $error("RC2_SKIPS, light that can meet nothing ends early, must be 0 or 1");
  end
  if (!rc2_pkg::FitsRays) begin : g_rays
    $error("RC2_RAYS, cells that trace rays, must be 0, or 1 with RC2_LAYERS, without RC2_THESIS and with RC2_N from 3");
  end
  if (!rc2_pkg::FitsRayDepth) begin : g_ray_depth
    $error("RC2_RAYDEPTH, most bounces of a ray, must be from 1 to 7");
  end
  if (!rc2_pkg::FitsRayQ) begin : g_ray_queue
    $error("RC2_RAYQ, places of each queue of rays, must be from 1 to 255");
  end
endmodule
