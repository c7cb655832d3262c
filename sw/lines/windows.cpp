#include "sw/lines/windows.h"

#include <algorithm>
#include <bitset>

#include "sw/lines/separation.h"

namespace rc2::lines {
namespace {

Adjacency thesis_connectivity(const WindowSet& set) {
  Adjacency weakest = Adjacency::face;
  const auto has = [&](glm::ivec3 at) { return set.has(at); };
  for (int z = 0; z < set.size.z; ++z)
    for (int y = 0; y < set.size.y; ++y)
      for (int x = 0; x < set.size.x; ++x)
        if (set.has({x, y, z}))
          weakest = std::max(weakest, local_connectivity(neighbourhood({x, y, z}, has)));
  return weakest;
}

void meet(Encounter<WindowSet>& encounter, const WindowSet& set, bool leaks) {
  ++encounter.surfaces;
  encounter.leaking += static_cast<std::int64_t>(leaks);
  if (leaks && (!encounter.smallest || set.count() < encounter.smallest->count()))
    encounter.smallest = set;
}

}  // namespace

bool WindowSet::has(glm::ivec3 at) const {
  if (at.x < 0 || at.x >= size.x || at.y < 0 || at.y >= size.y || at.z < 0 || at.z >= size.z)
    return false;
  return ((bits >> ((at.z * size.y + at.y) * size.x + at.x)) & 1U) != 0;
}

int WindowSet::count() const { return static_cast<int>(std::bitset<32>(bits).count()); }

TunnelTable<WindowSet> search_window(glm::ivec3 size) {
  TunnelTable<WindowSet> table;
  const std::uint32_t sets = std::uint32_t{1} << (size.x * size.y * size.z);
  for (WindowSet set{size, 0}; set.bits < sets; ++set.bits) {
    const auto is_free = [&](glm::ivec3 at) { return !set.has(at); };
    const auto leaks = [&](Adjacency rays) { return !find_ray(size, rays, is_free).empty(); };
    if (leaks(Adjacency::face)) continue;
    const std::size_t kind = index_of(thesis_connectivity(set));
    meet(table[0][kind], set, false);
    meet(table[1][kind], set, leaks(Adjacency::edge));
    meet(table[2][kind], set, leaks(Adjacency::corner));
  }
  return table;
}

}  // namespace rc2::lines
