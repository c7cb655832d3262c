// What rtl/rc2_pkg.sv states that stands in C++ too, and that no register of the machine tells.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

#include "sw/cycle/classes.h"
#include "sw/cycle/stop_table.h"
#include "sw/cycle/tilt.h"
#include "sw/facet/packet.h"
#include "sw/machine/host_word.h"
#include "sw/machine/word.h"
#include "sw/rays/ray.h"

namespace rc2::cycle {
namespace {

std::string source(const std::string& name) {
  std::ifstream file(RC2_SOURCE_DIR "/rtl/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string package() { return source("rc2_pkg.sv"); }

// The package states the longest list for each LMAX: "(LMAX < 12) ? 2" and so on.
TEST(Classes, AreAsManyAsTheHardwareHasRoomFor) {
  constexpr int kTried = 340;
  const std::string text = package();
  const std::regex entry(R"(\(LMAX < (\d+)\) \? (\d+))");
  int most = 0, distance = 1, entries = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), entry), end; it != end; ++it) {
    const int limit = std::stoi((*it)[1]), room = std::stoi((*it)[2]);
    if (limit > kTried) break;
    for (; distance < limit; ++distance) {
      most = std::max(most, Classes(distance, std::min(distance, 60)).most());
      ASSERT_EQ(most, room) << "L " << distance;
    }
    ++entries;
  }
  EXPECT_GE(entries, 12);
}

TEST(StopTable, IsAsLongAsInTheHardware) {
  std::smatch found;
  const std::string text = package();
  ASSERT_TRUE(
      std::regex_search(text, found, std::regex(R"(RUNS = \(N > (\d+)\) \? (\d+) : (\d+);)")));
  const int side = std::stoi(found[1]);
  EXPECT_EQ(std::stoi(found[2]), table_runs(side + 1));
  EXPECT_EQ(std::stoi(found[3]), table_runs(side));
}

TEST(Tilt, HasTheHardwaresBitsAndDividesInItsSteps) {
  const std::string text = package(), unit = source("lanes/rc2_extents.sv");
  std::smatch fraction, whole, step;
  ASSERT_TRUE(std::regex_search(text, fraction, std::regex(R"(TiltFracW = CoordW \+ (\d+);)")));
  ASSERT_TRUE(std::regex_search(text, whole, std::regex(R"(TiltSizeW = TiltFracW \+ (\d+);)")));
  ASSERT_TRUE(std::regex_search(unit, step, std::regex(R"(\.Step *\((\d+)\))")));
  for (int n = 2; n <= 1024; n *= 2) {
    const int bits = coordinate_bits(n) + std::stoi(fraction[1]) + std::stoi(whole[1]);
    const int cycles = (bits + std::stoi(step[1]) - 1) / std::stoi(step[1]);
    EXPECT_EQ(Tilt(n).most(), (1 << bits) - 1);
    EXPECT_EQ(Tilt(n).divided(), 2 * cycles + 2);
  }
}

// All named codes of the package: "localparam logic [2:0] KindHead = 3'd0;" and so on.
std::map<std::string, int> codes() {
  std::map<std::string, int> found;
  const std::string text = package();
  const std::regex entry(
      R"(localparam logic \[\d+:0\] ((?:Kind|Read|Layer|Surface|Sort|Body)\w+) = \d'd(\d+);)");
  for (std::sregex_iterator it(text.begin(), text.end(), entry), end; it != end; ++it) {
    found[(*it)[1]] = std::stoi((*it)[2]);
  }
  return found;
}

template <typename Code>
int number(Code code) {
  return static_cast<int>(code);
}

TEST(Codes, AreTheHardwares) {
  const std::map<std::string, int> expected{
      {"KindHead", number(WordKind::head)},
      {"KindSlab", number(WordKind::slab)},
      {"KindSide", number(WordKind::side)},
      {"KindGap", number(WordKind::gap)},
      {"KindRead", number(WordKind::read)},
      {"KindData", number(WordKind::data)},
      {"KindEnd", number(WordKind::end)},
      {"KindRay", number(WordKind::ray)},
      {"ReadVoxels", number(ReadWhat::voxels)},
      {"ReadLight", number(ReadWhat::light)},
      {"ReadCounters", number(ReadWhat::counters)},
      {"ReadLayers", number(ReadWhat::layers)},
      {"ReadEnds", number(ReadWhat::ends)},
      {"ReadHits", number(ReadWhat::hits)},
      {"LayerArmour", number(facet::Layer::armour)},
      {"LayerShown", number(facet::Layer::shown)},
      {"LayerInside", number(facet::Layer::inside)},
      {"LayerGuard", number(facet::Layer::guard)},
      {"SurfaceSolid", number(facet::Surface::solid)},
      {"SurfaceSheet", number(facet::Surface::sheet)},
      {"SurfaceCrowd", number(facet::Surface::crowd)},
      {"SortNormal", number(RaySort::normal)},
      {"SortShares", number(RaySort::shares)},
      {"SortOrigin", number(RaySort::origin)},
      {"SortDirection", number(RaySort::direction)},
      {"BodyRoom", number(rays::Body::room)},
      {"BodySheet", number(rays::Body::sheet)},
  };
  EXPECT_EQ(codes(), expected);
}

}  // namespace
}  // namespace rc2::cycle
