// Connectivity, separation, and the tables of figures 2.9 and 2.11.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>

#include "sw/lines/connectivity.h"
#include "sw/lines/planes.h"
#include "sw/lines/separation.h"
#include "sw/lines/windows.h"

namespace rc2::lines {
namespace {

constexpr Adjacency kFace = Adjacency::face, kEdge = Adjacency::edge, kCorner = Adjacency::corner;

// Whether two different voxels are neighbours, straight from the definition.
bool are_neighbours(glm::ivec3 a, glm::ivec3 b, Adjacency adjacency) {
  const int x = std::abs(a.x - b.x), y = std::abs(a.y - b.y), z = std::abs(a.z - b.z);
  return std::max({x, y, z}) == 1 && x + y + z <= static_cast<int>(index_of(adjacency)) + 1;
}

// Whether steps inside `set` lead from a to b: joins pieces until nothing changes.
bool is_linked(const VoxelSet& set, glm::ivec3 a, glm::ivec3 b, Adjacency adjacency) {
  std::map<glm::ivec3, int, VoxelOrder> piece;
  for (const glm::ivec3& at : set) piece.emplace(at, static_cast<int>(piece.size()));
  for (bool changed = true; changed;) {
    changed = false;
    for (auto& [p, of_p] : piece)
      for (auto& [q, of_q] : piece)
        if (of_p < of_q && are_neighbours(p, q, adjacency)) of_q = of_p, changed = true;
  }
  return piece.at(a) == piece.at(b);
}

// The thesis's definition (2.1), word by word, for the pairs that one voxel belongs to.
bool has_connectivity(const VoxelSet& set, glm::ivec3 a, Adjacency adjacency) {
  for (const glm::ivec3& b : set) {
    if (!are_neighbours(a, b, kCorner)) continue;
    VoxelSet of_both = {a, b};
    for (const glm::ivec3& c : set)
      if (are_neighbours(a, c, kCorner) && are_neighbours(b, c, kCorner)) of_both.insert(c);
    if (!is_linked(of_both, a, b, adjacency)) return false;
  }
  return true;
}

bool has_connectivity(const VoxelSet& set, Adjacency adjacency) {
  return std::all_of(set.begin(), set.end(),
                     [&](const glm::ivec3& at) { return has_connectivity(set, at, adjacency); });
}

VoxelSet voxels_of(const WindowSet& window) {
  VoxelSet set;
  for (int z = 0; z < window.size.z; ++z)
    for (int y = 0; y < window.size.y; ++y)
      for (int x = 0; x < window.size.x; ++x)
        if (window.has({x, y, z})) set.insert({x, y, z});
  return set;
}

VoxelSet random_set(std::mt19937& random) {
  VoxelSet set;
  const unsigned share = 2 + random() % 8;
  for (int i = 0; i < 27; ++i)
    if (random() % 10 < share) set.insert({i % 3, i / 3 % 3, i / 9});
  return set;
}

// A ray through the free voxels, found by joining them, the top and the bottom.
bool joins_top_and_bottom(const VoxelSet& walls, glm::ivec3 size, Adjacency adjacency) {
  VoxelSet free;
  for (int i = 0; i < size.x * size.y * size.z; ++i) {
    const glm::ivec3 at(i % size.x, i / size.x % size.y, i / size.x / size.y);
    if (walls.count(at) == 0) free.insert(at);
  }
  for (const glm::ivec3& a : free)
    for (const glm::ivec3& b : free)
      if (a.z == size.z - 1 && b.z == 0 && is_linked(free, a, b, adjacency)) return true;
  return false;
}

TEST(Neighbourhood, StepsGoThroughFacesThenEdgesThenCorners) {
  const VoxelSet different(kSteps.begin(), kSteps.end());
  EXPECT_EQ(different.size(), 26U);
  for (const Adjacency adjacency : kAdjacencies)
    for (std::size_t i = 0; i < kSteps.size(); ++i)
      EXPECT_EQ(are_neighbours({0, 0, 0}, kSteps[i], adjacency),
                i < static_cast<std::size_t>(adjacency));
}

TEST(Neighbourhood, ConnectivityIsTheDefinitionOnRandomSets) {
  std::mt19937 random(21);
  std::map<Adjacency, int> seen;
  constexpr glm::ivec3 kCentre(1, 1, 1);
  for (int i = 0; i < 2000; ++i) {
    const VoxelSet set = random_set(random);
    const auto has = [&](glm::ivec3 at) { return at == kCentre || set.count(at) != 0; };
    const Adjacency local = local_connectivity(neighbourhood(kCentre, has));
    ++seen[local];
    for (const Adjacency adjacency : kAdjacencies)
      ASSERT_EQ(has_connectivity(set, kCentre, adjacency), local <= adjacency);
  }
  EXPECT_EQ(seen.size(), 3U);
}

TEST(Connectivity, IsTheDefinitionOnRandomSets) {
  std::mt19937 random(29);
  std::map<Adjacency, int> seen, seen_locally;
  for (int i = 0; i < 300; ++i) {
    const VoxelSet set = random_set(random);
    const Adjacency local = local_connectivity(set);
    ++seen_locally[local];
    for (const Adjacency adjacency : kAdjacencies)
      ASSERT_EQ(has_connectivity(set, adjacency), local <= adjacency);
    const auto whole = connectivity(set);
    if (whole) ++seen[*whole];
    for (const Adjacency adjacency : kAdjacencies) {
      bool linked = !set.empty();
      for (const glm::ivec3& at : set)
        linked = linked && is_linked(set, *set.begin(), at, adjacency);
      ASSERT_EQ(linked, whole && *whole <= adjacency);
    }
  }
  EXPECT_EQ(seen.size(), 3U) << "the sets must be of every kind for the test to mean anything";
  EXPECT_EQ(seen_locally.size(), 3U);
}

TEST(Connectivity, OfNothingIsNone) { EXPECT_FALSE(connectivity({}).has_value()); }

TEST(Separation, FindsARayWhereThereIsOne) {
  std::mt19937 random(211);
  int found = 0, none = 0;
  for (int i = 0; i < 200; ++i) {
    const VoxelSet walls = random_set(random);
    const auto is_free = [&](glm::ivec3 at) { return walls.count(at) == 0; };
    for (const Adjacency rays : kAdjacencies) {
      const auto ray = find_ray({3, 3, 3}, rays, is_free);
      ASSERT_EQ(!ray.empty(), joins_top_and_bottom(walls, {3, 3, 3}, rays));
      ++(ray.empty() ? none : found);
      if (ray.empty()) continue;
      EXPECT_EQ(ray.front().z, 2);
      EXPECT_EQ(ray.back().z, 0);
      for (std::size_t k = 0; k < ray.size(); ++k) {
        EXPECT_TRUE(is_free(ray[k]));
        EXPECT_TRUE(k == 0 || are_neighbours(ray[k - 1], ray[k], rays));
      }
    }
  }
  EXPECT_GT(found, 20);
  EXPECT_GT(none, 20);
}

template <class Surface>
bool leaks(const TunnelTable<Surface>& table, Adjacency rays, Adjacency kind) {
  const Encounter<Surface>& met = table[index_of(rays)][index_of(kind)];
  EXPECT_GT(met.surfaces, 0) << "nothing was tried";
  EXPECT_EQ(met.leaking > 0, met.smallest.has_value());
  return met.leaking > 0;
}

// In a plane, faces and edges are the connectivities 4 and 8.
TEST(Tunnels, Figure29) {
  const TunnelTable<WindowSet> table = search_window({4, 1, 4});
  EXPECT_FALSE(leaks(table, kFace, kFace));
  EXPECT_FALSE(leaks(table, kFace, kEdge));
  EXPECT_FALSE(leaks(table, kEdge, kFace));
  EXPECT_TRUE(leaks(table, kEdge, kEdge));
}

// What stops 4-connected rays in a plane is a chain of pixels from side to side, whose links may be
// diagonal, and nothing else; so a search by stopped rays finds the thesis's curves.
TEST(Tunnels, SurfacesOfThePlaneAreChainsFromSideToSide) {
  constexpr int kSide = 4;
  for (WindowSet set{{kSide, 1, kSide}, 0}; set.bits < 1U << (kSide * kSide); ++set.bits) {
    const auto is_free = [&](glm::ivec3 at) { return !set.has(at); };
    const auto turned = [&](glm::ivec3 at) { return set.has({at.z, 0, at.x}); };
    for (const Adjacency rays : {kFace, kEdge}) {
      const Adjacency chain = rays == kFace ? kEdge : kFace;
      ASSERT_NE(find_ray(set.size, rays, is_free).empty(),
                find_ray(set.size, chain, turned).empty());
    }
  }
}

// The printed table says NON where a 6-connected surface meets 18- and 26-connected rays.
TEST(Tunnels, Figure211IsWrong) {
  const TunnelTable<WindowSet> table = search_window({2, 2, 3});
  for (const Adjacency kind : kAdjacencies) {
    EXPECT_FALSE(leaks(table, kFace, kind));
    EXPECT_TRUE(leaks(table, kEdge, kind));
    EXPECT_TRUE(leaks(table, kCorner, kind));
  }
}

TEST(Tunnels, SmallestCounterExampleHasFiveVoxels) {
  for (const glm::ivec3 size : {glm::ivec3(2, 2, 2), glm::ivec3(2, 2, 3), glm::ivec3(3, 2, 2)}) {
    const TunnelTable<WindowSet> table = search_window(size);
    for (const Adjacency rays : {kEdge, kCorner}) {
      const auto& smallest = table[index_of(rays)][index_of(kFace)].smallest;
      ASSERT_TRUE(smallest.has_value());
      EXPECT_EQ(smallest->count(), size.x == 2 ? 5 : 7);
      const VoxelSet set = voxels_of(*smallest);
      EXPECT_TRUE(has_connectivity(set, kFace));
      EXPECT_EQ(connectivity(set), kFace);
      EXPECT_FALSE(joins_top_and_bottom(set, size, kFace));
      EXPECT_TRUE(joins_top_and_bottom(set, size, rays));
    }
  }
}

// Voxels of the plane in a cube around one of them, to look at without the plane's own arithmetic.
VoxelSet cut(const DigitalPlane& plane, int reach) {
  VoxelSet set;
  for (int z = -reach; z <= reach; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const int value = plane.normal.x * x + plane.normal.y * y + plane.normal.z * z;
        if (value >= 0 && value < plane.thickness) set.insert({x, y, z});
      }
    }
  }
  return set;
}

TEST(Tunnels, PlanesAreTheirVoxels) {
  constexpr int kReach = 6;
  for (const DigitalPlane plane :
       {DigitalPlane{{1, 1, 1}, 2}, DigitalPlane{{2, 2, 1}, 3}, DigitalPlane{{3, 2, 1}, 5},
        DigitalPlane{{3, 2, 1}, 6}, DigitalPlane{{3, -2, 1}, 4}, DigitalPlane{{1, 0, 0}, 1}}) {
    const VoxelSet set = cut(plane, kReach);
    const auto has = [&](glm::ivec3 at) { return set.count(at) != 0; };
    Adjacency weakest = kFace;
    std::array<bool, 3> passed = {};
    for (int i = 0; i < 11 * 11 * 11; ++i) {
      const glm::ivec3 at(i % 11 - 5, i / 11 % 11 - 5, i / 121 - 5);
      if (has(at)) {
        weakest = std::max(weakest, local_connectivity(neighbourhood(at, has)));
        continue;
      }
      const auto is_below = [&](glm::ivec3 p) {
        return plane.normal.x * p.x + plane.normal.y * p.y + plane.normal.z * p.z < 0;
      };
      for (const glm::ivec3& step : kSteps)
        if (!has(at + step) && is_below(at) != is_below(at + step))
          for (std::size_t rays = 0; rays < 3; ++rays)
            passed[rays] |= are_neighbours({0, 0, 0}, step, kAdjacencies[rays]);
    }
    EXPECT_EQ(local_connectivity(plane), weakest);
    for (const Adjacency rays : kAdjacencies)
      EXPECT_EQ(is_passed(plane, rays), passed[index_of(rays)]);
  }
}

TEST(Tunnels, PlanesStopExactlyTheRaysTheirThicknessPromises) {
  for (int a = 0; a <= 7; ++a) {
    for (int b = -7; b <= 7; ++b) {
      for (int c = -7; c <= 7; ++c) {
        for (const Adjacency rays : kAdjacencies) {
          const int least = separating_thickness({a, b, c}, rays);
          if (least == 0) continue;
          EXPECT_FALSE(is_passed({{a, b, c}, least}, rays));
          EXPECT_TRUE(is_passed({{a, b, c}, least - 1}, rays));
        }
      }
    }
  }
}

TEST(Tunnels, PlanesByConnectivityAndBySeparation) {
  const PlaneSearch search = search_planes(8);
  const auto& by_connectivity = search.by_connectivity;
  EXPECT_FALSE(leaks(by_connectivity, kFace, kFace));
  EXPECT_TRUE(leaks(by_connectivity, kEdge, kFace));
  EXPECT_TRUE(leaks(by_connectivity, kCorner, kFace));
  const DigitalPlane first = *by_connectivity[2][0].smallest;
  EXPECT_EQ(first.normal, glm::ivec3(1, 1, 1));
  EXPECT_EQ(first.thickness, 2);
  for (const Adjacency rays : kAdjacencies)
    for (const Adjacency separation : kAdjacencies)
      EXPECT_EQ(leaks(search.by_separation, rays, separation), rays > separation);
}

}  // namespace
}  // namespace rc2::lines
