// What one cell does to a beam, target by target: an oracle that knows neither queues nor splits.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <vector>

#include "sw/machine/machine.h"
#include "tb/systemc/cell_unit.h"

namespace rc2::tb {

struct CellLight {
  /// A beam that the cell must send, over a link.
  struct Sent {
    std::size_t link;
    LinkBeam beam;
  };
  std::vector<Sent> sent;
  /// Targets that end their way here, absorbed or out of the cube, each time that any do.
  std::vector<std::int64_t> home;
  std::map<int, std::int64_t> absorbed;  ///< by z, where there are any
  std::int64_t visits = 0;
};

class LightReference {
 public:
  /// `occupied`: the voxels of the cell's column.
  LightReference(glm::ivec2 cell, std::vector<bool> occupied, const LightJob& light);

  /// The light itself, if it stands in this column.
  void start(CellLight& result) const;

  /// A beam that has come, and those that stay in the cell after it.
  void serve(const LinkBeam& beam, CellLight& result) const;

  /// The targets of a whole face whose rays pass through this voxel of the column; no beam if there
  /// are none.
  LinkBeam passing(int dir, int z) const;
  static bool is_empty(const LinkBeam& beam) {
    return beam.u_min > beam.u_max || beam.v_min > beam.v_max;
  }

 private:
  // Steps from the source to the voxel, and its offsets along U and V.
  struct Place {
    int step, u, v;
  };
  Place place(int dir, int z) const;
  int offset(int target, int step) const;
  LinkBeam face(int dir) const;

  glm::ivec2 cell_;
  std::vector<bool> occupied_;
  LightJob light_;
};

}  // namespace rc2::tb
