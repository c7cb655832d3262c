// rc2_ray_share for every weight and every share: what new rays are worth by long-hand arithmetic,
// together never more than the ray that hit; which of them are sent, with random limits.
#include "tb/rtl/block.h"

namespace {

constexpr int kWeightOne = 4096, kShareOne = 256, kMaxDepth = 4, kPlaceBits = 2, kWeightBits = 13;

int level_of(int node) {
  int level = 0;
  while (node >> (level + 1) != 0) ++level;
  return level;
}

class RayShare : public ::testing::Test {
 protected:
  void check(int weight, int mirror, int clear, bool all_back) {
    const int depth = dice_.roll(0, kMaxDepth), node = dice_.roll(1, (2 << kMaxDepth) - 1);
    const int least = dice_.chance(50) ? dice_.roll(0, 3) : dice_.roll(0, kWeightOne);
    share_.limits_i = static_cast<unsigned>((depth << kWeightBits | least) << kPlaceBits | 1);
    share_.node_i = node;
    share_.weight_i = weight;
    share_.mirror_i = mirror;
    share_.clear_i = clear;
    share_.all_back_i = all_back;
    share_.eval();
    const int worth[] = {weight * (all_back ? mirror + clear : mirror) / kShareOne,
                         all_back ? 0 : weight * clear / kShareOne};
    const bool has[] = {mirror > 0 || (all_back && clear > 0), !all_back && clear > 0};
    int too_light = 0, too_deep = 0;
    bool is_sent[2];
    for (int child = 0; child < 2; ++child) {
      const bool is_heavy = worth[child] > 0 && worth[child] >= least;
      is_sent[child] = is_heavy && level_of(node) < depth;
      too_light += has[child] && !is_heavy;
      too_deep += is_heavy && !is_sent[child];
    }
    ASSERT_LE(share_.mirrored_weight_o + share_.cleared_weight_o, weight);
    ASSERT_EQ(share_.mirrored_weight_o, worth[0]);
    ASSERT_EQ(share_.cleared_weight_o, worth[1]);
    ASSERT_EQ(share_.mirrored_o, is_sent[0]);
    ASSERT_EQ(share_.cleared_o, is_sent[1]);
    ASSERT_EQ(share_.too_light_o, too_light);
    ASSERT_EQ(share_.too_deep_o, too_deep);
  }

  rc2::tb::Module<Vtop> share_;
  rc2::tb::Dice dice_{1};
};

TEST_F(RayShare, IsWorthNoMoreThanTheRayThatHit) {
  for (int weight = 0; weight <= kWeightOne; ++weight) {
    for (int mirror = 0; mirror <= kShareOne; ++mirror) {
      ASSERT_NO_FATAL_FAILURE(check(weight, mirror, kShareOne - mirror, false));
    }
  }
}

TEST_F(RayShare, DoesWithAnyShares) {
  for (int round = 0; round < 300000; ++round) {
    const int mirror = dice_.chance(20) ? 0 : dice_.roll(0, kShareOne);
    const int clear = dice_.chance(20) ? 0 : dice_.roll(0, kShareOne - mirror);
    ASSERT_NO_FATAL_FAILURE(check(dice_.roll(0, kWeightOne), mirror, clear, dice_.chance(50)));
  }
}

// Shares that no host gives: the mirrored ray is still worth no more than the one that hit.
TEST_F(RayShare, MirrorsNoMoreThanAll) {
  for (int round = 0; round < 1000; ++round) {
    share_.mirror_i = dice_.roll(0, kShareOne);
    share_.clear_i = kShareOne;
    share_.all_back_i = 1;
    share_.weight_i = dice_.roll(0, kWeightOne);
    share_.eval();
    ASSERT_EQ(share_.mirrored_weight_o, share_.weight_i);
  }
}

}  // namespace
