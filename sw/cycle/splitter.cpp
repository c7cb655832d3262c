#include "sw/cycle/splitter.h"

#include "sw/cycle/bits.h"

namespace rc2::cycle {
namespace {

constexpr unsigned kNone = 0, kAll = 7;

// The parts that a voxel at `at` of 0..n-1 can send on without leaving the cube.
unsigned inside(int at, int n) {
  return kAll & ~(at == 0 ? 1U << kLow : 0U) & ~(at == n - 1 ? 1U << kHigh : 0U);
}

// The number of targets in some of the parts.
std::int64_t extent(const Parts& parts, unsigned some) {
  std::int64_t sum = 0;
  for (; some != 0; some = without_first(some)) sum += parts.part[first_of(some)].extent();
  return sum;
}

// The neighbours reached by a set of parts along x and one along y: entry to_y * 8 + to_x.
constexpr auto kLinksTo = [] {
  std::array<std::uint8_t, 64> table{};
  for (unsigned to_y = 0; to_y <= kAll; ++to_y) {
    for (unsigned to_x = 0; to_x <= kAll; ++to_x) {
      unsigned links = 0;
      for (unsigned link = 0; link < kLinks; ++link) {
        links |= (to_x >> kPlaceX[link] & to_y >> kPlaceY[link] & 1U) << link;
      }
      table[to_y * 8 + to_x] = static_cast<std::uint8_t>(links);
    }
  }
  return table;
}();

}  // namespace

Split split(const Beam& beam, int x, int y, int n, const LightJob& light) {
  const int dx = x - light.source.x, dy = y - light.source.y, dz = beam.z - light.source.z;
  const int step = std::abs(beam.along_x() ? dx : beam.along_y() ? dy : dz) + 1;
  const int u_at = beam.along_x() ? y : x;
  const int v_at = beam.along_z() ? y : beam.z;

  Split s{};
  s.parent = beam;
  s.u = split_axis(beam.u, beam.along_x() ? dy : dx, step, light.target_distance);
  s.v = split_axis(beam.v, beam.along_z() ? dy : dz, step, light.target_distance);
  s.v_served = beam.along_z() ? s.v.present : 1U << first_of(s.v.present);
  s.more = s.v_served != s.v.present;

  const int ahead = beam.along_x() ? x : beam.along_y() ? y : beam.z;
  const bool leaves = ahead == (beam.negative() ? 0 : n - 1);
  const unsigned u_kept = leaves ? kNone : s.u.present & inside(u_at, n);
  const unsigned v_kept = leaves ? kNone : s.v_served & inside(v_at, n);
  s.served = extent(s.u, s.u.present) * extent(s.v, s.v_served);
  s.kept = extent(s.u, u_kept) * extent(s.v, v_kept);

  const unsigned forward = 1U << (beam.negative() ? kLow : kHigh);
  if (v_kept != kNone) {
    const unsigned to_x = beam.along_x() ? forward : u_kept;
    const unsigned to_y = beam.along_x() ? u_kept : beam.along_y() ? forward : v_kept;
    s.send = kLinksTo[to_y * 8 + to_x];
  }
  s.own = beam.along_z() && (u_kept & v_kept & 1U << kMiddle) != 0;

  const unsigned z_move = beam.along_z() ? forward : s.v_served;
  s.z = static_cast<std::uint16_t>(beam.z + (z_move == 1U << kHigh ? 1 : 0) -
                                   (z_move == 1U << kLow ? 1 : 0));
  return s;
}

Beam Split::child(unsigned link) const {
  const Place along_u = parent.along_x() ? kPlaceY[link] : kPlaceX[link];
  const unsigned along_v = parent.along_z() ? kPlaceY[link] : first_of(v_served);
  return {u.part[along_u], v.part[along_v], z, parent.dir};
}

Beam Split::remainder() const {
  Beam rest = parent;
  rest.v.min = static_cast<std::int16_t>(v.part[first_of(v_served)].max + 1);
  return rest;
}

}  // namespace rc2::cycle
