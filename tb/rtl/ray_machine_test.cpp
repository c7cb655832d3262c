// Rays on the Verilated array: every hit as golden has it, bit for bit, and none lost, however deep
// the queues are; every count and the cycles as the cycle model has them.
#include <gtest/gtest.h>

#include <iostream>
#include <tuple>

#include "sim/rtl_machine.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/facet/layers.h"
#include "sw/facet/optics.h"
#include "sw/golden/golden_machine.h"
#include "sw/report/laws.h"
#include "tb/unit/random_rays.h"

namespace rc2 {
namespace {

constexpr int kFraction = 6;

std::unique_ptr<Machine> make_rtl(int n) {
  return make_rtl_machine("rays_n" + std::to_string(n), {});
}

class Pair {
 public:
  Pair(Machine& rtl, const std::string& scene)
      : Pair(rtl, scene::generate(scene, rtl.config().n)) {}
  Pair(Machine& rtl, const scene::Scene& scene)
      : rtl_(rtl),
        facets_(facet::build_layers(scene, rtl.config().n, kFraction)),
        optics_(facet::find_optics(facets_.facets, scene.materials)),
        golden_(rtl.config()),
        cycle_(rtl.config()) {
    golden_.load(facets_.packets, {});
    cycle_.load(facets_.packets, {});
    rtl_.load(facets_.packets, {});
  }

  // Facets of every kind: mirrors, glass, both, and dull ones.
  void shuffle_optics(std::uint64_t seed) {
    scene::Random random(seed);
    for (rays::Facet& facet : optics_) {
      facet.mirror = static_cast<std::uint16_t>(64 * random.below(5));
      facet.clear = static_cast<std::uint16_t>(rays::kShareOne - facet.mirror);
      facet.enter = static_cast<std::uint16_t>(rays::kIndexOne * 2 / (2 + random.below(3)));
      facet.leave = static_cast<std::uint16_t>(rays::kIndexOne * (2 + random.below(3)) / 2);
    }
  }

  VoxelMemory voxels() { return golden_.read_voxels(); }

  RayTraffic compare(const rays::Limits& limits, int queue,
                     const std::vector<RayStart>* starts = nullptr) {
    const RayJob job{limits, &optics_, starts, queue};
    const RayResult want = golden_.trace(job, {}), have = rtl_.trace(job, {});
    report::check_rays(have);
    EXPECT_EQ(want.hits.size(), have.hits.size());
    for (std::size_t i = 0; i < std::min(want.hits.size(), have.hits.size()); ++i) {
      if (want.hits[i] == have.hits[i]) continue;
      const RayHit &a = want.hits[i], &b = have.hits[i];
      ADD_FAILURE() << "pixel " << a.ray.home.x << "," << a.ray.home.y << " node "
                    << int{a.ray.node} << " facet " << a.facet << " and node " << int{b.ray.node}
                    << " facet " << b.facet;
      break;
    }
    EXPECT_TRUE(want.counts == have.counts);
    const RayTraffic is = have.traffic, ought = cycle_.trace(job, {}).traffic;
    EXPECT_EQ(is.cycles, ought.cycles);
    EXPECT_EQ(is.load_cycles, ought.load_cycles);
    EXPECT_EQ(is.work, ought.work);
    EXPECT_EQ(is.hops, ought.hops);
    EXPECT_EQ(is.answers, ought.answers);
    EXPECT_EQ(is.run_on, ought.run_on);
    EXPECT_EQ(is.sent_again, ought.sent_again);
    return is;
  }

 private:
  Machine& rtl_;
  facet::FacetSet facets_;
  std::vector<rays::Facet> optics_;
  golden::GoldenMachine golden_;
  cycle::CycleMachine cycle_;
};

constexpr int kSizes[] = RC2_RAY_SIZES;

class RayScenes : public ::testing::TestWithParam<std::tuple<int, const char*>> {};

TEST_P(RayScenes, HitWhatGoldenHits) {
  const auto [n, scene] = GetParam();
  const std::unique_ptr<Machine> rtl = make_rtl(n);
  Pair pair(*rtl, scene);
  pair.compare({4, 16}, 2);
  pair.compare({0, 1}, 1);
}

INSTANTIATE_TEST_SUITE_P(Sizes, RayScenes,
                         ::testing::Combine(::testing::ValuesIn(kSizes),
                                            ::testing::Values("gallery", "room", "ball:1.5",
                                                              "dust:8:1", "empty")),
                         [](const auto& test) {
                           const std::string scene = std::get<1>(test.param);
                           return "n" + std::to_string(std::get<0>(test.param)) + '_' +
                                  scene.substr(0, scene.find(':'));
                         });

class RayMachine : public ::testing::TestWithParam<int> {
 protected:
  std::unique_ptr<Machine> rtl_ = make_rtl(GetParam());
};

TEST_P(RayMachine, DoesNotBlockWhereRaysStartAnywhereInAnyDirection) {
  RayTraffic sum;
  for (const char* scene : {"gallery", "dust:6:3", "ball:1.5", "empty"}) {
    Pair pair(*rtl_, scene);
    for (std::uint64_t seed = 1; seed <= ray_rounds(8); ++seed) {
      SCOPED_TRACE(scene + std::to_string(seed));
      pair.shuffle_optics(seed);
      const std::vector<RayStart> starts = random_starts(seed, rtl_->config().n, pair.voxels());
      const int least = seed % 3 == 1 ? rays::kWeightOne / 3 : 16;
      const RayTraffic traffic = pair.compare({4, least}, seed % 3 == 0 ? 2 : 1, &starts);
      sum.answers += traffic.answers;
      sum.run_on += traffic.run_on;
      sum.sent_again += traffic.sent_again;
      sum.hops += traffic.hops;
    }
  }
  std::cout << sum.answers << " rays\n";
  EXPECT_GT(sum.run_on, 0);
  EXPECT_GT(sum.sent_again, 0);
  EXPECT_GT(sum.hops, 0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, RayMachine, ::testing::ValuesIn(kSizes));

}  // namespace
}  // namespace rc2
