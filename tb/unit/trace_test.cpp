// Rays through scenes whose answers are known.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "sw/facet/layers.h"
#include "sw/facet/optics.h"
#include "sw/golden/golden_machine.h"
#include "sw/report/laws.h"
#include "sw/scene/shapes.h"
#include "tb/unit/random_rays.h"

namespace rc2 {
namespace {

constexpr int kFraction = 6;

// A scene in a golden machine, ready to be looked at.
class Bench {
 public:
  Bench(const scene::Scene& scene, int n)
      : facets_(facet::build_layers(scene, n, kFraction)), machine_(config(n)) {
    machine_.load(facets_.packets, {});
    optics_ = facet::find_optics(facets_.facets, scene.materials);
  }

  // The rays' trees, each ray being the first of its own pixel.
  RayResult trace(const std::vector<rays::Ray>& rays, int depth, int least_weight = 1) {
    const int n = machine_.config().n;
    std::vector<RayStart> starts(static_cast<std::size_t>(n) * n, {glm::ivec3(0), glm::ivec3(0)});
    for (std::size_t i = 0; i < rays.size(); ++i) starts[i] = {rays[i].origin, rays[i].direction};
    return checked(machine_.trace({{depth, least_weight}, &optics_, &starts}, {}));
  }

  RayResult look(int depth) { return checked(machine_.trace({{depth, 1}, &optics_}, {})); }

  const facet::FacetSet& facets() const { return facets_; }
  golden::GoldenMachine& machine() { return machine_; }
  std::vector<rays::Facet>& optics() { return optics_; }

 private:
  static MachineConfig config(int n) {
    MachineConfig config;
    config.n = n;
    config.fraction_bits = kFraction;
    return config;
  }

  static RayResult checked(RayResult result) {
    report::check_rays(result);
    return result;
  }

  facet::FacetSet facets_;
  golden::GoldenMachine machine_;
  std::vector<rays::Facet> optics_;
};

scene::Material mirror(float share) {
  scene::Material material;
  material.mirror = share;
  return material;
}

scene::Material glass(float clear, float index) {
  scene::Material material;
  material.transparency = clear;
  material.refractive_index = index;
  return material;
}

rays::Ray ray_from(const glm::dvec3& origin, const glm::dvec3& direction, int n) {
  rays::Ray ray;
  ray.origin = glm::ivec3(glm::floor(origin * double{rays::kPlaceOne} + 0.5));
  ray.direction = glm::ivec3(
      glm::floor(glm::normalize(direction) * std::exp2(rays::direction_fraction(n)) + 0.5));
  return ray;
}

glm::dvec3 place(const glm::ivec3& point) { return glm::dvec3(point) / double{rays::kPlaceOne}; }

const RayHit& node(const RayResult& result, int number) {
  for (const RayHit& hit : result.hits)
    if (hit.ray.node == number) return hit;
  throw std::out_of_range("no such node");
}

TEST(Trace, EmptyCubeLetsEveryRayOut) {
  scene::Scene scene;
  scene.materials.emplace_back();
  Bench bench(scene, 16);
  const RayResult result = bench.look(4);
  EXPECT_EQ(result.counts.escaped, 256);
  EXPECT_EQ(result.counts.hits, 0);
  EXPECT_EQ(result.counts.probes, 256);
}

TEST(Trace, FindsTheNearestFaceOfABox) {
  const int n = 32;
  const glm::dvec3 middle(15.3, 16.1, 15.7), half(6.2, 5.4, 7.1);
  scene::Scene scene;
  scene.materials.push_back({});
  scene::Random random(11);
  const glm::dmat3 axes = scene::random_rotation(random);
  scene::add_box(scene, {middle, half, axes}, 0);
  Bench bench(scene, n);
  std::vector<rays::Ray> rays;
  while (rays.size() < 1024) {
    rays::Ray ray = random_ray(random, n);
    const glm::dvec3 towards = middle + scene::random_rotation(random) * glm::dvec3(3, 0, 0);
    if (rays.size() % 2 == 0) ray = ray_from(place(ray.origin), towards - place(ray.origin), n);
    const glm::dvec3 local = glm::transpose(axes) * (place(ray.origin) - middle);
    if (glm::any(glm::greaterThan(glm::abs(local), half + 1.0))) rays.push_back(ray);
  }
  int good = 0, hits = 0, close_calls = 0;
  const RayResult result = bench.trace(rays, 0);
  for (const RayHit& hit : result.hits) {
    const glm::dvec3 from = glm::transpose(axes) * (place(hit.ray.origin) - middle),
                     way = glm::transpose(axes) * glm::normalize(glm::dvec3(hit.ray.direction));
    // The slabs of the box, grown and shrunk by 0.6 voxel: what only one of them meets passes by
    // an edge so closely that voxels may err.
    const auto entry = [&](double grown) {
      double first = 0, last = 1e9;
      for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0) {
          if (std::abs(from[axis]) > half[axis] + grown) return -1.0;
          continue;
        }
        const double a = (-half[axis] - grown - from[axis]) / way[axis],
                     b = (half[axis] + grown - from[axis]) / way[axis];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
      }
      return first <= last ? first : -1.0;
    };
    const bool surely = entry(-0.6) >= 0, perhaps = entry(0.6) >= 0;
    const bool is_hit = hit.facet != RayHit::kNoFacet;
    if (surely != perhaps) {
      ++close_calls;
      continue;
    }
    ASSERT_EQ(is_hit, surely);
    if (!is_hit) continue;
    ++hits;
    const double off = glm::distance(
        place(hit.point),
        place(hit.ray.origin) + entry(0) * glm::normalize(glm::dvec3(hit.ray.direction)));
    if (off < 0.25) ++good;
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(good, hits * 95 / 100);
  EXPECT_LT(close_calls, 100);
}

TEST(Trace, TwoFacingMirrorsPassTheRayOnUntilTheDepthEnds) {
  const int n = 24;
  scene::Scene scene;
  scene.materials.push_back(mirror(1));
  scene::add_box(scene, {{3, 12, 12}, {2, 8, 8}}, 0);
  scene::add_box(scene, {{20, 12, 12}, {2, 8, 8}}, 0);
  Bench bench(scene, n);
  for (int depth = 0; depth <= rays::kMaxDepth; ++depth) {
    const RayResult result = bench.trace({ray_from({12, 12, 12}, {1, 0, 0}, n)}, depth);
    ASSERT_EQ(result.hits.size(), static_cast<std::size_t>(depth + 1));
    EXPECT_EQ(result.counts.too_deep, 1);
    for (int d = 0; d <= depth; ++d) {
      const RayHit& hit = node(result, 1 << d);
      EXPECT_NEAR(place(hit.point).x, d % 2 == 0 ? 18 : 5, 1.0 / 16);
      EXPECT_EQ(hit.point.y, rays::kPlaceOne * 12);
      EXPECT_EQ(hit.ray.weight, rays::kWeightOne);
    }
  }
}

TEST(Trace, GlassBentTwiceShiftsTheRayAndKeepsItsDirection) {
  const int n = 64;
  scene::Scene scene;
  scene.materials.push_back(glass(1, 1.5));
  scene::add_box(scene, {{32, 32, 32}, {24, 24, 8}}, 0);
  Bench bench(scene, n);
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.6, 0, -0.8));
  const RayResult result = bench.trace({ray_from({14, 32, 60}, way, n)}, 2);
  const RayHit &first = node(result, 1), &second = node(result, 3), &third = node(result, 7);
  EXPECT_NEAR(place(first.point).z, 40, 1.0 / 16);
  EXPECT_TRUE(second.ray.inside);
  EXPECT_TRUE(second.is_back);
  EXPECT_NEAR(place(second.point).z, 24, 1.0 / 16);
  // Snell: sin b = 0.6 / 1.5.
  EXPECT_NEAR(place(second.point).x - place(first.point).x, 16 * 0.4 / std::sqrt(1 - 0.16), 0.1);
  EXPECT_FALSE(third.ray.inside);
  EXPECT_EQ(third.facet, RayHit::kNoFacet);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(third.ray.direction[axis], first.ray.direction[axis], 4);
}

TEST(Trace, TotalReflectionGoesOnUntilTheDepthEnds) {
  const int n = 48;
  scene::Scene scene;
  scene.materials.push_back(glass(1, 2.0));
  scene::add_box(scene, {{24, 24, 24}, {16, 12, 12}}, 0);
  Bench bench(scene, n);
  // In through the left side, then along the slab at a flat angle to its upper and lower sides.
  const RayResult result = bench.trace({ray_from({2, 24, 28}, {1, 0, 0.9}, n)}, rays::kMaxDepth);
  const RayHit& in = node(result, 3);
  EXPECT_TRUE(in.ray.inside);
  EXPECT_NEAR(place(in.point).z, 36, 0.1);
  const RayHit& back = node(result, 6);
  EXPECT_TRUE(back.ray.inside);
  EXPECT_EQ(back.ray.weight, in.ray.weight) << "all of it";
  EXPECT_EQ(back.ray.direction.z<0, in.ray.direction.z> 0);
  for (const RayHit& hit : result.hits) EXPECT_NE(hit.ray.node, 7) << "nothing leaves above";
}

TEST(Trace, ARayDoesNotMeetTheFacetsThatItLeaves) {
  const int n = 32;
  scene::Scene scene;
  scene.materials.push_back(mirror(1));
  scene::add_sphere(scene, glm::dvec3(15.5), 9, 2, 0);
  Bench bench(scene, n);
  const RayResult result = bench.look(3);
  EXPECT_GT(result.counts.issued[1], 200);
  EXPECT_LE(result.counts.issued[2], result.counts.issued[1] / 100) << "a ball is convex";
}

TEST(Trace, HardlyAnythingLeavesARoom) {
  const int n = 32;
  const scene::Scene scene = scene::generate("gallery", n);
  Bench bench(scene, n);
  for (rays::Facet& facet : bench.optics()) {
    facet.mirror = facet.clear > 0 ? 64 : 256;
    facet.clear = std::min<std::uint16_t>(facet.clear, 192);
  }
  scene::Random random(12);
  std::vector<rays::Ray> rays;
  while (rays.size() < 1024) {
    rays::Ray ray = random_ray(random, n);
    ray.origin = glm::clamp(ray.origin, rays::kPlaceOne, rays::kPlaceOne * (n - 2));
    rays.push_back(ray);
  }
  const RayResult result = bench.trace(rays, rays::kMaxDepth);
  // Where three walls meet a voxel may belong to the one that the ray does not face.
  EXPECT_GT(result.counts.total(), 8 * 1024);
  EXPECT_LE(result.counts.escaped, result.counts.total() / 1000);
}

TEST(Trace, CutsOffWhatIsTooLight) {
  const int n = 24;
  scene::Scene scene;
  scene.materials.push_back(mirror(0.5F));
  scene::add_box(scene, {{3, 12, 12}, {2, 8, 8}}, 0);
  scene::add_box(scene, {{20, 12, 12}, {2, 8, 8}}, 0);
  Bench bench(scene, n);
  const RayResult result =
      bench.trace({ray_from({12, 12, 12}, {1, 0, 0}, n)}, 7, rays::kWeightOne / 8);
  EXPECT_EQ(result.hits.size(), 4U);
  EXPECT_EQ(result.counts.too_light, 1);
  EXPECT_EQ(result.counts.too_deep, 0);
}

TEST(Trace, LooksTheSameFromTheFrontByStartsAndByColumns) {
  const int n = 24;
  Bench bench(scene::generate("gallery", n), n);
  std::vector<rays::Ray> rays;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) rays.push_back(primary_ray({x, y}, n));
  EXPECT_EQ(bench.look(4).hits, bench.trace(rays, 4, 1).hits);
}

TEST(Trace, RefusesJobsThatMakeNoSense) {
  const int n = 16;
  Bench bench(scene::generate("ball:4", n), n);
  const std::vector<rays::Facet>& optics = bench.optics();
  const auto refuses = [&](const RayJob& job) {
    EXPECT_THROW(bench.machine().trace(job, {}), Error);
  };
  refuses({{8, 1}, &optics});
  refuses({{-1, 1}, &optics});
  refuses({{1, rays::kWeightOne + 1}, &optics});
  refuses({{1, 1}, &optics, nullptr, 0});
  const std::vector<rays::Facet> few;
  refuses({{1, 1}, &few});
  std::vector<RayStart> starts(7);
  refuses({{1, 1}, &optics, &starts});
  const int one = 1 << rays::direction_fraction(n);
  starts.assign(static_cast<std::size_t>(n) * n, {glm::ivec3(0), {0, 0, one}});
  starts[5].origin.x = rays::kPlaceOne * n;
  refuses({{1, 1}, &optics, &starts});
  starts[5] = {glm::ivec3(0), {one, one, one}};
  refuses({{1, 1}, &optics, &starts});
  starts[5] = {glm::ivec3(0), {0, one, 0}};
  EXPECT_NO_THROW(bench.machine().trace({{1, 1}, &optics, &starts}, {}));
  EXPECT_THROW(bench.machine().Machine::trace({{1, 1}, &optics}, {}), Error)
      << "a machine without rays says so";
}

}  // namespace
}  // namespace rc2
