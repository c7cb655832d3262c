// rc2_dexel against exact division: packets of random slabs and sides on random boxes, random
// stalls at the filling side and of the stage that holds the words; the dexels that come out, in
// order, are those of the packets that have one, with their cores.
#include <algorithm>
#include <deque>
#include <vector>

#include "sw/machine/host_word.h"
#include "tb/rtl/block.h"

namespace {

constexpr rc2::MachineConfig kConfig{16, 4, 64, 32};

struct Interval {
  std::int64_t lo, hi;
  bool empty() const { return lo > hi; }
};

struct Dexel {
  std::uint32_t facet;
  int z0;
  Interval all, core;
};

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

// Keeps the z where c*z + e >= 0.
void narrow(Interval& z, std::int64_t c, std::int64_t e) {
  if (c == 0 && e < 0) z = {1, 0};
  if (c > 0) z.lo = std::max(z.lo, -floor_div(e, c));
  if (c < 0) z.hi = std::min(z.hi, floor_div(e, -c));
}

TEST(Dexel, EqualsTheExactInterval) {
  const rc2::WordFormat format(kConfig);
  rc2::tb::Clocked<Vtop> unit;
  rc2::tb::Dice dice(3);
  std::deque<Dexel> expected;
  int seen = 0, empty = 0, coreless = 0;

  // One cycle; true if the word that waits leaves.
  const auto tick = [&](bool& taken) {
    unit.top.ready_i = dice.chance(60);
    unit.settle();
    taken = unit.top.valid_i != 0 && unit.top.ready_o != 0 && dice.chance(80);
    unit.top.take_i = taken;
    unit.settle();
    if (taken && unit.top.valid_o != 0) {
      ASSERT_NE(unit.top.ready_i, 0) << "a dexel is lost";
      ASSERT_FALSE(expected.empty()) << "a dexel out of nothing";
      const Dexel want = expected.front();
      expected.pop_front();
      ASSERT_EQ(unit.top.facet_o, want.facet);
      ASSERT_EQ(unit.top.z0_o, want.z0);
      ASSERT_EQ(unit.top.lo_o, want.all.lo) << "facet " << want.facet;
      ASSERT_EQ(unit.top.hi_o, want.all.hi) << "facet " << want.facet;
      // Of the core only what lies in the dexel has a meaning.
      for (std::int64_t z = want.all.lo; z <= want.all.hi; ++z) {
        ASSERT_EQ(z >= unit.top.core_lo_o && z <= unit.top.core_hi_o,
                  z >= want.core.lo && z <= want.core.hi)
            << "facet " << want.facet << ", z " << z;
      }
      if (want.core.empty()) ++coreless;
      ++seen;
    }
    unit.tick();
  };
  const auto send = [&](const rc2::Word& word) {
    const auto limbs = rc2::HostWord(format, word).limbs();
    unit.top.valid_i = 1;
    unit.top.kind_i = static_cast<CData>(word.kind);
    const std::uint64_t low = limbs[0] | static_cast<std::uint64_t>(limbs[1]) << 32;
    unit.top.rest_i = low & ((1ULL << format.rest) - 1);
    bool taken = false;
    for (int waited = 0; !taken && !testing::Test::HasFatalFailure(); ++waited) {
      ASSERT_LT(waited, 1000) << "it hangs";
      tick(taken);
    }
    unit.top.valid_i = 0;
  };
  // Small coefficients meet the exact multiples, large ones the ends of the widths.
  const auto value = [&](rc2::Word& word, int bits) {
    const std::int64_t reach = dice.chance(70) ? 9 : (1LL << (bits - 1)) - 1;
    word.c = dice.chance(25) ? 0 : dice.roll(-reach, reach);
    const std::int64_t far = std::min<std::int64_t>(20 * std::max<std::int64_t>(reach / 2, 1),
                                                    (1LL << (format.offset - 1)) - 1);
    word.d = dice.roll(-far / 4, far);
    return reach;
  };

  for (std::uint32_t facet = 0; facet < 40000 && !HasFatalFailure(); ++facet) {
    rc2::Word head{rc2::WordKind::head};
    head.facet = facet;
    head.z0 = static_cast<int>(dice.roll(0, 15));
    head.z_span =
        static_cast<int>(dice.chance(40) ? std::min(2, 15 - head.z0) : dice.roll(0, 15 - head.z0));
    rc2::Word slab{rc2::WordKind::slab};
    const std::int64_t steep = value(slab, format.coefficient);
    const std::int64_t widest = std::min<std::int64_t>(40 * steep, (1LL << format.width) - 1);
    head.reach = dice.chance(50) ? widest : dice.roll(0, widest);
    Dexel dexel{facet, head.z0, {0, head.z_span}, {0, head.z_span}};
    narrow(dexel.all, slab.c, slab.d);
    narrow(dexel.all, -slab.c, head.reach - slab.d);
    send(head);
    send(slab);
    for (int sides = static_cast<int>(dice.roll(0, 4)); sides > 0; --sides) {
      rc2::Word side{rc2::WordKind::side};
      const std::int64_t edge = value(side, format.side);
      side.reach = dice.roll(0, std::min<std::int64_t>(2 * edge, (1LL << format.push) - 1));
      narrow(dexel.all, side.c, side.d);
      narrow(dexel.core, side.c, side.d - side.reach);
      send(side);
    }
    if (dexel.all.empty()) {
      ++empty;
    } else {
      expected.push_back(dexel);
    }
    send(rc2::Word{rc2::WordKind::gap});
  }
  EXPECT_TRUE(expected.empty()) << expected.size() << " dexels were lost";
  EXPECT_GT(seen, 5000);
  EXPECT_GT(empty, 5000);
  EXPECT_GT(coreless, 500);
  EXPECT_GT(seen - coreless, 2000);
}

}  // namespace
