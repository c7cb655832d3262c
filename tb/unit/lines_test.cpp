// The line algorithms against their claims and against rational arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/rational.hpp>
#include <cmath>
#include <map>
#include <ostream>
#include <random>

#include "sw/lines/algorithms.h"
#include "sw/lines/connectivity.h"
#include "sw/lines/digital_line.h"
#include "sw/lines/segment.h"

namespace rc2::lines {

std::ostream& operator<<(std::ostream& out, const Algorithm& algorithm) {
  return out << algorithm.name;
}

namespace {

using Rational = boost::rational<std::int64_t>;
using Voxels = std::vector<glm::ivec3>;
using I64 = std::int64_t;

std::string text(glm::ivec3 v) {
  return "(" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + ")";
}

std::string text(glm::ivec3 from, glm::ivec3 to) { return text(from) + " - " + text(to); }

// -- oracles: what each algorithm should draw from the origin to `way`, in rationals ------------

I64 floor_of(Rational r) {
  const I64 down = r.numerator() / r.denominator();
  return r < down ? down - 1 : down;
}

int nearest_ties_down(Rational r) { return static_cast<int>(-floor_of(Rational(1, 2) - r)); }

Voxels nearest_voxels(glm::ivec3 way) {
  Voxels voxels;
  const int steps = steps_between({0, 0, 0}, way);
  for (int k = 0; k <= steps; ++k) {
    glm::ivec3 at(0);
    for (int axis = 0; axis < 3 && steps > 0; ++axis)
      at[axis] = nearest_ties_down(Rational(I64{way[axis]} * k, steps));
    voxels.push_back(at);
  }
  return voxels;
}

// The voxels that hold the points between successive crossings of the segment moved by
// -(e, e^2, e^3), where e is small enough to part crossings without changing their order.
Voxels pierced_voxels(glm::ivec3 way) {
  const Rational shift[] = {{-1, I64{1} << 8}, {-1, I64{1} << 16}, {-1, I64{1} << 24}};
  std::vector<Rational> times;
  for (int axis = 0; axis < 3; ++axis) {
    for (int crossing = 0; crossing < std::abs(way[axis]); ++crossing) {
      const int sign = way[axis] > 0 ? 1 : -1;
      times.push_back((Rational(sign * (2 * crossing + 1), 2) - shift[axis]) / I64{way[axis]});
    }
  }
  std::sort(times.begin(), times.end());
  Voxels voxels = {{0, 0, 0}};
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const Rational time = (times[i] + times[i + 1]) / I64{2};
    glm::ivec3 at;
    for (int axis = 0; axis < 3; ++axis)
      at[axis] = nearest_ties_down(time * I64{way[axis]} + shift[axis]);
    voxels.push_back(at);
  }
  if (!times.empty()) voxels.push_back(way);
  return voxels;
}

// The places of halved voxels by their definition, kept by the fraction of the way at which the
// halving puts them.
void halve(std::map<Rational, glm::ivec3>& voxels, Rational from, Rational to, bool down) {
  const glm::ivec3 a = voxels[from], b = voxels[to];
  if (steps_between(a, b) <= 1) return;
  const Rational middle = (from + to) / I64{2};
  glm::ivec3 at;
  for (int axis = 0; axis < 3; ++axis) {
    const Rational exact(I64{a[axis]} + b[axis], 2);
    const bool towards_low = (a[axis] < b[axis]) == down;
    at[axis] = static_cast<int>(towards_low ? floor_of(exact) : -floor_of(-exact));
  }
  voxels[middle] = at;
  halve(voxels, from, middle, down);
  halve(voxels, middle, to, down);
}

Voxels halved_voxels(glm::ivec3 way) {
  std::map<Rational, glm::ivec3> places = {{0, {0, 0, 0}}, {1, way}};
  halve(places, 0, 1, std::make_tuple(way.x, way.y, way.z) > std::make_tuple(0, 0, 0));
  Voxels voxels;
  for (const auto& [time, at] : places)
    if (voxels.empty() || way != glm::ivec3(0)) voxels.push_back(at);
  return voxels;
}

bool is(const Algorithm& algorithm, const char* name) {
  return algorithm.name == std::string(name);
}

Voxels oracle(const Algorithm& algorithm, glm::ivec3 way) {
  if (is(algorithm, "amanatides-woo")) return pierced_voxels(way);
  if (is(algorithm, "dichotomic")) return halved_voxels(way);
  return nearest_voxels(way);
}

// -- exact laws, in integers, cheap enough for every voxel of a million segments ----------------

// Twice how far, in units of 1/steps, coordinate `axis` is above the segment at step k.
I64 doubled_error(glm::ivec3 from, glm::ivec3 way, I64 steps, I64 k, glm::ivec3 at, int axis) {
  return 2 * (steps * (at[axis] - from[axis]) - k * way[axis]);
}

bool is_nearest(glm::ivec3 from, glm::ivec3 way, I64 steps, I64 k, glm::ivec3 at) {
  for (int axis = 0; axis < 3; ++axis) {
    const I64 error = doubled_error(from, way, steps, k, at, axis);
    if (error < -steps || error >= steps) return false;
  }
  return true;
}

// Within (2 halvings + 1) / 6 of the segment.
bool is_halved(glm::ivec3 from, glm::ivec3 way, I64 steps, I64 k, glm::ivec3 at, I64 halvings) {
  for (int axis = 0; axis < 3; ++axis) {
    const I64 error = doubled_error(from, way, steps, k, at, axis);
    if (3 * std::abs(error) > (2 * halvings + 1) * steps) return false;
  }
  return true;
}

// Whether the segment meets the closed unit cube around `at`: the intervals of time that it spends
// between the cube's pairs of faces, as fractions, have a time in common.
bool is_met(glm::ivec3 from, glm::ivec3 way, glm::ivec3 at) {
  I64 low = 0, low_of = 1, high = 1, high_of = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const I64 centre = I64{2} * (at[axis] - from[axis]), length = I64{2} * std::abs(way[axis]);
    const I64 offset = way[axis] < 0 ? -centre : centre;
    if (length == 0) {
      if (centre != 0) return false;
      continue;
    }
    if ((offset - 1) * low_of > low * length) low = offset - 1, low_of = length;
    if ((offset + 1) * high_of < high * length) high = offset + 1, high_of = length;
  }
  return low * high_of <= high * low_of;
}

// The first law that the voxels break, or nothing.
std::string broken_law(const Algorithm& algorithm, glm::ivec3 from, glm::ivec3 to,
                       const Voxels& voxels) {
  const glm::ivec3 way = to - from, length = glm::abs(way);
  const I64 steps = steps_between(from, to), units = std::max(steps, I64{1});
  I64 halvings = 0;
  while ((I64{1} << halvings) < steps) ++halvings;
  const bool faces = algorithm.connectivity == Adjacency::face;
  const I64 moves = faces ? I64{length.x} + length.y + length.z : steps;
  if (voxels.size() != static_cast<std::size_t>(moves + 1)) return "number of voxels";
  if (voxels.front() != from || voxels.back() != to) return "end points";
  const int along = driving_axis(way), sign = way[along] < 0 ? -1 : 1;
  const bool halves = is(algorithm, "dichotomic");
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const glm::ivec3 at = voxels[i];
    if (i > 0) {
      const glm::ivec3 step = glm::abs(at - voxels[i - 1]);
      if (faces ? step.x + step.y + step.z != 1 : std::max({step.x, step.y, step.z}) != 1)
        return "connectivity at " + text(at);
    }
    if (faces) {
      if (!is_met(from, way, at)) return "distance at " + text(at);
      continue;
    }
    const I64 k = I64{sign} * (at[along] - from[along]);
    if (k != static_cast<I64>(i)) return "one voxel per step at " + text(at);
    if (halves ? !is_halved(from, way, units, k, at, halvings)
               : !is_nearest(from, way, units, k, at))
      return "distance at " + text(at);
  }
  return {};
}

// -----------------------------------------------------------------------------------------------

class Lines : public testing::TestWithParam<Algorithm> {
 protected:
  static Voxels draw(glm::ivec3 from, glm::ivec3 to) {
    Voxels voxels;
    GetParam().draw(from, to, voxels);
    return voxels;
  }
};

constexpr int kSide = 9;

template <class Do>
void for_each_way(int reach, const Do& act) {
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) act(glm::ivec3(x, y, z));
}

TEST_P(Lines, DrawTheOraclesVoxelsBetweenAllEndPointsOfACube) {
  Voxels voxels;
  for_each_way(kSide - 1, [&](glm::ivec3 way) {
    const Voxels expected = oracle(GetParam(), way);
    for (int z = std::max(0, -way.z); z < std::min(kSide, kSide - way.z); ++z) {
      for (int y = std::max(0, -way.y); y < std::min(kSide, kSide - way.y); ++y) {
        for (int x = std::max(0, -way.x); x < std::min(kSide, kSide - way.x); ++x) {
          const glm::ivec3 from(x, y, z);
          voxels.clear();
          GetParam().draw(from, from + way, voxels);
          ASSERT_TRUE(std::equal(voxels.begin(), voxels.end(), expected.begin(), expected.end(),
                                 [&](glm::ivec3 a, glm::ivec3 b) { return a == b + from; }))
              << text(from, from + way);
        }
      }
    }
  });
}

TEST_P(Lines, KeepTheirLawsInACube) {
  for_each_way(kSide - 1, [&](glm::ivec3 way) {
    const glm::ivec3 from(0);
    const Voxels voxels = draw(from, way);
    ASSERT_EQ(broken_law(GetParam(), from, way, voxels), "") << text(from, way);
    const VoxelSet set(voxels.begin(), voxels.end());
    ASSERT_EQ(set.size(), voxels.size()) << "a voxel twice, " << text(from, way);
    const auto connected = connectivity(set);
    ASSERT_TRUE(connected.has_value());
    ASSERT_LE(*connected, GetParam().connectivity) << text(from, way);
    if (GetParam().connectivity == Adjacency::face) {
      ASSERT_EQ(local_connectivity(set), Adjacency::face) << "thesis 2.1, " << text(from, way);
    }
  });
}

TEST_P(Lines, AreTheSameFromEitherEnd) {
  for_each_way(kSide - 1, [&](glm::ivec3 way) {
    Voxels back = draw(way, {0, 0, 0});
    std::reverse(back.begin(), back.end());
    ASSERT_EQ(draw({0, 0, 0}, way), back) << text(way);
  });
}

// Sides of the cube spread evenly over the orders of magnitude up to 1024.
struct RandomSegments {
  std::mt19937 random{19920117};

  std::pair<glm::ivec3, glm::ivec3> operator()() {
    const double exponent = std::uniform_real_distribution<double>(1, 10)(random);
    std::uniform_int_distribution<int> within(0, static_cast<int>(std::exp2(exponent)) - 1);
    const auto pick = [&] { return within(random); };
    const glm::ivec3 from(pick(), pick(), pick());
    return {from, {pick(), pick(), pick()}};
  }
};

TEST_P(Lines, KeepTheirLawsOnAMillionRandomSegments) {
  RandomSegments segments;
  Voxels voxels, back;
  for (int i = 0; i < 1000000; ++i) {
    const auto [from, to] = segments();
    voxels.clear();
    GetParam().draw(from, to, voxels);
    const std::string broken = broken_law(GetParam(), from, to, voxels);
    ASSERT_EQ(broken, "") << text(from, to);
    if (i % 8 == 0) {
      back.clear();
      GetParam().draw(to, from, back);
      ASSERT_TRUE(std::equal(voxels.begin(), voxels.end(), back.rbegin(), back.rend()))
          << text(from, to) << " from the other end";
    }
  }
}

TEST_P(Lines, KeepTheirLawsAtTheLargestCoordinates) {
  constexpr int kFar = kMaxCoordinate;
  const glm::ivec3 corners[] = {{-kFar, -kFar, -kFar}, {kFar, kFar, kFar},      {kFar, kFar - 1, 0},
                                {-kFar, 1, -kFar + 1}, {kFar - 1, -kFar, kFar}, {0, kFar, 1}};
  for (const glm::ivec3 from : corners) {
    for (const glm::ivec3 to : corners) {
      const Voxels voxels = draw(from, to);
      ASSERT_EQ(broken_law(GetParam(), from, to, voxels), "") << text(from, to);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Chapter2, Lines, testing::ValuesIn(kAlgorithms), [](const auto& instance) {
  std::string name = instance.param.name;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
});

// Beyond its target too: the light's rays go on until they meet something.
TEST(DigitalLine, FollowsTheNearestInteger) {
  for (int distance = 1; distance <= 13; ++distance) {
    for (int target = -distance; target <= distance; ++target) {
      DigitalLine line(target, distance);
      int offset = 0;
      for (int step = 1; step <= 3 * distance; ++step) {
        offset += line.advance();
        ASSERT_EQ(offset, nearest_ties_down(Rational(target * step, distance)))
            << "target " << target << " of " << distance << ", step " << step;
      }
    }
  }
}

}  // namespace
}  // namespace rc2::lines
