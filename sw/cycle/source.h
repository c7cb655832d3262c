// The light's six first beams (rtl/light/rc2_source.sv).
#pragma once

#include "sw/cycle/beam.h"
#include "sw/machine/machine.h"

namespace rc2::cycle {

class Source {
 public:
  void start(const LightJob& light) {
    light_ = light;
    dir_ = 0;
  }

  bool active() const { return dir_ < kDirs; }

  /// The next beam. A target on an edge shared by two faces belongs to one of them: x faces keep
  /// all their edges, y faces those with z, z faces none.
  Beam take() {
    Beam beam{{}, {}, static_cast<std::uint16_t>(light_.source.z), dir_++};
    const int full = light_.target_distance, inner = full - 1;
    const int u_max = beam.along_x() ? full : inner;
    const int v_max = beam.along_z() ? inner : full;
    beam.u = range(-u_max, u_max);
    beam.v = range(-v_max, v_max);
    return beam;
  }

 private:
  static constexpr std::uint8_t kDirs = 6;

  LightJob light_{};
  std::uint8_t dir_ = kDirs;
};

}  // namespace rc2::cycle
