// Rays by chapter 5's choices: against the golden model where they are the machine's, against
// geometry where they are not.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "sw/chapter5/tracer.h"
#include "sw/facet/layers.h"
#include "sw/facet/optics.h"
#include "sw/golden/golden_machine.h"

namespace rc2::chapter5 {
namespace {

constexpr int kFraction = 6;

struct Stage {
  Stage(const std::string& name, int side) : n(side), scene(scene::generate(name, n)) {
    facets = facet::build_layers(scene, n, kFraction);
    optics = facet::find_optics(facets.facets, scene.materials);
  }

  RayJob job(int depth) const { return {{depth, 1}, &optics}; }

  RayResult golden(int depth) const {
    golden::GoldenMachine machine(config());
    machine.load(facets.packets, {});
    return machine.trace(job(depth), {});
  }

  RayResult chosen(int depth, const Choices& choices) const {
    return trace(Voxels(facets.packets, optics, n, choices.owner), job(depth), choices, true);
  }

  MachineConfig config() const {
    MachineConfig config;
    config.n = n;
    config.fraction_bits = kFraction;
    return config;
  }

  int n;
  scene::Scene scene;
  facet::FacetSet facets;
  std::vector<rays::Facet> optics;
};

TEST(Chapter5, VoxelsAreTheMachines) {
  const Stage stage("gallery", 24);
  golden::GoldenMachine machine(stage.config());
  machine.load(stage.facets.packets, {});
  EXPECT_EQ(Voxels(stage.facets.packets, stage.optics, stage.n, Owner::core).memory(),
            machine.read_voxels());
}

// Owners differ, occupied voxels do not; each owner is the best of the facets by its own rule.
TEST(Chapter5, OwnersByRule) {
  const Stage stage("gallery", 24);
  const auto of = [&](Owner owner) {
    return Voxels(stage.facets.packets, stage.optics, stage.n, owner).memory();
  };
  const VoxelMemory core = of(Owner::core), nearest = of(Owner::nearest), first = of(Owner::first);
  ASSERT_EQ(core.size(), nearest.size());
  ASSERT_EQ(core.size(), first.size());
  std::int64_t farther = 0;
  const auto distance = [](const Claim& claim) { return claim.gap < 0 ? ~claim.gap : claim.gap; };
  for (std::size_t i = 0; i < core.size(); ++i) {
    EXPECT_EQ(core[i].at, nearest[i].at);
    EXPECT_LE(distance(nearest[i].owner), distance(core[i].owner));
    EXPECT_LE(first[i].owner.facet, std::min(core[i].owner.facet, nearest[i].owner.facet));
    farther += distance(core[i].owner) > distance(nearest[i].owner);
  }
  EXPECT_GT(farther, 0);
}

TEST(Chapter5, MachinesChoicesAreGoldensRays) {
  for (const char* name : {"gallery", "ball:9"}) {
    Stage stage(name, 24);
    if (stage.scene.materials.size() == 1)
      for (rays::Facet& facet : stage.optics) facet.mirror = rays::kShareOne;
    const RayResult golden = stage.golden(3), chosen = stage.chosen(3, {});
    // But for the rays that the safety net rescues, and what comes of them.
    std::map<std::pair<int, int>, const RayHit*> by_node;
    std::int64_t differ = 0;
    ASSERT_GT(golden.hits.size(), static_cast<std::size_t>(24 * 24));
    for (const RayHit& hit : golden.hits)
      by_node[{hit.ray.home.y * 24 + hit.ray.home.x, hit.ray.node}] = &hit;
    for (const RayHit& hit : chosen.hits) {
      const auto same = by_node.find({hit.ray.home.y * 24 + hit.ray.home.x, hit.ray.node});
      differ += same == by_node.end() || !(*same->second == hit);
    }
    EXPECT_LE(differ, 4 * golden.counts.rescued) << name;
    EXPECT_LT(differ, static_cast<std::int64_t>(golden.hits.size()) / 50) << name;
  }
}

// A wall along the voxels: all normals are the same, and so are the rays' directions.
TEST(Chapter5, AFlatWallHasOneNormal) {
  scene::Scene scene;
  scene.materials.resize(1);
  scene.materials[0].mirror = 1;
  scene.add({{2, 2, 6}, {18, 2, 6}, {18, 18, 6}, {2, 18, 6}}, 0);
  const int n = 20;
  const facet::FacetSet facets = facet::build_layers(scene, n, kFraction);
  const auto optics = facet::find_optics(facets.facets, scene.materials);
  const Voxels voxels(facets.packets, optics, n, Owner::core);
  std::vector<RayStart> starts(static_cast<std::size_t>(n) * n, {glm::ivec3(0), glm::ivec3(0)});
  const int one = 1 << rays::direction_fraction(n);
  starts[0] = {rays::kPlaceOne * glm::ivec3(5, 5, 18), {one * 3 / 5, 0, -one * 4 / 5}};
  for (const Normal normal : {Normal::facet, Normal::mean, Normal::side}) {
    for (const Point point : {Point::plane, Point::centre, Point::side}) {
      const Choices choices{normal, point};
      const RayResult result = trace(voxels, {{1, 1}, &optics, &starts}, choices, false);
      ASSERT_EQ(result.hits.size(), 2U);
      const rays::Ray& reflected = result.hits[1].ray;
      EXPECT_EQ(reflected.direction.x, starts[0].direction.x);
      EXPECT_NEAR(reflected.direction.z, -starts[0].direction.z, 1);
      // The plane is z = 6; the voxel's side is half a voxel above its centre, which is z = 6 too.
      const int want = rays::kPlaceOne * 6 + (point == Point::side ? rays::kPlaceOne / 2 - 1 : 0);
      EXPECT_NEAR(result.hits[0].point.z, want, 3) << static_cast<int>(point);
      EXPECT_NEAR(result.hits[0].point.x, rays::kPlaceOne * (point == Point::side ? 13.625 : 14),
                  point == Point::centre ? rays::kPlaceOne / 2 : 4);
    }
  }
}

// What 5.5.2 warns of: a ray that any voxel stops does not get away from its own surface.
TEST(Chapter5, LeavingItsOwnSurface) {
  Stage stage("ball:20", 64);
  for (rays::Facet& facet : stage.optics) facet.mirror = rays::kShareOne;
  const auto escaped = [&](Leave leave) {
    Choices choices;
    choices.leave = leave;
    const RayResult result = stage.chosen(1, choices);
    std::int64_t mirrored = 0, away = 0;
    for (const RayHit& hit : result.hits) {
      if (hit.ray.node != 2) continue;
      ++mirrored;
      away += hit.facet == RayHit::kNoFacet;
    }
    return static_cast<double>(away) / static_cast<double>(mirrored);
  };
  // A ball is convex: everything that it reflects leaves.
  EXPECT_EQ(escaped(Leave::facing_exit), 1);
  EXPECT_GT(escaped(Leave::facing), 0.98);
  EXPECT_LT(escaped(Leave::gap), 0.98);
  EXPECT_LT(escaped(Leave::own_facet), escaped(Leave::gap) - 0.02);
  EXPECT_LT(escaped(Leave::nothing), escaped(Leave::own_facet));
  EXPECT_LT(escaped(Leave::nothing), 0.7);
}

// At the middle of a voxel along the ray's longest axis the ray is nearest to this voxel.
void expect_on_the_way(const RayHit& hit) {
  const glm::dvec3 way(hit.ray.direction), from = glm::dvec3(hit.ray.origin) / 64.0;
  const glm::dvec3 size = glm::abs(way);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (hit.voxel[axis] == std::lround(from[axis])) return;
  const glm::dvec3 at = from + (hit.voxel[axis] - from[axis]) / way[axis] * way;
  for (int other = 0; other < 3; ++other) EXPECT_NEAR(at[other], hit.voxel[other], 0.5 + 1e-9);
}

// Steps across edges pass fewer voxels and hit about the same.
TEST(Chapter5, StepsAcrossEdges) {
  const Stage stage("gallery", 32);
  Choices choices;
  choices.steps = Steps::twenty_six;
  const RayResult wide = stage.chosen(1, choices), narrow = stage.chosen(1, {});
  std::int64_t near = 0, all = 0;
  std::map<std::pair<int, int>, const RayHit*> by_node;
  for (const RayHit& hit : narrow.hits)
    by_node[{hit.ray.home.y * 32 + hit.ray.home.x, hit.ray.node}] = &hit;
  for (const RayHit& hit : wide.hits) {
    if (hit.ray.node == 1) continue;
    if (hit.facet != RayHit::kNoFacet) expect_on_the_way(hit);
    const auto other = by_node.find({hit.ray.home.y * 32 + hit.ray.home.x, hit.ray.node});
    if (other == by_node.end()) continue;
    ++all;
    near += glm::distance(glm::vec3(hit.point), glm::vec3(other->second->point)) < 64;
  }
  EXPECT_GT(all, 300);
  EXPECT_GT(near, all * 95 / 100);
}

}  // namespace
}  // namespace rc2::chapter5
