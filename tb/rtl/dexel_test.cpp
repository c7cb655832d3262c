// rc2_dexel against exact division: packets of random bounds on random boxes, random stalls at the
// filling side; the dexels that come out, in order, are those of the packets that have one.
#include <algorithm>
#include <deque>
#include <vector>

#include "sim/host_word.h"
#include "tb/rtl/block.h"

namespace {

constexpr rc2::MachineConfig kConfig{16, 4, 64, 32};

struct Dexel {
  std::uint32_t facet;
  int lo, hi;
};

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

TEST(Dexel, EqualsTheExactInterval) {
  const rc2::WordFormat format(kConfig);
  rc2::tb::Clocked<Vtop> unit;
  rc2::tb::Random random(3);
  std::deque<Dexel> expected;
  int seen = 0;
  int empty = 0;

  // One cycle; true if the unit takes the word that is offered to it.
  const auto tick = [&](bool& taken) {
    unit.top.ready_i = random.chance(60);
    unit.settle();
    taken = unit.top.ready_o != 0;
    if (unit.top.valid_o != 0 && unit.top.ready_i != 0) {
      ASSERT_FALSE(expected.empty()) << "a dexel out of nothing";
      const Dexel want = expected.front();
      expected.pop_front();
      ASSERT_EQ(unit.top.facet_o, want.facet);
      ASSERT_EQ(unit.top.lo_o, want.lo) << "facet " << want.facet;
      ASSERT_EQ(unit.top.hi_o, want.hi) << "facet " << want.facet;
      ++seen;
    }
    unit.tick();
  };
  const auto send = [&](rc2::WordKind kind, bool last, std::uint64_t rest) {
    unit.top.valid_i = 1;
    unit.top.kind_i = static_cast<CData>(kind);
    unit.top.last_i = last;
    unit.top.rest_i = rest;
    for (bool taken = false; !taken && !testing::Test::HasFatalFailure();) tick(taken);
    unit.top.valid_i = 0;
  };

  for (std::uint32_t facet = 0; facet < 20000 && !HasFatalFailure(); ++facet) {
    const int z0 = static_cast<int>(random.in(0, 15));
    const int span =
        random.chance(40) ? std::min<int>(2, 15 - z0) : static_cast<int>(random.in(0, 15 - z0));
    std::int64_t lo = 0;
    std::int64_t hi = span;
    bool outside = false;
    send(rc2::WordKind::head, false,
         static_cast<std::uint64_t>(z0) | static_cast<std::uint64_t>(span) << format.coordinate |
             static_cast<std::uint64_t>(facet) << (2 * format.coordinate));
    const int bounds = static_cast<int>(random.in(1, 6));
    for (int i = 0; i < bounds; ++i) {
      // Small coefficients meet the exact multiples, large ones the ends of the widths.
      const std::int64_t reach = random.chance(70) ? 9 : (1LL << (format.coefficient - 1)) - 1;
      const std::int64_t c = random.chance(25) ? 0 : random.in(-reach, reach);
      const std::int64_t far = std::min<std::int64_t>(20 * std::max<std::int64_t>(reach / 2, 1),
                                                      (1LL << (format.offset - 1)) - 1);
      const std::int64_t d = random.in(-far, far);
      send(rc2::WordKind::bound, i + 1 == bounds,
           rc2::tb::bits(d, format.offset) | rc2::tb::bits(c, format.coefficient) << format.offset);
      if (c == 0) outside = outside || d < 0;
      if (c > 0) lo = std::max(lo, -floor_div(d, c));
      if (c < 0) hi = std::min(hi, floor_div(d, -c));
    }
    if (!outside && lo <= hi) {
      expected.push_back({facet, z0 + static_cast<int>(lo), z0 + static_cast<int>(hi)});
    } else {
      ++empty;
    }
  }
  for (int i = 0; i < 100; ++i) {
    bool ignored = false;
    tick(ignored);
  }
  EXPECT_TRUE(expected.empty()) << expected.size() << " dexels were lost";
  EXPECT_GT(seen, 2000);
  EXPECT_GT(empty, 2000);
}

}  // namespace
