// Where an accurate light ends its rays, from the definition alone.
#pragma once

#include <boost/rational.hpp>
#include <map>
#include <tuple>

#include "sw/machine/machine.h"

namespace rc2::stress {

/// The accurate rule as docs/light.md words it, voxel by voxel, in fractions of a voxel.
class StopOracle {
 public:
  /// `packets` are all that was loaded: they tell which way facets face, and who claims a guard.
  StopOracle(int n, const VoxelMemory& voxels, const LayerMemory& layers,
             const facet::PacketStream& packets);

  bool is_armoured(const glm::ivec3& at) const { return owners_.count(key(at)) > 0; }
  bool stops(const glm::ivec3& at, const glm::ivec3& light) const;

 private:
  using Rational = boost::rational<std::int64_t>;
  using Key = std::tuple<int, int, int>;
  // Depth behind the plane as the light sees it, negative before it, in whole sixteenths rounded
  // towards the plane; how much deeper a step leads, likewise.
  struct View {
    facet::Surface surface;
    bool turned_away;
    Rational depth, step;
  };

  static Key key(const glm::ivec3& at) { return {at.x, at.y, at.z}; }
  Rational part(std::int64_t rise) const;
  View look(const glm::ivec3& at, const Claim& owner, const glm::ivec3& light) const;
  void claim(const facet::PacketStream& packets, const facet::PacketHead& head);

  int n_;
  std::map<Key, Claim> owners_, guards_;
  std::map<Key, bool> inside_;
  std::map<std::uint32_t, facet::PacketHead> heads_;
};

}  // namespace rc2::stress
