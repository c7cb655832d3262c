#include "tb/stress/stop_oracle.h"

#include <array>

namespace rc2::stress {
namespace {

using Rational = boost::rational<std::int64_t>;

std::int64_t nearest_ties_down(const Rational& r) {
  const Rational doubled = 2 * r - 1;  // the least integer not below r - 1/2
  std::int64_t floor = doubled.numerator() / (2 * doubled.denominator());
  while (Rational(floor) < r - Rational(1, 2)) ++floor;
  while (Rational(floor - 1) >= r - Rational(1, 2)) --floor;
  return floor;
}

Rational size(const Rational& r) { return r < 0 ? -r : r; }

}  // namespace

StopOracle::StopOracle(int n, const VoxelMemory& voxels, const LayerMemory& layers,
                       const facet::PacketStream& packets)
    : n_(n) {
  for (const VoxelRecord& voxel : voxels) owners_[key(voxel.at)] = voxel.owner;
  for (const LayerRecord& layer : layers) inside_[key(layer.at)] = layer.inside;
  for (const facet::PacketHead& head : packets.heads) {
    // Packets of the other layers do not bring the facet's plane.
    if (head.layer == facet::Layer::armour || head.layer == facet::Layer::guard)
      heads_[head.facet] = head;
    if (head.layer == facet::Layer::guard) claim(packets, head);
  }
}

bool StopOracle::stops(const glm::ivec3& at, const glm::ivec3& light) const {
  const auto owner = owners_.find(key(at));
  if (owner != owners_.end()) {
    const View view = look(at, owner->second, light);
    if (view.surface == facet::Surface::crowd) return true;
    if (view.surface == facet::Surface::solid) return view.turned_away;
    return view.depth >= Rational(1, 2);
  }
  const auto inside = inside_.find(key(at));
  if (inside != inside_.end() && inside->second) return true;
  const auto guard = guards_.find(key(at));
  if (guard == guards_.end()) return false;
  const View view = look(at, guard->second, light);
  const Rational first = view.surface == facet::Surface::sheet ? Rational(1, 2) : Rational(0);
  return view.depth >= first && view.depth <= first + view.step + Rational(1, 16);
}

StopOracle::Rational StopOracle::part(std::int64_t rise) const {
  // A tie goes up.
  const std::int64_t parts = nearest_ties_down(Rational(rise, 4) + Rational(1, 1000));
  return {parts, std::int64_t{1} << normal_fraction_bits(n_)};
}

StopOracle::View StopOracle::look(const glm::ivec3& at, const Claim& owner,
                                  const glm::ivec3& light) const {
  const facet::PacketHead& head = heads_.at(owner.facet);
  const std::array normal{part(head.gap.a), part(head.gap.b), part(head.gap.c)};
  // The gap is known to a sixteenth: it is taken in its middle, and an eighth for doubt.
  Rational height = Rational(2 * owner.gap + 1, 32) + Rational(1, 8);
  for (int axis = 0; axis < 3; ++axis)
    height += normal[static_cast<std::size_t>(axis)] * Rational(light[axis] - at[axis]);
  View view{head.surface, height < 0, {}, {}};
  const int depth = owner.gap < 0 ? -1 - owner.gap : owner.gap;
  view.depth = (owner.gap < 0) == view.turned_away ? Rational(-1) : Rational(depth, 16);
  for (int axis = 0; axis < 3; ++axis) {
    const Rational& rise = normal[static_cast<std::size_t>(axis)];
    const Rational deeper = rise * Rational(at[axis] - light[axis]);
    if (view.turned_away ? deeper > 0 : deeper < 0) view.step += size(rise);
  }
  view.step = Rational((16 * view.step).numerator() / (16 * view.step).denominator(), 16);
  return view;
}

void StopOracle::claim(const facet::PacketStream& packets, const facet::PacketHead& head) {
  for (glm::ivec3 at = head.lo; at.z <= head.hi.z; ++at.z) {
    for (at.y = head.lo.y; at.y <= head.hi.y; ++at.y) {
      for (at.x = head.lo.x; at.x <= head.hi.x; ++at.x) {
        const glm::ivec3 p = at - head.lo;
        const auto value = [&](const facet::Linear& of) {
          return of.a * p.x + of.b * p.y + of.c * p.z + of.d;
        };
        bool fills = value(head.slab.value) >= 0 && value(head.slab.value) <= head.slab.width;
        bool core = true;
        for (std::uint32_t i = 0; i < head.side_count; ++i) {
          const facet::Side& side = packets.sides[head.first_side + i];
          fills = fills && value(side.value) >= 0;
          core = core && value(side.value) >= side.push;
        }
        if (!fills) continue;
        const Claim claim{head.facet, core, gap_of(n_, value(head.gap))};
        const auto [best, first] = guards_.try_emplace(key(at), claim);
        if (!first && claim.packed() < best->second.packed()) best->second = claim;
      }
    }
  }
}

}  // namespace rc2::stress
