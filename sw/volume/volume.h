#pragma once

#include <string>

#include "sw/machine/machine.h"

namespace rc2::volume {

/// Writes what a machine holds as an OpenVDB file, which Blender, Houdini and ParaView open: grid
/// `density`, 1 in occupied voxels; `facet`, the owner's number (integers, -1 elsewhere); `light0`,
/// `light1`, ..., the targets that arrived. Index and world coordinates are the machine's voxels.
/// Throws Error, and leaves no new file, if the path cannot be written.
void write_vdb(const std::string& path, const VoxelMemory& voxels,
               const std::vector<LightMemory>& lights);

}  // namespace rc2::volume
