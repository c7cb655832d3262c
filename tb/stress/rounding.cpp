#include "tb/stress/rounding.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "sw/base/config.h"
#include "sw/facet/traced.h"

namespace rc2::stress {
namespace {

using boost::multiprecision::cpp_int;

// floor(value * one + 1/2), the value taken apart into mantissa * 2^exponent.
std::int64_t nearest_unit(double value, std::int64_t one) {
  constexpr int kDigits = std::numeric_limits<double>::digits;
  int exponent = 0;
  const auto mantissa =
      static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), kDigits));
  exponent -= kDigits;
  // Over a common denominator; no coordinate is so large that its exponent were not negative.
  cpp_int half = 1;
  half <<= -exponent;
  const cpp_int denominator = 2 * half;
  const cpp_int numerator = 2 * cpp_int(mantissa) * one + half;
  cpp_int whole = numerator / denominator;
  if (whole * denominator > numerator) --whole;
  return static_cast<std::int64_t>(whole);
}

double nasty_coordinate(const Cube& cube, Dice& dice) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double unit = 1.0 / static_cast<double>(cube.one());
  const double low = static_cast<double>(cube.low()) * unit;
  const double high = static_cast<double>(cube.high()) * unit;
  double value = 0;
  switch (dice.roll(0, 3)) {
    case 0:
      value = 0;
      break;
    case 1:
      value = dice.one_in(2) ? low : high;
      break;
    default:
      value = (static_cast<double>(dice.roll(cube.low(), cube.high())) - 0.5) * unit;
  }
  for (std::int64_t steps = dice.roll(0, 2); steps > 0; --steps)
    value = std::nextafter(value, dice.one_in(2) ? infinity : -infinity);
  return std::min(std::max(value, low), high);
}

}  // namespace

std::int64_t check_rounding(std::uint64_t seed, std::int64_t trials, Findings& findings) {
  Tally& tally = findings.at("rounding of vertices", "beside half a unit, 0 and the ends");
  Dice dice(seed);
  constexpr int kTriangles = 50;
  for (std::int64_t trial = 0; trial < trials; ++trial) {
    const Cube cube{static_cast<int>(dice.roll(2, kMaxSide)),
                    static_cast<int>(dice.roll(0, kMaxFractionBits))};
    scene::Scene scene;
    scene.materials.resize(1);
    for (int i = 0; i < kTriangles; ++i) {
      std::vector<glm::dvec3> corners;
      for (int k = 0; k < 3; ++k) {
        const double x = nasty_coordinate(cube, dice), y = nasty_coordinate(cube, dice);
        corners.emplace_back(x, y, nasty_coordinate(cube, dice));
      }
      scene.add(corners, 0);
    }
    facet::Traced traced;
    build_facets(scene, cube.n, cube.fraction_bits, facet::Rule::armoured, traced);
    ++tally.trials;
    tally.facets += kTriangles;
    for (std::size_t i = 0; i < scene.vertices.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (traced.corners.at(i)[axis] != nearest_unit(scene.vertices[i][axis], cube.one()))
          ++tally.differences;
  }
  return tally.differences;
}

}  // namespace rc2::stress
