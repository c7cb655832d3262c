// What the error of one bounce calls a wrong hit, held against a machine that is the truth but for
// a mistake that is known.
#include "sim/bounce.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "sw/rays/format.h"
#include "sw/scene/shapes.h"

namespace rc2 {
namespace {

constexpr int kSide = 32;

using truth::Whitted;

/// Where the machine believes a ray to be, what it believes to hit, and the way on from there.
struct Mistake {
  glm::dvec3 aside{0};                                    ///< voxels, before it meets anything
  std::function<glm::dvec3(glm::dvec3, glm::dvec3)> hit;  ///< of where it is and its direction
  double degrees = 0;                                     ///< by which the reflected ray is turned
  bool is_blind = false;                                  ///< nothing is ever hit
};

void expect_about(std::int64_t is, std::int64_t ought, std::int64_t within) {
  EXPECT_LE(std::abs(is - ought), within) << is << " instead of " << ought;
}

class BounceTest : public ::testing::Test {
 protected:
  BounceTest() {
    scene_.materials.resize(2);
    scene_.materials[1].mirror = 0.5F;
    scene::add_box(scene_, {{12, 12, 8}, {9, 9, 2}}, 1);
    scene::add_box(scene_, {{22, 18, 20}, {4, 6, 4}}, 0);
    std::vector<rays::Body> bodies(scene_.polygon_count(), rays::Body::solid);
    scene::add_box(scene_, {{15.5, 15.5, 15.5}, {14, 14, 14}}, 0, true);
    bodies.resize(scene_.polygon_count(), rays::Body::room);
    truth_.emplace(scene_, bodies, kSide);
  }

  Bounce measure(const Mistake& mistake) {
    const auto trace = [&](const RayJob& job) {
      RayResult result;
      for (std::size_t i = 0; i < job.starts->size(); ++i) {
        const RayStart& start = (*job.starts)[i];
        if (start.direction == glm::ivec3(0)) continue;
        answer(glm::ivec2(static_cast<int>(i) % kSide, static_cast<int>(i) / kSide), start, mistake,
               result.hits);
      }
      return result;
    };
    const std::vector<rays::Facet> optics(scene_.polygon_count());
    return measure_bounce(*truth_, scene_, optics, trace, kSide);
  }

 private:
  void answer(const glm::ivec2& home, const RayStart& start, const Mistake& mistake,
              std::vector<RayHit>& hits) const {
    const glm::dvec3 from = glm::dvec3(start.origin) / double{rays::kPlaceOne} + mistake.aside;
    const glm::dvec3 way = glm::normalize(glm::dvec3(start.direction));
    const auto met = truth_->first_hit(from, way, false);
    RayHit hit{};
    hit.ray = {home, 1, false, rays::kWeightOne, start.origin, start.direction};
    hit.facet = met && !mistake.is_blind ? met->polygon : RayHit::kNoFacet;
    if (met) {
      const glm::dvec3 at = mistake.hit ? mistake.hit(met->at, way) : met->at;
      hit.point = glm::ivec3(glm::round(at * double{rays::kPlaceOne}));
    }
    hits.push_back(hit);
    if (!met) return;
    const double turn = glm::radians(mistake.degrees);
    const glm::dvec3 reflected = glm::reflect(way, met->normal);
    const glm::dvec3 across = glm::normalize(glm::cross(reflected, glm::dvec3(0.3, 0.5, 0.8)));
    hit.ray.node = 2;
    hit.ray.direction = glm::ivec3(
        glm::round((std::cos(turn) * reflected + std::sin(turn) * across) * double{1 << 14}));
    hits.push_back(hit);
  }

  scene::Scene scene_;
  std::optional<Whitted> truth_;
};

TEST_F(BounceTest, FindsNoFaultWithTheTruth) {
  const Bounce bounce = measure({});
  EXPECT_GT(bounce.rays, 500);
  // A ray that passes an edge by less than its start is rounded.
  EXPECT_LT(bounce.gross, bounce.rays / 200);
  EXPECT_EQ(bounce.edges, bounce.gross);
  // In a corner the wrong wall may be less than two voxels away.
  expect_about(bounce.straight, bounce.rays - bounce.gross, bounce.rays / 200);
  EXPECT_LT(bounce.distance, 0.05 * static_cast<double>(bounce.rays));
  EXPECT_LT(bounce.degrees, 0.5 * static_cast<double>(bounce.rays));
}

TEST_F(BounceTest, CountsHitsThatAreTooFarOffAlongTheRay) {
  const std::int64_t rays = measure({}).rays;
  Mistake mistake;
  mistake.is_blind = true;
  const Bounce blind = measure(mistake);
  EXPECT_GT(blind.gross, 0);
  EXPECT_EQ(blind.early, 0);

  mistake = {};
  mistake.hit = [](glm::dvec3 at, glm::dvec3 way) { return at - 1.9 * way; };
  EXPECT_LT(measure(mistake).gross, rays / 200);
  mistake.hit = [](glm::dvec3 at, glm::dvec3 way) { return at - 2.1 * way; };
  const Bounce early = measure(mistake);
  expect_about(early.gross, blind.gross, rays / 200);
  // Who starts in a corner may end behind its start.
  EXPECT_GT(early.early, early.gross * 9 / 10);
  EXPECT_LT(early.edges, early.gross / 5);
  mistake.hit = [](glm::dvec3 at, glm::dvec3 way) { return at + 2.1 * way; };
  const Bounce late = measure(mistake);
  expect_about(late.gross, blind.gross, rays / 200);
  EXPECT_LT(late.early, late.gross / 20);
}

TEST_F(BounceTest, KnowsWhatOnlyPassesAnEdge) {
  Mistake mistake;
  mistake.aside = {0.25, -0.2, 0.1};  // less than half a voxel
  const Bounce close = measure(mistake);
  EXPECT_GT(close.gross, close.rays / 200);
  EXPECT_LT(close.gross, close.rays / 20);
  EXPECT_GT(close.edges, close.gross / 2);  // else it grazes a wall, and ends elsewhere on it
  mistake.aside *= 5.0;
  const Bounce wide = measure(mistake);
  EXPECT_GT(wide.gross, 2 * close.gross);
  EXPECT_LT(wide.edges, wide.gross / 4);
}

TEST_F(BounceTest, MeasuresTheTurnOfReflectedRays) {
  Mistake mistake;
  mistake.degrees = 0.9;
  const Bounce less = measure(mistake);
  expect_about(less.straight, less.rays - less.gross, less.rays / 200);
  mistake.degrees = 1.1;
  const Bounce more = measure(mistake);
  mistake.is_blind = true;
  const std::int64_t hits = measure(mistake).gross;
  expect_about(more.straight, more.rays - hits, more.rays / 100);
  EXPECT_NEAR(more.degrees - less.degrees, 0.2 * static_cast<double>(hits),
              0.01 * static_cast<double>(hits));
}

}  // namespace
}  // namespace rc2
