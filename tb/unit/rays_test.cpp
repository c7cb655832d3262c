// The arithmetic of rays against exact rational numbers and against doubles.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/vector_int3_sized.hpp>
#include <glm/geometric.hpp>

#include "sw/golden/walk.h"
#include "sw/rays/face.h"
#include "sw/rays/split.h"
#include "tb/unit/random_rays.h"

namespace rc2::rays {
namespace {

constexpr int kSides[] = {2, 3, 8, 33, 128, 1024};

struct Visit {
  glm::ivec3 voxel;
  int axis;
};

std::vector<Visit> visits_of(const Ray& ray, int n) {
  std::vector<Visit> visits;
  golden::walk(ray, n, [&](const glm::ivec3& voxel, int axis) {
    visits.push_back({voxel, axis});
    return false;
  });
  return visits;
}

// When the ray has gone `way` at `speed`: an exact fraction.
struct Time {
  std::int64_t way, speed;
};

bool operator<(const Time& a, const Time& b) { return a.way * b.speed < b.way * a.speed; }

// When the ray, which moves along the axis, comes to a place; negative if it was there before.
Time time_at(const Ray& ray, int axis, std::int64_t place) {
  const std::int64_t ahead = place - ray.origin[axis], speed = ray.direction[axis];
  return speed < 0 ? Time{-ahead, -speed} : Time{ahead, speed};
}

int sign(int value) { return value < 0 ? -1 : 1; }

// The columns that the exact ray passes until then, at a corner of four first the one along y.
std::vector<glm::ivec2> exact_columns(const Ray& ray, int n, const Time& end) {
  glm::ivec2 at(voxel_of(ray.origin.x), voxel_of(ray.origin.y));
  std::vector<glm::ivec2> columns;
  for (;;) {
    columns.push_back(at);
    std::optional<Time> first;
    int axis = 2;
    for (const int i : {1, 0}) {
      if (ray.direction[i] == 0) continue;
      const Time time = time_at(ray, i, kPlaceOne * at[i] + sign(ray.direction[i]) * kPlaceOne / 2);
      if (first && !(time < *first)) continue;
      first = time;
      axis = i;
    }
    if (axis == 2 || !(*first < end)) return columns;
    at[axis] += sign(ray.direction[axis]);
    if (at[axis] < 0 || at[axis] >= n) return columns;
  }
}

TEST(Walk, PassesTheColumnsOfTheExactRay) {
  scene::Random random(1);
  for (const int n : kSides) {
    for (int i = 0; i < 400; ++i) {
      const Ray ray = random_ray(random, n);
      std::vector<glm::ivec2> columns;
      for (const Visit& visit : visits_of(ray, n))
        if (columns.empty() || columns.back() != glm::ivec2(visit.voxel))
          columns.emplace_back(visit.voxel);
      // Heights are rounded, so the walk may leave above or below half a voxel sooner or later.
      const int top = ray.direction.z < 0 ? -kPlaceOne / 2 : kPlaceOne * n - kPlaceOne / 2;
      const auto until = [&](int margin) {
        if (ray.direction.z == 0) return Time{1, 0};  // for ever
        return time_at(ray, 2, top + sign(ray.direction.z) * margin);
      };
      const auto least = exact_columns(ray, n, until(-kPlaceOne)),
                 most = exact_columns(ray, n, until(kPlaceOne));
      ASSERT_GE(columns.size(), least.size()) << "n " << n << " ray " << i;
      ASSERT_LE(columns.size(), most.size()) << "n " << n << " ray " << i;
      ASSERT_TRUE(std::equal(columns.begin(), columns.end(), most.begin())) << n << " ray " << i;
    }
  }
}

TEST(Walk, StaysWithinHalfAVoxelOfTheExactRayAndGoesFromSideToSide) {
  scene::Random random(2);
  for (const int n : kSides) {
    for (int i = 0; i < 400; ++i) {
      const Ray ray = random_ray(random, n);
      const std::vector<Visit> visits = visits_of(ray, n);
      ASSERT_FALSE(visits.empty());
      ASSERT_EQ(visits.front().voxel, voxel_of(ray.origin));
      for (std::size_t k = 0; k + 1 < visits.size(); ++k) {
        const glm::ivec3 step = visits[k + 1].voxel - visits[k].voxel;
        const int axis = visits[k].axis;
        glm::ivec3 expected(0);
        expected[axis] = sign(ray.direction[axis]);
        ASSERT_EQ(step, expected) << "n " << n << " ray " << i;
        // Where it leaves the column, the exact ray is at a height that lies in the last voxel,
        // but for the half voxel that slopes may fall short.
        if (axis == 2) continue;
        const int side = kPlaceOne * visits[k].voxel[axis] + expected[axis] * kPlaceOne / 2;
        const Time time = time_at(ray, axis, side);
        const std::int64_t over = (ray.origin.z - kPlaceOne * visits[k].voxel.z) * time.speed +
                                  time.way * ray.direction.z;
        ASSERT_LE(std::abs(over), kPlaceOne * time.speed) << n << " ray " << i;
      }
      const Visit& last = visits.back();
      const int beyond = last.voxel[last.axis] + sign(ray.direction[last.axis]);
      ASSERT_TRUE(beyond == -1 || beyond == n);
    }
  }
}

TEST(Walk, AlongAnAxisNeverLeavesItsLine) {
  for (const int n : kSides)
    for (int axis = 0; axis < 3; ++axis)
      for (const int sign : {-1, 1}) {
        Ray ray;
        ray.origin = glm::ivec3(kPlaceOne * (n / 2) - kPlaceOne / 2);  // on a corner of voxels
        ray.direction = glm::ivec3(0);
        ray.direction[axis] = sign * (1 << direction_fraction(n));
        const std::vector<Visit> visits = visits_of(ray, n);
        EXPECT_EQ(static_cast<int>(visits.size()), sign < 0 ? n / 2 + 1 : n - n / 2);
        for (const Visit& visit : visits)
          for (int other = 0; other < 3; ++other)
            if (other != axis) {
              EXPECT_EQ(visit.voxel[other], n / 2);
            }
      }
}

TEST(Launch, FitsItsWidths) {
  scene::Random random(3);
  const auto fits = [](std::int64_t value, int bits) {
    return value >= -(std::int64_t{1} << (bits - 1)) && value < std::int64_t{1} << (bits - 1);
  };
  for (const int n : kSides) {
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = random_ray(random, n);
      const Launch start = launch(ray, n);
      ASSERT_TRUE(fits(start.decision, decision_bits(n)));
      for (const std::int64_t value : {start.exit_x, start.exit_y, start.slope_x, start.slope_y})
        ASSERT_TRUE(fits(value, slope_bits(n))) << n << " ray " << i;
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_TRUE(fits(ray.origin[axis], place_bits(n)));
        ASSERT_TRUE(fits(ray.direction[axis], direction_bits(n)));
      }
    }
  }
}

// The last column of the table in docs/render.md.
TEST(Format, IsAsWideAsTheTableSays) {
  EXPECT_EQ(3 * place_bits(128), 45);
  EXPECT_EQ(3 * direction_bits(128), 42);
  EXPECT_EQ(decision_bits(128), 20);
  EXPECT_EQ(2 * slope_bits(128), 36);
  EXPECT_EQ(slope_fraction(128), 8);
  EXPECT_EQ(2 * kNormalBits + 3, 27) << "an axis and a sign beside the two smaller components";
}

Facet random_facet(scene::Random& random) {
  Facet facet;
  for (int axis = 0; axis < 3; ++axis)
    facet.normal[axis] = random.below(2 * kNormalOne + 1) - kNormalOne;
  facet.normal[random.below(3)] = random.below(2) == 0 ? kNormalOne : -kNormalOne;
  return facet;
}

// scale times N.(p - centre) + gap in 1/64 voxel, p being a place times the scale: exact.
std::int64_t over_plane(const Owned& owned, const glm::i64vec3& p, std::int64_t scale) {
  std::int64_t sum = scale * (4 * owned.gap + 2) * kNormalOne;
  for (int axis = 0; axis < 3; ++axis)
    sum += owned.facet.normal[axis] * (p[axis] - scale * kPlaceOne * owned.voxel[axis]);
  return sum;
}

TEST(Face, IsReachedExactlyWhereTheExactRayIsBehindThePlane) {
  scene::Random random(4);
  int reached = 0, seen = 0;
  for (int i = 0; i < 20000; ++i) {
    const int n = kSides[2 + i % 4];
    const Ray ray = random_ray(random, n);
    const Facet facet = random_facet(random);
    const glm::ivec3 voxel(random.below(n), random.below(n), random.below(n));
    const Owned owned{voxel, facet, true, random.below(64) - 32};
    const int axis = random.below(3);
    const std::int64_t speed = std::abs(ray.direction[axis]), way = random.below(kPlaceOne * n);
    if (speed == 0) continue;
    const glm::i64vec3 start(ray.origin), direction(ray.direction);
    const std::int64_t at_start = over_plane(owned, start, 1),
                       at_end = over_plane(owned, speed * start + way * direction, speed);
    std::int64_t towards = 0;
    for (int k = 0; k < 3; ++k) towards -= facet.normal[k] * direction[k];

    const auto face = rays::face(ray, owned);
    ASSERT_EQ(face.has_value(), towards > 0 && at_start >= 0) << i;
    ASSERT_EQ(is_in_front(ray, owned, axis, way), at_end > 0) << i;
    if (!face) continue;
    ++seen;
    ASSERT_LE(std::abs(face->height), std::int64_t{1} << (height_bits(n) - 1));
    ASSERT_EQ(is_reached(ray, *face, axis, way), at_end <= 0) << i;
    if (at_end > 0) continue;
    ++reached;
    // The ray meets the plane at start + direction * at_start / towards.
    const glm::i64vec3 point(meeting_point(ray, *face, n));
    for (int k = 0; k < 3; ++k)
      ASSERT_LE(std::abs((point[k] - start[k]) * towards - direction[k] * at_start), towards)
          << i << " n " << n;
  }
  EXPECT_GT(reached, 1000);
  EXPECT_GT(seen, reached);
}

TEST(Face, SeesSolidsFromOutsideGlassFromInsideSheetsFromBoth) {
  Ray ray;
  ray.origin = kPlaceOne * glm::ivec3(4, 4, 8);
  ray.direction = {0, 0, -(1 << direction_fraction(16))};
  Facet up, down;
  down.normal = {0, 0, -kNormalOne};
  const auto sees = [&](const Facet& facet, bool core = true) {
    return face(ray, {{4, 4, 4}, facet, core, 0}).has_value();
  };
  EXPECT_TRUE(sees(up));
  EXPECT_FALSE(sees(up, false)) << "outside of its core a solid is not there";
  EXPECT_FALSE(sees(down));
  up.body = down.body = Body::room;
  EXPECT_TRUE(sees(up, false));
  EXPECT_FALSE(sees(down));
  up.body = down.body = Body::sheet;
  EXPECT_TRUE(sees(up));
  ASSERT_TRUE(sees(down));
  EXPECT_TRUE(face(ray, {{4, 4, 4}, down, true, 0})->is_back);
  up.body = down.body = Body::solid;
  ray.inside = true;
  EXPECT_TRUE(sees(up)) << "what is not glass is seen in glass";
  up.clear = down.clear = 100;
  EXPECT_FALSE(sees(up));
  EXPECT_TRUE(sees(down));
}

TEST(Face, ASheetDoesNotStopTheRayThatLeavesIt) {
  Facet sheet;
  sheet.body = Body::sheet;
  Ray ray;
  ray.origin = kPlaceOne * glm::ivec3(4, 4, 4) + glm::ivec3(0, 0, kPlaceOne / 4);
  ray.direction = {0, 0, -(1 << direction_fraction(16))};
  EXPECT_FALSE(face(ray, {{4, 4, 4}, sheet, true, 0}));
  ray.origin.z += kPlaceOne / 2;
  EXPECT_TRUE(face(ray, {{4, 4, 4}, sheet, true, 0}));
}

// A face that the direction comes nearer to, straight on or grazing.
std::pair<glm::ivec3, Face> random_meeting(scene::Random& random, int n) {
  for (;;) {
    Ray ray;
    ray.direction = random_direction(random, n);
    ray.origin = kPlaceOne * glm::ivec3(n / 2);
    const Facet facet = random_facet(random);
    const auto met = face(ray, {glm::ivec3(n / 2), facet, true, 0});
    if (met) return {ray.direction, *met};
  }
}

TEST(Split, ReflectsAsDoublesDo) {
  scene::Random random(5);
  for (const int n : kSides) {
    for (int i = 0; i < 5000; ++i) {
      const auto [direction, met] = random_meeting(random, n);
      const glm::ivec3 have = reflect(direction, met, n);
      const glm::dvec3 want =
          glm::reflect(glm::dvec3(direction), glm::normalize(glm::dvec3(met.normal)));
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(have[axis], want[axis], 2) << n << " ray " << i;
    }
  }
}

TEST(Split, RefractsBySnellsLaw) {
  scene::Random random(6);
  int bent = 0, thrown_back = 0;
  for (const int n : kSides) {
    const double one = 1 << direction_fraction(n);
    for (int i = 0; i < 5000; ++i) {
      const auto [direction, met] = random_meeting(random, n);
      const int ratio = kIndexOne / 4 + random.below(3 * kIndexOne);
      const double r = ratio / double{kIndexOne};
      const glm::dvec3 d = glm::normalize(glm::dvec3(direction)),
                       normal = glm::normalize(glm::dvec3(met.normal));
      const double cosine = -glm::dot(d, normal), square = 1 - r * r * (1 - cosine * cosine);
      const auto have = refract(direction, met, ratio, n);
      // What is near the limit may go either way: the direction is a rounded one.
      const double doubt = 8 * r * r / one;
      if (std::abs(square) > doubt) {
        ASSERT_EQ(have.has_value(), square > 0) << n << " ray " << i;
      }
      if (!have) {
        ++thrown_back;
        continue;
      }
      ++bent;
      if (square < doubt) continue;
      const double root = std::sqrt(square);
      const glm::dvec3 want = one * (r * d + (r * cosine - root) * normal);
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_NEAR((*have)[axis], want[axis], 3 + 4 * r * r / root) << n << " ray " << i;
    }
  }
  EXPECT_GT(bent, 1000);
  EXPECT_GT(thrown_back, 1000);
}

TEST(Split, SendsNoMoreThanCame) {
  scene::Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const int n = 64;
    Ray ray;
    ray.direction = random_direction(random, n);
    ray.origin = kPlaceOne * glm::ivec3(n / 2);
    ray.home = {3, 5};
    ray.node = static_cast<std::uint8_t>(1 + random.below(127));
    ray.weight = static_cast<std::uint16_t>(1 + random.below(kWeightOne));
    ray.inside = random.below(2) == 0;
    Facet facet = random_facet(random);
    facet.mirror = static_cast<std::uint16_t>(random.below(kShareOne + 1));
    facet.clear = static_cast<std::uint16_t>(random.below(kShareOne - facet.mirror + 1));
    facet.enter = kIndexOne * 2 / 3;
    facet.leave = kIndexOne * 3 / 2;
    const auto met = face(ray, {glm::ivec3(n / 2), facet, true, 0});
    if (!met) continue;
    const Limits limits{random.below(kMaxDepth + 1), random.below(kWeightOne / 8)};
    const Split result = split(ray, facet, *met, ray.origin, limits, n);
    int weight = 0, children = 0;
    for (const auto& child : {result.reflected, result.refracted}) {
      if (!child) continue;
      ++children;
      weight += child->weight;
      EXPECT_GE(child->weight, std::max(1, limits.least_weight));
      EXPECT_EQ(child->node / 2, ray.node);
      EXPECT_EQ(child->home, ray.home);
      EXPECT_LE(depth_of(child->node), limits.depth);
      EXPECT_NEAR(glm::length(glm::dvec3(child->direction)), 1 << direction_fraction(n), 16);
    }
    EXPECT_LE(weight, ray.weight);
    EXPECT_LE(children + result.too_light + result.too_deep, 2);
    if (result.refracted) {
      EXPECT_NE(result.refracted->inside, ray.inside);
    }
    if (result.reflected) {
      EXPECT_EQ(result.reflected->inside, ray.inside);
    }
    // All that glass does not let through, it throws back.
    const bool is_total = facet.is_glass() && !refract(ray.direction, *met,
                                                       met->is_back ? facet.leave : facet.enter, n);
    if (is_total && result.reflected) {
      EXPECT_EQ(result.reflected->weight, ray.weight * (facet.mirror + facet.clear) / kShareOne);
    }
  }
}

}  // namespace
}  // namespace rc2::rays
