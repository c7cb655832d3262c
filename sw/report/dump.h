// The two memories of a machine as a CSV file that any tool reads.
#pragma once

#include <string>
#include <vector>

#include "sw/machine/machine.h"

namespace rc2::report {

/// Occupied voxels, and for each light the targets that arrived there (same order, same size).
struct Memories {
  VoxelMemory voxels;
  std::vector<LightMemory> lights;
};

/// One row per occupied voxel under the header x,y,z,facet,core,gap,light0,light1,...; rows in the
/// order of VoxelMemory, lines end with a line feed.
std::string to_csv(const Memories& memories);

/// Reads what to_csv wrote. Throws Error (file, line, what, mend) on anything else: a missing file,
/// another header, a row of other length, a word that is not a number in its range, rows that are
/// not in order.
Memories read_csv(const std::string& path);

}  // namespace rc2::report
