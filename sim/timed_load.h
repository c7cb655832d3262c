// How long the host takes from a scene to voxels, beside a voxeliser that does nothing else.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <functional>
#include <limits>
#include <string>

#include "sw/scene/scene.h"

namespace rc2 {

/// Processor time of the fastest of several runs: what else runs on this computer is not to blame.
class Best {
 public:
  /// Runs the step; returns what it returns.
  template <typename Step>
  auto time(Step step) {
    const std::clock_t start = std::clock();
    auto result = step();
    clocks_ = std::min(clocks_, std::clock() - start);
    return result;
  }

  double seconds() const { return static_cast<double>(clocks_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t clocks_ = std::numeric_limits<std::clock_t>::max();
};

struct TimedLoad {
  std::string scene;
  std::size_t polygons = 0, triangles = 0, facets = 0;
  std::int64_t filled = 0;  ///< voxels, those of several facets counted for each
  Best import;              ///< file -> polygons
  Best packets, load;       ///< polygons -> packets -> voxels of the golden machine
  Best list;                ///< read_voxels()
  Best direct;              ///< triangles -> voxels of direct::Voxeliser
  bool agrees = true;       ///< whether both made the same voxels, of a scene of triangles

  double golden_seconds() const { return packets.seconds() + load.seconds(); }
};

/// Loads what `make` returns, in voxel coordinates, `repeats` times into an n-cube, vertices
/// rounded to sixteenths of a voxel, armoured rule.
TimedLoad time_load(const std::string& name, int n, int repeats,
                    const std::function<scene::Scene()>& make);

}  // namespace rc2
