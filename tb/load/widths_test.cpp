// No register of the loading path can overflow: by what a facet can be at most, by facets that are
// that, by stepping, and by what the host and the machine refuse.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <glm/common.hpp>
#include <set>

#include "sw/base/config.h"
#include "sw/base/error.h"
#include "sw/cycle/facet_stage.h"
#include "sw/facet/facet.h"
#include "sw/machine/checks.h"
#include "sw/machine/feeder.h"
#include "tb/load/dice.h"
#include "tb/load/facet_case.h"
#include "tb/load/golden_check.h"
#include "tb/load/machine_check.h"

namespace rc2::facet {
namespace {

using Exact = boost::multiprecision::cpp_int;

constexpr std::array kRules{Rule::armoured, Rule::naive, Rule::supercover, Rule::half,
                            Rule::blindee};

/// Smallest number of bits that hold 0 .. value, and with a sign -value .. value.
int unsigned_bits(const Exact& value) {
  return value == 0 ? 0 : static_cast<int>(boost::multiprecision::msb(value)) + 1;
}
int signed_bits(const Exact& value) { return unsigned_bits(value) + 1; }

// ---- What a facet can be at most ---------------------------------------------------------------

struct Range {
  std::int64_t low, high;
  std::int64_t end(unsigned choice) const { return choice & 1U ? high : low; }
};

// Largest |N . (q - V0)|, N = (V1 - V0) x (V2 - V0), over all vertices and points q of these
// ranges: it is affine in each of the twelve coordinates alone, so no value is beyond those at the
// ends.
std::int64_t largest_slab_value(const Range& vertex, const std::array<Range, 3>& q) {
  std::int64_t largest = 0;
  for (unsigned ends = 0; ends < 1U << 12; ++ends) {
    const auto corner = [&](unsigned which) {
      const unsigned bits = ends >> 3 * which;
      return Vertex{vertex.end(bits), vertex.end(bits >> 1), vertex.end(bits >> 2)};
    };
    const Vertex first = corner(0), normal = cross(corner(1) - first, corner(2) - first);
    const Vertex point{q[0].end(ends >> 9), q[1].end(ends >> 10), q[2].end(ends >> 11)};
    largest = std::max(largest, std::abs(dot(normal, point - first)));
  }
  return largest;
}

// Likewise along |A|, |B|, |C| and their sum, for vertices in 0 .. 1.
struct Normal {
  std::int64_t component = 0, sum = 0;
};
Normal largest_normal() {
  Normal largest;
  for (unsigned ends = 0; ends < 1U << 9; ++ends) {
    const auto corner = [&](unsigned which) {
      const unsigned bits = ends >> 3 * which;
      return Vertex{bits & 1U, bits >> 1 & 1U, bits >> 2 & 1U};
    };
    const Vertex n = glm::abs(cross(corner(1) - corner(0), corner(2) - corner(0)));
    largest.component = std::max({largest.component, n.x, n.y, n.z});
    largest.sum = std::max(largest.sum, n.x + n.y + n.z);
  }
  return largest;
}

TEST(Widths, HoldWhateverAFacetInTheCubeCanBe) {
  const Normal unit = largest_normal();
  EXPECT_EQ(unit.component, 1);
  EXPECT_EQ(unit.sum, 3);
  int spare = 100;
  for (int n = 2; n <= kMaxSide; ++n) {
    const std::int64_t halves = 2 * std::int64_t{n};
    // In halves of a voxel. A voxel centre plus what its rule lets it reach, half a voxel along all
    // axes or a whole one along one (blindee: K sigma <= K), is a point q of these ranges.
    const Range vertex{-1, halves - 1}, centre{0, halves - 2}, far{-2, halves};
    std::int64_t value = largest_slab_value(vertex, {vertex, vertex, vertex});
    value = std::max(value, largest_slab_value(vertex, {far, centre, centre}));
    value = std::max(value, largest_slab_value(vertex, {centre, far, centre}));
    value = std::max(value, largest_slab_value(vertex, {centre, centre, far}));
    for (int f = 0; f <= kMaxFractionBits; ++f) {
      const Exact one = Exact(1) << f, edge = n * one, area = edge * edge;
      const int plane = plane_bits(n, f), offset = offset_bits(n, f);

      ASSERT_LE(signed_bits(edge), side_bits(n, f)) << "a side's coefficients";
      ASSERT_LE(signed_bits(unit.component * area), plane) << "A, B, C";
      ASSERT_LE(unsigned_bits((2 * unit.sum + unit.component) * area), width_bits(n, f))
          << "a guard's width 2 S + K; others are less";
      ASSERT_LE(unsigned_bits(edge + 1), push_bits(n, f)) << "half of two edges, rounded";

      // One more, because a tie rounds down from where it is.
      const Exact slab = value * one * one / 8 + 1, side = n * edge + 1;
      ASSERT_LE(signed_bits(slab), offset) << "T, U, and either from the other";
      ASSERT_LE(signed_bits(side), offset) << "Ti, before and after its push";

      // The dexel unit: a numerator of at most |value| + |c|, a divisor moved up by a range's bits.
      ASSERT_LE(signed_bits(slab + area), offset);
      ASSERT_LE(unsigned_bits(area << coordinate_bits(n)), plane + coordinate_bits(n));

      // A gap: 1 at most along each axis, 3/2 within a facet, one sixteenth for its rounding: half
      // a unit of d and of each coefficient at each of the n - 1 steps, 3/8 of a sixteenth.
      const Exact gap = Exact(1) << gap_fraction_bits(n);
      ASSERT_LE(signed_bits(gap), gap_value_bits(n));
      ASSERT_LE(signed_bits(3 * gap / 2 + gap / 16), gap_value_bits(n));
      ASSERT_LE(16 * Exact(3 * (n - 1) + 1) / 2, gap * 3 / 8);

      // Sums of three products of three lengths, as the host makes them, before anything is
      // divided.
      ASSERT_LE(signed_bits(2 * 3 * 2 * edge * edge * edge), 64);

      if (offset == gap_value_bits(n)) continue;  // the smallest machines: the gap is wider
      const bool is_full = (n & (n - 1)) == 0;
      spare = std::min(spare, offset - signed_bits(slab));
      ASSERT_LE(offset - signed_bits(slab), is_full ? 0 : 3);
      ASSERT_LE(side_bits(n, f) - signed_bits(edge), is_full ? 0 : 1);
      ASSERT_LE(push_bits(n, f) - unsigned_bits(edge), is_full ? 0 : 1);
      ASSERT_LE(plane - signed_bits(area), is_full ? 0 : 2);
    }
  }
  EXPECT_EQ(spare, 0);
}

// ---- Facets that are that ----------------------------------------------------------------------

struct Used {
  Exact coefficient = 0, value = 0, width = 0, edge = 0, push = 0;

  static void grow(Exact& most, std::int64_t value) {
    if (most < std::abs(value)) most = std::abs(value);
  }
  void see(const PacketHead& head, const Side* sides) {
    const glm::ivec3 size = head.hi - head.lo;
    const auto corners = [&](const Linear& linear) {
      for (const int x : {0, size.x})
        for (const int y : {0, size.y}) grow(value, linear.a * x + linear.b * y + linear.d);
    };
    const Linear& slab = head.slab.value;
    for (const std::int64_t c : {slab.a, slab.b, slab.c}) grow(coefficient, c);
    grow(width, head.slab.width);
    corners(slab);
    for (std::uint32_t i = 0; i < head.side_count; ++i) {
      for (const std::int64_t c : {sides[i].value.a, sides[i].value.b, sides[i].value.c})
        grow(edge, c);
      grow(push, sides[i].push);
      corners(sides[i].value);
    }
  }
};

TEST(Widths, AreReachedWithinOneBit) {
  for (const int n : {2, 4, 16, 64, 256, 1024}) {
    for (int f = 0; f <= kMaxFractionBits; ++f) {
      const Cube cube{n, f};
      Used used;
      Dice dice(1);
      // Triangles between the corners of the cube, moved off them a little: common factors of two
      // would make their normals short.
      for (unsigned corners = 0; corners < 1U << 9; ++corners) {
        Border border;
        for (unsigned i = 0; i < 3; ++i) {
          Vertex v;
          for (int axis = 0; axis < 3; ++axis) {
            const bool high = corners >> (3 * i + static_cast<unsigned>(axis)) & 1U;
            const std::int64_t off = cube.extent() < 8 ? 0 : dice.roll(0, 3);
            v[axis] = high ? cube.high() - off : cube.low() + off;
          }
          border.push_back(v);
        }
        if (!has_area(border)) continue;
        for (const Rule rule : kRules) {
          const FacetSet set = build_facets(scene_of({border}, cube), n, f, rule);
          if (!set.packets.heads.empty()) used.see(set.packets.heads[0], set.packets.sides.data());
        }
      }
      SCOPED_TRACE("n = " + std::to_string(n) + ", f = " + std::to_string(f));
      EXPECT_LE(signed_bits(used.coefficient), plane_bits(n, f));
      EXPECT_LE(signed_bits(used.value), offset_bits(n, f));
      EXPECT_LE(unsigned_bits(used.width), width_bits(n, f));
      EXPECT_LE(signed_bits(used.edge), side_bits(n, f));
      EXPECT_LE(unsigned_bits(used.push), push_bits(n, f));
      if (n < 16 || f < 1) continue;  // too few steps to move off a corner by
      EXPECT_GE(signed_bits(used.coefficient), plane_bits(n, f) - 1);
      EXPECT_GE(signed_bits(used.value), offset_bits(n, f) - 1);
      EXPECT_GE(unsigned_bits(used.width), plane_bits(n, f) - 1);
      EXPECT_GE(signed_bits(used.edge), side_bits(n, f) - 1);
      EXPECT_GE(unsigned_bits(used.push), push_bits(n, f) - 1);
    }
  }
}

// ---- Stepping ----------------------------------------------------------------------------------

using Words = std::vector<Word>;

// What each unit beside a pipe of so many stages gets; `stride` units of the array lie between two.
std::vector<Words> walk(cycle::Pipe pipe, int stride, Words words, int units) {
  std::vector<Words> result(static_cast<std::size_t>(units));
  for (Words& unit : result) {
    cycle::FacetStage stage(pipe, stride);
    Words next;
    for (const Word& word : words) {
      stage.push(word);
      if (stage.here()) unit.push_back(stage.front());
      if (stage.on()) next.push_back(stage.stepped());
      stage.pop();
    }
    words = next;
  }
  EXPECT_TRUE(words.empty()) << "words fall off the end of the pipe";
  return result;
}

Exact closed_form(const Linear& linear, int x, int y) {
  return Exact(linear.a) * x + Exact(linear.b) * y + linear.d;
}

void expect_exact(const Words& words, const PacketStream& stream, const PacketHead& head, int x,
                  int y) {
  ASSERT_EQ(words.size(), head.side_count + 3U);
  ASSERT_EQ(words[1].d, closed_form(head.slab.value, x, y));
  for (std::uint32_t i = 0; i < head.side_count; ++i)
    ASSERT_EQ(words[2 + i].d, closed_form(stream.sides[head.first_side + i].value, x, y));
  ASSERT_EQ(words.back().d, closed_form(head.gap, x, y));
}

TEST(Stepping, GivesEveryCellOfTheBoxTheClosedForm) {
  Dice dice(3);
  for (int i = 0; i < 400; ++i) {
    const Cube cube{static_cast<int>(std::array{2, 3, 5, 16, 33}[dice.roll(0, 4)]),
                    static_cast<int>(dice.roll(0, kMaxFractionBits))};
    const Border border =
        generate_facets(kFacetClasses[i % kFacetClasses.size()], cube, dice.bits())[0];
    const FacetSet set =
        build_facets(scene_of({border}, cube), cube.n, cube.fraction_bits, kRules[i % 5]);
    if (set.packets.heads.empty()) continue;
    const PacketHead& head = set.packets.heads[0];
    const int feeders = random_feeders(cube.n, dice);
    std::int64_t served = 0;
    for (int feeder = 0; feeder < feeders; ++feeder) {
      Words sent;
      for (FeederWords words(set.packets, feeder, feeders); !words.done();)
        sent.push_back(words.next());
      const int count = (cube.n - feeder + feeders - 1) / feeders;
      const std::vector<Words> rows = walk(cycle::Pipe::vertical, feeders, sent, count);
      for (int row = 0; row < count; ++row) {
        const std::vector<Words> cells =
            walk(cycle::Pipe::row, 1, rows[static_cast<std::size_t>(row)], cube.n);
        for (int column = 0; column < cube.n; ++column) {
          const Words& words = cells[static_cast<std::size_t>(column)];
          const int x = column - head.lo.x, y = feeder + row * feeders - head.lo.y;
          const bool in_box = x >= 0 && y >= 0 && column <= head.hi.x && y <= head.hi.y - head.lo.y;
          ASSERT_EQ(!words.empty(), in_box);
          if (!in_box) continue;
          expect_exact(words, set.packets, head, x, y);
          ++served;
        }
      }
    }
    const glm::ivec3 size = head.hi - head.lo + 1;
    ASSERT_EQ(served, std::int64_t{size.x} * size.y);
  }
}

// The longest way at the greatest slopes: 1023 steps along each pipe.
TEST(Stepping, IsExactAcrossTheLargestMachine) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Cube cube{kMaxSide, kMaxFractionBits};
    const Border border = generate_facets(FacetClass::full_cube, cube, seed)[0];
    const FacetSet set =
        build_facets(scene_of({border}, cube), cube.n, cube.fraction_bits, Rule::armoured);
    if (set.packets.heads.empty()) continue;
    const PacketHead& head = set.packets.heads[0];
    Words sent;
    for (FeederWords words(set.packets, 0, 1); !words.done();) sent.push_back(words.next());
    const std::vector<Words> rows = walk(cycle::Pipe::vertical, 1, sent, cube.n);
    for (const int y : {head.lo.y, (head.lo.y + head.hi.y) / 2, head.hi.y}) {
      const std::vector<Words> cells =
          walk(cycle::Pipe::row, 1, rows[static_cast<std::size_t>(y)], cube.n);
      for (int x = head.lo.x; x <= head.hi.x; ++x)
        expect_exact(cells[static_cast<std::size_t>(x)], set.packets, head, x - head.lo.x,
                     y - head.lo.y);
    }
  }
}

// ---- What is refused ---------------------------------------------------------------------------

std::string refusal(const std::vector<Border>& borders, const Cube& cube) {
  try {
    build_facets(scene_of(borders, cube), cube.n, cube.fraction_bits, Rule::armoured);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Refusal, BeginsOneStepBeyondTheCube) {
  for (const int n : {2, 3, 16, 1000, 1023, 1024}) {
    for (int f = 0; f <= kMaxFractionBits; ++f) {
      const Cube cube{n, f};
      const std::int64_t low = cube.low(), high = cube.high();
      const Border inside{{low, low, low}, {high, low, high}, {low, high, high}};
      SCOPED_TRACE("n = " + std::to_string(n) + ", f = " + std::to_string(f));
      ASSERT_EQ(refusal({inside, inside}, cube), "") << "the border belongs to the cube";
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
          Border beyond = inside;
          beyond[corner][axis] += beyond[corner][axis] == high ? 1 : -1;
          const std::string message = refusal({inside, beyond}, cube);
          ASSERT_NE(message.find("polygon 1 "), std::string::npos) << message;
          ASSERT_NE(message.find("--fit cube"), std::string::npos) << message;
        }
    }
  }
}

// A packet of facet 7 with the number in question at its last value and one beyond.
TEST(Refusal, OfAPacketNamesItsFacet) {
  const MachineConfig config;
  const int n = config.n, f = config.fraction_bits;
  const Linear flat{0, 0, 0, 0};
  const auto refuses = [&](const PacketHead& head, const Side& side) {
    PacketStream stream{{head}, {side}, {}};
    try {
      check_packets(config, stream);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("facet 7"), std::string::npos) << error.what();
      return true;
    }
    return false;
  };
  const auto expect_range = [&](const char* what, std::int64_t least, std::int64_t most,
                                auto change) {
    const auto with = [&](std::int64_t value) {
      PacketHead head{7, glm::ivec3(0), glm::ivec3(0), {flat, 0}, flat, 0, 1};
      Side side{flat, 0};
      change(head, side, value);
      return refuses(head, side);
    };
    EXPECT_FALSE(with(most)) << what;
    EXPECT_TRUE(with(most + 1)) << what;
    EXPECT_FALSE(with(least)) << what;
    EXPECT_TRUE(with(least - 1)) << what;
  };
  const auto expect_limit = [&](const char* what, int bits, bool is_signed, auto change) {
    const std::int64_t end = std::int64_t{1} << (is_signed ? bits - 1 : bits);
    expect_range(what, is_signed ? -end : 0, end - 1, change);
  };
  const int plane = plane_bits(n, f), offset = offset_bits(n, f);
  for (auto member : {&Linear::a, &Linear::b, &Linear::c}) {
    expect_limit("A, B, C", plane, true,
                 [&](PacketHead& h, Side&, std::int64_t v) { h.slab.value.*member = v; });
    expect_limit("a side's coefficient", side_bits(n, f), true,
                 [&](PacketHead&, Side& s, std::int64_t v) { s.value.*member = v; });
    const std::int64_t one = std::int64_t{1} << gap_fraction_bits(n);
    expect_range("a gap's coefficient", -one, one,
                 [&](PacketHead& h, Side&, std::int64_t v) { h.gap.*member = v; });
  }
  expect_limit("T", offset, true, [](PacketHead& h, Side&, std::int64_t v) { h.slab.value.d = v; });
  expect_limit("Ti", offset, true, [](PacketHead&, Side& s, std::int64_t v) { s.value.d = v; });
  expect_limit("a slab's width", width_bits(n, f), false,
               [](PacketHead& h, Side&, std::int64_t v) { h.slab.width = v; });
  expect_limit("a push", push_bits(n, f), false,
               [](PacketHead&, Side& s, std::int64_t v) { s.push = v; });
  // Small enough at the first cell, and at the last or one too large.
  const std::int64_t most = (std::int64_t{1} << (offset - 1)) - 1;
  const std::int64_t steps = std::int64_t{n - 1} + (n - 1);
  for (const std::int64_t beyond : {0, 1}) {
    const Slab slab{{1, 1, 0, most - steps + beyond}, 0};
    const glm::ivec3 last(n - 1, n - 1, 0);
    EXPECT_EQ(refuses({7, glm::ivec3(0), last, slab, flat, 0, 1}, {flat, 0}), beyond == 1);
  }
}

}  // namespace
}  // namespace rc2::facet
