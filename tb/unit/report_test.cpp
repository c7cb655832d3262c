#include "sw/report/report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <tuple>

#include "sw/report/compare.h"
#include "sw/report/dump.h"
#include "sw/report/laws.h"

namespace rc2::report {
namespace {

using Json = nlohmann::json;
using Voxel = std::tuple<int, int, int>;  // z, y, x
using Row = std::vector<std::uint32_t>;   // facet, light0, light1, ...
using Rows = std::map<Voxel, Row>;

// Core and gap follow from the number, so that they differ only where it does.
Claim claim_of(std::uint32_t facet) {
  return {facet, facet % 2 == 1, static_cast<int>(facet * 29 % 64) - 32};
}

Memories memories_of(const Rows& rows, std::size_t lights) {
  Memories memories;
  memories.lights.resize(lights);
  for (const auto& [key, row] : rows) {
    const auto [z, y, x] = key;
    memories.voxels.push_back({{x, y, z}, claim_of(row.at(0))});
    for (std::size_t k = 0; k < lights; ++k) memories.lights[k].push_back(row.at(k + 1));
  }
  return memories;
}

Rows random_rows(std::mt19937& random, std::size_t lights) {
  const auto below = [&](std::uint32_t count) {
    return std::uniform_int_distribution<std::uint32_t>(0, count - 1)(random);
  };
  Rows rows;
  const std::uint32_t count = below(40);
  for (std::uint32_t i = 0; i < count; ++i) {
    Row row = {below(kMaxFacets)};
    for (std::size_t k = 0; k < lights; ++k) row.push_back(static_cast<std::uint32_t>(random()));
    rows[{below(kMaxSide), below(4), below(4)}] = row;
  }
  return rows;
}

class Csv : public testing::Test {
 protected:
  Csv()
      : path_((std::filesystem::temp_directory_path() /
               (std::string("rc2_report_test_") +
                testing::UnitTest::GetInstance()->current_test_info()->name() +
                std::to_string(getpid()) + ".csv"))
                  .string()) {}
  ~Csv() override { std::filesystem::remove(path_); }

  Memories read(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return read_csv(path_);
  }

  std::string complaint(const std::string& text) {
    try {
      read(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }

  std::string path_;
};

TEST_F(Csv, HasTheHeaderAndTheRowsOfItsDefinition) {
  const Rows rows = {{{2, 1, 0}, {8, 5, 0}}, {{0, 3, 1}, {9, 4294967295, 1}}};
  EXPECT_EQ(to_csv(memories_of(rows, 2)),
            "x,y,z,facet,core,gap,light0,light1\n1,3,0,9,1,-27,4294967295,1\n0,1,2,8,0,8,5,0\n");
  EXPECT_EQ(to_csv({}), "x,y,z,facet,core,gap\n");
}

TEST_F(Csv, ReadsBackWhatWasWritten) {
  std::mt19937 random(5);
  for (std::size_t trial = 0; trial < 60; ++trial) {
    const std::size_t lights = trial % 4;
    const Memories wrote = memories_of(random_rows(random, lights), lights);
    const Memories read_back = read(to_csv(wrote));
    EXPECT_EQ(read_back.lights, wrote.lights);
    ASSERT_EQ(read_back.voxels.size(), wrote.voxels.size());
    for (std::size_t i = 0; i < wrote.voxels.size(); ++i) {
      EXPECT_EQ(read_back.voxels[i].at, wrote.voxels[i].at);
      EXPECT_EQ(read_back.voxels[i].owner.packed(), wrote.voxels[i].owner.packed());
    }
  }
}

TEST_F(Csv, NamesFileAndLineOfWhatItCannotRead) {
  const std::string good = "x,y,z,facet,core,gap,light0\n1,2,3,4,0,0,5\n";
  ASSERT_EQ(complaint(good), "accepted");
  const std::vector<std::pair<std::string, int>> bad = {
      {"", 1},
      {"\n", 1},
      {"x,y,z\n", 1},
      {"x,y,z,facet,core,gap,light1\n", 1},
      {"1,2,3,4,0,0\n", 1},
      {good + "\n", 3},
      {good + "2,2,3,4,0,0\n", 3},
      {good + "2,2,3,4,0,0,5,6\n", 3},
      {good + "2,2,3,4,0,0,\n", 3},
      {good + "2,2,3,4,0,0,5 \n", 3},
      {good + "2,2,3,4,0,0,five\n", 3},
      {good + "2,2,3,4,0,0,-5\n", 3},
      {good + "2,2,3,4,0,0,4294967296\n", 3},
      {good + "2,2,3,4,2,0,5\n", 3},
      {good + "2,2,3,4,0,64,5\n", 3},
      {good + "2,2,3,4,0,-65,5\n", 3},
      {good + "2,2,3,1048576,0,0,5\n", 3},
      {good + "1024,2,3,4,0,0,5\n", 3},
      {good + "1,2,3,4,0,0,5\n", 3},
      {good + "0,2,3,4,0,0,5\n", 3},
      {good + "9,1,3,4,0,0,5\n", 3},
      {good + "9,9,2,4,0,0,5\n", 3},
      {good + "2,2,3,4,1,-64,5\n0,0,0,0,0,0,0\n", 4},
  };
  for (const auto& [text, line] : bad) {
    const std::string message = complaint(text);
    EXPECT_EQ(message.rfind(path_ + ": line " + std::to_string(line) + ": ", 0), 0U)
        << message << "\nof\n"
        << text;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  std::filesystem::remove(path_);
  EXPECT_THROW(read_csv(path_), Error);
  EXPECT_THROW(read_csv(std::filesystem::temp_directory_path().string()), Error);
}

TEST(Compare, FindsOwnersThatDifferInTheirClaimOnly) {
  const Memories all = memories_of({{{0, 0, 0}, {3}}, {{0, 0, 1}, {3}}, {{0, 0, 2}, {3}}}, 0);
  Memories other = all;
  other.voxels[0].owner.core = !other.voxels[0].owner.core;
  other.voxels[2].owner.gap = 31;
  const Comparison comparison = compare(all, other);
  EXPECT_EQ(comparison.owners_differing, 2);
  ASSERT_EQ(comparison.first.size(), 2U);
  EXPECT_EQ(to_string(comparison.first[0]), "voxel (0,0,0), core: expected 1, got 0");
  EXPECT_EQ(to_string(comparison.first[1]), "voxel (2,0,0), gap: expected -9, got 31");
}

TEST(Compare, CountsLikeASearchInTwoMaps) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t left_lights = random() % 3, right_lights = random() % 3;
    const Rows left = random_rows(random, left_lights);
    Rows right = random_rows(random, right_lights);
    for (const auto& [at, row] : left) {  // mostly the same voxels, some changed values
      if (random() % 8 == 0) continue;
      Row copy = row;
      copy.resize(right_lights + 1, 17);
      if (random() % 4 == 0) copy[random() % copy.size()] ^= 1;
      right[at] = copy;
    }

    Comparison expected;
    std::vector<std::tuple<Voxel, std::string>> places;
    Rows all = left;
    all.insert(right.begin(), right.end());
    for (const auto& [at, ignored] : all) {
      if (left.count(at) != right.count(at)) {
        ++expected.voxels_differing;
        places.emplace_back(at, "facet");
        continue;
      }
      const Row &l = left.at(at), &r = right.at(at);
      for (std::size_t k = 0; k < std::max(l.size(), r.size()); ++k) {
        if (k < l.size() && k < r.size() && l[k] == r[k]) continue;
        ++(k == 0 ? expected.owners_differing : expected.lights_differing);
        places.emplace_back(at, k == 0 ? "facet" : "light" + std::to_string(k - 1));
      }
    }

    const Comparison result =
        compare(memories_of(left, left_lights), memories_of(right, right_lights));
    EXPECT_EQ(result.voxels_differing, expected.voxels_differing);
    EXPECT_EQ(result.owners_differing, expected.owners_differing);
    EXPECT_EQ(result.lights_differing, expected.lights_differing);
    EXPECT_EQ(result.equal(), places.empty());
    ASSERT_EQ(result.first.size(), std::min(places.size(), kFirstDifferences));
    for (std::size_t i = 0; i < result.first.size(); ++i) {
      const Difference& difference = result.first[i];
      const glm::ivec3 at = difference.at;
      EXPECT_EQ(std::make_tuple(Voxel(at.z, at.y, at.x), difference.what), places[i]);
      EXPECT_NE(difference.expected, difference.got);
    }
  }
}

TEST(Compare, SaysWhatDiffers) {
  EXPECT_EQ(to_string({{1, 2, 3}, "light0", 5, 4}), "voxel (1,2,3), light0: expected 5, got 4");
  EXPECT_EQ(to_string({{1, 2, 3}, "facet", std::nullopt, 4}),
            "voxel (1,2,3), facet: expected none, got 4");
}

class Laws : public testing::Test {
 protected:
  bool voxels_hold() const {
    return holds([&] { check_voxels(voxels_, 4, 10); });
  }
  bool light_holds() const {
    return holds([&] { check_light(result_, counts_, job_, voxels_.size()); });
  }

  static bool holds(const std::function<void()>& law) {
    try {
      law();
      return true;
    } catch (const std::logic_error&) {
      return false;
    }
  }

  VoxelMemory voxels_ = {{{3, 0, 0}, {9}}, {{0, 1, 0}, {0}}, {{0, 0, 2}, {4}}};
  LightJob job_{{1, 1, 1}, 2, 4};
  LightMemory counts_ = {10, 0, 5};
  LightResult result_{0, 0, 0, 0, 0, 0, {98, 15, 80, 3}};  // 24 * 2^2 + 2 targets
};

TEST_F(Laws, HoldForAMachineThatIsRight) {
  EXPECT_TRUE(voxels_hold());
  EXPECT_TRUE(light_holds());
  EXPECT_TRUE(holds([] { check_voxels({}, 4, 0); }));
}

TEST_F(Laws, FindAVoxelOutsideTheCube) {
  voxels_.back().at.x = 4;
  EXPECT_FALSE(voxels_hold());
  voxels_.back().at.x = -1;
  EXPECT_FALSE(voxels_hold());
}

TEST_F(Laws, FindAFacetThatWasNeverLoaded) {
  voxels_.back().owner.facet = 10;
  EXPECT_FALSE(voxels_hold());
}

TEST_F(Laws, FindVoxelsOutOfOrder) {
  std::swap(voxels_[0], voxels_[1]);
  EXPECT_FALSE(voxels_hold());
  voxels_[0] = voxels_[1];
  EXPECT_FALSE(voxels_hold());
}

TEST_F(Laws, FindALostTarget) {
  --result_.targets.escaped;
  EXPECT_FALSE(light_holds());
}

TEST_F(Laws, FindTargetsThatWereNeverSent) {
  --result_.targets.escaped;
  --result_.targets.total;
  EXPECT_FALSE(light_holds());
}

TEST_F(Laws, FindVoxelsThatCountOtherThanAbsorbed) {
  ++counts_[1];
  EXPECT_FALSE(light_holds());
  --counts_[1];
  counts_.push_back(0);
  EXPECT_FALSE(light_holds());
}

Report sample() {
  Report report;
  report.scene = "room";
  report.fit = "none";
  report.machine = "cycle";
  report.rule = "armoured";
  report.light_rule = "thesis";
  report.mode = "fast";
  report.hop_stages = 2;
  report.n = 8;
  report.fraction_bits = 4;
  report.target_distance = 2;
  report.fa = 3;
  report.facets = {20, 1, 19, 1, 2};
  report.ignored = {4, 5, 6};
  report.lights = {3, 2, 1, false};
  report.voxels = 64;
  report.load = {123};
  report.feeders = 2;
  report.load_words = 101;
  report.sources = {{{1, 2, 3}, {1, 0.95F, 0.25F}, {40, 50, 60, 70, 8, 2, {98, 15, 80, 3}}, 12},
                    {{4, 5, 6}, {1, 1, 1}, {41, 51, 61, 71, 9, 3, {98, 90, 8, 0}}, 13}};
  report.reference = "golden";
  report.seconds = {{"scene", 0.25}, {"load", 1.5}};
  report.written = {{"report", "out/report.json"}};
  report.commit = "abc";
  report.tools = {{"assimp", "5.2"}};
  return report;
}

TEST(ReportJson, HoldsEveryFact) {
  const Json json = Json::parse(to_json(sample()));
  const Json expected = Json::parse(R"({
    "scene": "room", "fit": "none", "machine": "cycle", "n": 8, "fraction_bits": 4,
    "rule": "armoured", "light_rule": "thesis", "mode": "fast", "L": 2, "fa": 3, "feeders": 2, "load_words": 101,
    "facets": {"read": 20, "triangulated": 1, "loaded": 19, "degenerate": 1, "outside": 2},
    "ignored": {"primitives": 4, "lights": 5, "textures": 6},
    "lights": {"read": 3, "used": 2, "outside": 1, "default": false},
    "cycles": {"load": 123, "prepare": [40, 41], "light": [50, 51], "home": [60, 61], "hop_stages": 2},
    "voxels": 64, "lit": [12, 13],
    "beams": {"visits": 141, "merged": 17, "max_queue": 3},
    "targets": {"total": 196, "absorbed": 105, "escaped": 88, "skipped": 3},
    "sources": [
      {"voxel": [1, 2, 3], "colour": [1.0, 0.95, 0.25], "prepare_cycles": 40, "cycles": 50, "home_cycles": 60, "lit": 12,
       "beams": {"visits": 70, "merged": 8, "max_queue": 2},
       "targets": {"total": 98, "absorbed": 15, "escaped": 80, "skipped": 3}},
      {"voxel": [4, 5, 6], "colour": [1.0, 1.0, 1.0], "prepare_cycles": 41, "cycles": 51, "home_cycles": 61, "lit": 13,
       "beams": {"visits": 71, "merged": 9, "max_queue": 3},
       "targets": {"total": 98, "absorbed": 90, "escaped": 8, "skipped": 0}}],
    "agreement": {"reference": "golden", "voxels_differing": 0, "owners_differing": 0,
                  "lights_differing": 0, "first": []},
    "seconds": {"scene": 0.25, "load": 1.5},
    "files": {"report": "out/report.json"}, "commit": "abc", "tools": {"assimp": "5.2"}})");
  EXPECT_EQ(json, expected) << Json::diff(expected, json).dump(1);
}

TEST(ReportJson, ShowsTheFirstDifferences) {
  Report report = sample();
  report.agreement = {
      1, 0, 1, {{{1, 2, 3}, "facet", 4, std::nullopt}, {{5, 6, 7}, "light1", 8, 9}}};
  const Json agreement = Json::parse(to_json(report)).at("agreement");
  EXPECT_EQ(agreement.at("voxels_differing"), 1);
  EXPECT_EQ(agreement.at("lights_differing"), 1);
  EXPECT_EQ(agreement.at("first"), Json::parse(R"([
    {"voxel": [1, 2, 3], "what": "facet", "expected": 4, "got": null},
    {"voxel": [5, 6, 7], "what": "light1", "expected": 8, "got": 9}])"));
}

TEST(ReportJson, TakesAPathThatIsNotUtf8) {
  Report report = sample();
  report.scene = "caf\xE9.obj";
  EXPECT_TRUE(Json::accept(to_json(report)));
}

TEST(ReportText, SaysThatTheModelsAgree) {
  const std::string text = to_text(sample());
  EXPECT_NE(text.find("every voxel, owner and target count as in the golden model"),
            std::string::npos);
  EXPECT_EQ(text.find("DISAGREES"), std::string::npos);
  EXPECT_EQ(text.substr(text.size() - 16), "out/report.json\n");
}

TEST(ReportText, CountsWhatWasLeftOut) {
  const std::string text = to_text(sample());
  for (const char* fact :
       {"1 polygons split", "1 facets without area", "2 facets outside", "4 points and lines",
        "5 lights without a place", "6 textures", "1 outside the cube skipped"}) {
    EXPECT_NE(text.find(fact), std::string::npos) << fact << " is not in\n" << text;
  }
}

TEST(ReportText, ShowsTheFirstDifferences) {
  Report report = sample();
  report.agreement = {0, 0, 1, {{{5, 6, 7}, "light1", 8, 9}}};
  const std::string text = to_text(report);
  EXPECT_NE(text.find("DISAGREES   with the golden model: 0 voxels, 0 owners, 1 counts"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("voxel (5,6,7), light1: expected 8, got 9"), std::string::npos) << text;
  EXPECT_EQ(text.find("every voxel"), std::string::npos);
}

TEST(ReportText, LeavesOutWhatAMachineWithoutClockDoesNotHave) {
  Report report = sample();
  report.machine = "golden";
  const std::string text = to_text(report);
  EXPECT_EQ(text.find("cycles"), std::string::npos) << text;
  EXPECT_EQ(text.find("deepest"), std::string::npos) << text;
  EXPECT_NE(text.find("this is the golden model itself"), std::string::npos) << text;
}

}  // namespace
}  // namespace rc2::report
