// The network of rays against golden: every hit, whatever the depth of the queues, and none stuck.
#include <gtest/gtest.h>

#include <iostream>
#include <memory>

#include "sw/cycle/cycle_machine.h"
#include "sw/facet/layers.h"
#include "sw/facet/optics.h"
#include "sw/golden/golden_machine.h"
#include "sw/report/laws.h"
#include "tb/unit/random_rays.h"

namespace rc2 {
namespace {

constexpr int kFraction = 6;

class Pair {
 public:
  Pair(const std::string& scene, int n, const RayUnits& units = {})
      : Pair(scene::generate(scene, n), n, units) {}
  Pair(const scene::Scene& scene, int n, const RayUnits& units)
      : facets_(facet::build_layers(scene, n, kFraction)),
        optics_(facet::find_optics(facets_.facets, scene.materials)),
        golden_(config(n)),
        cycle_(config(n, units)) {
    golden_.load(facets_.packets, {});
    cycle_.load(facets_.packets, {});
  }

  // Every facet mirrors and, if it is a solid's, half of the light goes through.
  void make_lively(double index = 1.5) {
    for (rays::Facet& facet : optics_) {
      facet.mirror = facet.body == rays::Body::solid ? 128 : 256;
      facet.clear = static_cast<std::uint16_t>(256 - facet.mirror);
      facet.enter = static_cast<std::uint16_t>(rays::kIndexOne / index);
      facet.leave = static_cast<std::uint16_t>(rays::kIndexOne * index);
    }
  }

  VoxelMemory voxels() { return golden_.read_voxels(); }

  RayTraffic compare(int depth, int queue, const std::vector<RayStart>* starts = nullptr) {
    const RayJob job{{depth, 16}, &optics_, starts, queue};
    const RayResult want = golden_.trace(job, {}), have = cycle_.trace(job, {});
    report::check_rays(have);
    EXPECT_EQ(want.hits.size(), have.hits.size());
    EXPECT_TRUE(want.hits == have.hits);
    EXPECT_TRUE(want.counts == have.counts);
    const RayTraffic& traffic = have.traffic;
    EXPECT_EQ(traffic.answers, have.counts.total());
    EXPECT_GE(traffic.cycles, std::max(traffic.busiest().cycles, traffic.latency));
    return traffic;
  }

 private:
  static MachineConfig config(int n, const RayUnits& units = {}) {
    MachineConfig config;
    config.n = n;
    config.fraction_bits = kFraction;
    config.ray_units = units;
    return config;
  }

  facet::FacetSet facets_;
  std::vector<rays::Facet> optics_;
  golden::GoldenMachine golden_;
  cycle::CycleMachine cycle_;
};

TEST(RayArray, HitsWhatGoldenHits) {
  for (const char* scene : {"gallery", "room", "ball:9", "shells:10:1", "dust:3:1", "empty"}) {
    for (const int queue : {1, 2, 4}) {
      SCOPED_TRACE(scene);
      Pair(scene, 24).compare(4, queue);
    }
  }
}

TEST(RayArray, DoesNotBlockWithQueuesOneDeepWhereEverythingMirrors) {
  for (const char* scene : {"gallery", "shells:8:2", "dust:5:3", "room"}) {
    for (const int n : {9, 16, 28}) {
      Pair pair(scene, n);
      pair.make_lively();
      for (const int depth : {2, rays::kMaxDepth}) {
        SCOPED_TRACE(scene + std::to_string(n));
        pair.compare(depth, 1);
      }
    }
  }
}

// Also in the middle of facets, along them, and in glass that lets nothing out: what a hit in glass
// sends on starts inside.
TEST(RayArray, DoesNotBlockWhereRaysStartAnywhereInAnyDirection) {
  const int n = 20;
  std::vector<std::unique_ptr<Pair>> pairs;
  for (const RayUnits units : {RayUnits{1, 1}, RayUnits{4, 2}})
    for (const char* scene : {"shells:15:4", "gallery", "dust:6:3", "ball:8"})
      pairs.push_back(std::make_unique<Pair>(scene, n, units));
  std::int64_t rays = 0;
  for (std::uint64_t seed = 1; seed <= ray_rounds(8); ++seed) {
    SCOPED_TRACE(seed);
    Pair& pair = *pairs[seed % pairs.size()];
    pair.make_lively(seed % 3 == 0 ? 4 : 1.5);
    const int depth = seed % 2 == 0 ? rays::kMaxDepth : 5;
    const std::vector<RayStart> starts = random_starts(seed, n, pair.voxels());
    const RayTraffic traffic = pair.compare(depth, seed % 5 == 4 ? 3 : 1, &starts);
    EXPECT_GT(traffic.run_on, 0);
    EXPECT_GT(traffic.hops, 0);
    // A home may have every ray of a tree to start again, and no more.
    EXPECT_LE(traffic.max_stack, 1 << depth);
    rays += traffic.answers;
    if (::testing::Test::HasFailure()) break;
  }
  std::cout << rays << " rays\n";
}

// All rays of a picture start in one cell: an eye in the cube.
TEST(RayArray, DoesNotBlockWhereAllRaysStartInOneCell) {
  const int n = 16;
  Pair pair("gallery", n);
  pair.make_lively();
  std::vector<RayStart> starts = random_starts(9, n);
  for (RayStart& start : starts) start.origin = rays::kPlaceOne * glm::ivec3(n / 2, n / 2, 12);
  for (const int queue : {1, 4}) {
    const RayTraffic traffic = pair.compare(3, queue, &starts);
    EXPECT_GE(traffic.cycles, n * n) << "a cell begins a ray a cycle at most";
  }
}

// More units in a cell change when things happen, not what happens.
TEST(RayArray, MoreUnitsDoTheSameInLessTime) {
  const auto trace = [](const RayUnits& units) {
    Pair pair("gallery", 32, units);
    pair.make_lively();
    return pair.compare(4, 1);
  };
  const RayTraffic one = trace({1, 1});
  for (const RayUnits units : {RayUnits{2, 1}, RayUnits{1, 2}, RayUnits{2, 2}, RayUnits{4, 2}}) {
    SCOPED_TRACE(std::to_string(units.looks) + std::to_string(units.arithmetic));
    const RayTraffic more = trace(units);
    EXPECT_EQ(more.work, one.work);
    EXPECT_EQ(more.hops, one.hops);
    EXPECT_EQ(more.busiest().cycles < one.busiest().cycles, units.arithmetic == 2);
  }
  EXPECT_LT(trace({4, 2}).cycles, one.cycles);
}

TEST(RayArray, RaysWaitLessInDeeperQueues) {
  Pair pair("gallery", 32);
  const RayTraffic narrow = pair.compare(4, 1), wide = pair.compare(4, 8);
  EXPECT_LT(wide.waits, narrow.waits);
  EXPECT_LE(wide.sent_again, narrow.sent_again);
  EXPECT_EQ(wide.latency, narrow.latency) << "what would be if nothing waited";
  EXPECT_EQ(wide.hops, narrow.hops);
}

TEST(RayArray, NothingTravelsWhereNothingMirrors) {
  Pair pair("ball:6", 16);
  const RayTraffic traffic = pair.compare(4, 1);
  EXPECT_EQ(traffic.hops, 0);
  EXPECT_EQ(traffic.sent_again, 0);
  EXPECT_EQ(traffic.answers, 256);
}

}  // namespace
}  // namespace rc2
