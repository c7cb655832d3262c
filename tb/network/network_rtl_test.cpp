// The emitted Verilog draws what the definition says, pixel by pixel of the whole octant.
#include <gtest/gtest.h>
#include <verilated.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "Vnetwork_bench.h"
#include "tb/unit/network_oracle.h"

namespace rc2::network {
namespace {

constexpr int kRadius = RC2_NETWORK_RADIUS;
constexpr int kColumns = RC2_NETWORK_COLUMNS;

using Drawings = std::vector<int>;

class NetworkRtl : public testing::Test {
 protected:
  void SetUp() override {
    context_ = std::make_unique<VerilatedContext>();
    bench_ = std::make_unique<Vnetwork_bench>(context_.get());
  }

  void TearDown() override { bench_->final(); }

  template <class Bus>
  static void drive(Bus& bus, const Drawings& drawings, int size) {
    for (int k = 0; k <= size; ++k) set_bit(bus, k, false);
    for (const int k : drawings) set_bit(bus, k, true);
  }

  void expect_drawn(const Drawings& circles, const Drawings& segments) {
    drive(bench_->circle, circles, kRadius);
    drive(bench_->segment, segments, kColumns);
    bench_->eval();
    compare_all(bench_->circles, {"star", "chain", "tree", "tree:4"}, kRadius, [&](glm::ivec2 at) {
      return std::any_of(circles.begin(), circles.end(),
                         [&](int radius) { return on_circle(radius, at); });
    });
    compare_all(bench_->segments, {"star", "chain", "tree", "tree:4", "nearest"}, kColumns,
                [&](glm::ivec2 at) {
                  return std::any_of(segments.begin(), segments.end(),
                                     [&](int s) { return on_segment(kColumns, s, at); });
                });
  }

 private:
  template <class Words>
  static void set_bit(Words& bus, int bit, bool value) {
    EData& word = bus[bit / 32];
    word = (word & ~(1U << bit % 32)) | (EData{value} << bit % 32);
  }

  template <class Outputs, class Predicate>
  static void compare_all(const Outputs& outputs, const std::vector<std::string>& schemes, int size,
                          Predicate is_lit) {
    for (std::size_t scheme = 0; scheme < schemes.size(); ++scheme) {
      SCOPED_TRACE(schemes[scheme]);
      compare(outputs[scheme], size, is_lit);
    }
  }

  template <class Words, class Predicate>
  static void compare(const Words& lit, int size, Predicate is_lit) {
    int bit = 0;
    for (int x = 0; x <= size; ++x) {
      for (int y = 0; y <= x; ++y, ++bit) {
        const bool got = (lit[bit / 32] >> bit % 32 & 1U) != 0;
        ASSERT_EQ(got, is_lit({x, y})) << "pixel " << x << ',' << y;
      }
    }
  }

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Vnetwork_bench> bench_;
};

TEST_F(NetworkRtl, DrawsNothingUnasked) { expect_drawn({}, {}); }

TEST_F(NetworkRtl, DrawsEveryCircleAndEverySegment) {
  for (int k = 0; k <= std::max(kRadius, kColumns); ++k) {
    expect_drawn(k <= kRadius ? Drawings{k} : Drawings{}, k <= kColumns ? Drawings{k} : Drawings{});
    if (HasFatalFailure()) FAIL() << "drawing " << k;
  }
}

TEST_F(NetworkRtl, DrawsSeveralAtOnce) {
  std::mt19937 random(7);
  for (int sample = 0; sample < 20; ++sample) {
    Drawings circles(2 + random() % 4);
    Drawings segments(2 + random() % 4);
    for (int& k : circles) k = static_cast<int>(random() % (kRadius + 1));
    for (int& k : segments) k = static_cast<int>(random() % (kColumns + 1));
    expect_drawn(circles, segments);
    if (HasFatalFailure()) FAIL() << "sample " << sample;
  }
}

}  // namespace
}  // namespace rc2::network
