// rc2_splitter against the digital ray itself (nearest integer to j*k/L, ties down): every target
// of a beam is in exactly one child, where its ray goes next; or out of the cube; or in the
// remainder. Random sources, faces, distances, voxels and beams of a cube of n = 6.
#include <array>
#include <set>
#include <utility>

#include "tb/rtl/block.h"

namespace {

constexpr int kN = 6;
constexpr int kLmax = 24;
constexpr int kCoordW = 3;
constexpr int kDistanceW = 5;
constexpr int kTargetW = 6;
constexpr int kQueueW = 6;

// Direction d of a link: E, NE, N, NW, W, SW, S, SE.
constexpr std::array<int, 8> kDx{1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, 8> kDy{0, 1, 1, 1, 0, -1, -1, -1};

int floor_div(int a, int b) { return a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0); }

/// Offset of the ray of target j after k steps: nearest integer to j*k/L, ties down.
int ray(int j, int k, int distance) { return -floor_div(distance - 2 * j * k, 2 * distance); }

/// Targets whose ray is at `offset` after k steps: first and last; first > last if there is none.
std::pair<int, int> targets_at(int offset, int k, int distance, int limit) {
  int first = limit + 1;
  int last = -limit - 1;
  for (int j = -limit; j <= limit; ++j) {
    if (ray(j, k, distance) != offset) continue;
    first = std::min(first, j);
    last = std::max(last, j);
  }
  return {first, last};
}

struct Part {
  int min, max;
};

/// The three parts of an axis as the module gives them, from the low bits of split_o up.
std::array<Part, 3> parts(const Vtop& top, int first_field) {
  const auto field = [&](int index) {
    int value = 0;
    for (int bit = 0; bit < kTargetW; ++bit) {
      const int at = index * kTargetW + bit;
      value |= static_cast<int>(top.split_o[static_cast<std::size_t>(at / 32)] >> (at % 32) & 1U)
               << bit;
    }
    return value >= 1 << (kTargetW - 1) ? value - (1 << kTargetW) : value;
  };
  std::array<Part, 3> result{};
  for (int part = 0; part < 3; ++part) {
    result[static_cast<std::size_t>(part)] = {field(first_field + 5 - 2 * part),
                                              field(first_field + 4 - 2 * part)};
  }
  return result;
}

TEST(Splitter, PartitionsTheTargetsAlongTheirRays) {
  rc2::tb::Module<Vtop> top;
  rc2::tb::Dice dice(5);
  const auto pick = [&](std::int64_t low, std::int64_t high) {
    return static_cast<int>(dice.roll(low, high));
  };
  std::set<int> shapes;
  int escapes = 0;
  int remainders = 0;
  for (int trial = 0; trial < 400000; ++trial) {
    const std::array<int, 3> source{pick(0, kN - 1), pick(0, kN - 1), pick(0, kN - 1)};
    const std::array<int, 3> at{pick(0, kN - 1), pick(0, kN - 1), pick(0, kN - 1)};
    const int distance = pick(1, kLmax);
    const int axis = pick(0, 2);
    const int u_axis = axis == 0 ? 1 : 0;
    const int v_axis = axis == 2 ? 1 : 2;
    const auto offset = [&](int a) {
      return at[static_cast<std::size_t>(a)] - source[static_cast<std::size_t>(a)];
    };
    const bool negative = offset(axis) != 0 ? offset(axis) < 0 : dice.chance(50);
    const int k = std::abs(offset(axis));
    const auto [u_first, u_last] = targets_at(offset(u_axis), k, distance, distance);
    const auto [v_first, v_last] = targets_at(offset(v_axis), k, distance, distance);
    if (u_first > u_last || v_first > v_last) continue;
    Part u{pick(u_first, u_last), 0};
    u.max = pick(u.min, u_last);
    Part v{pick(v_first, v_last), 0};
    v.max = pick(v.min, v_last);

    top.valid_i = 1;
    top.x_i = static_cast<CData>(at[0]);
    top.y_i = static_cast<CData>(at[1]);
    const auto target = [](int value) { return rc2::tb::bits(value, kTargetW); };
    top.beam_i = static_cast<IData>(
        static_cast<std::uint64_t>(2 * axis + (negative ? 1 : 0)) << (kCoordW + 4 * kTargetW) |
        static_cast<std::uint64_t>(at[2]) << (4 * kTargetW) | target(u.min) << (3 * kTargetW) |
        target(u.max) << (2 * kTargetW) | target(v.min) << kTargetW | target(v.max));
    top.light_i = static_cast<IData>(source[0] << (2 * kCoordW + kDistanceW + kQueueW) |
                                     source[1] << (kCoordW + kDistanceW + kQueueW) |
                                     source[2] << (kDistanceW + kQueueW) | distance << kQueueW | 1);
    top.eval();

    const auto u_parts = parts(top, 6);
    const auto v_parts = parts(top, 0);
    const int split_z = static_cast<int>(
        top.split_o[static_cast<std::size_t>(12 * kTargetW / 32)] >> (12 * kTargetW % 32) & 7U);
    // A side beam serves the targets whose rays go lowest along V; the others wait.
    const int served_v = ray(v.min, k + 1, distance);
    int served = 0;
    int kept = 0;
    int waiting = kLmax + 1;  // the lowest V target that is not served
    for (int vt = v.min; vt <= v.max; ++vt) {
      const bool now = axis == 2 || ray(vt, k + 1, distance) == served_v;
      if (!now && waiting > vt) waiting = vt;
      for (int ut = u.min; ut <= u.max; ++ut) {
        std::array<int, 3> next = source;
        next[static_cast<std::size_t>(axis)] += (negative ? -1 : 1) * (k + 1);
        next[static_cast<std::size_t>(u_axis)] += ray(ut, k + 1, distance);
        next[static_cast<std::size_t>(v_axis)] += ray(vt, k + 1, distance);
        bool inside = true;
        for (const int c : next) inside = inside && c >= 0 && c < kN;
        int homes = 0;
        const auto holds = [&](int dx, int dy) {
          const auto& along_u = u_parts[static_cast<std::size_t>((axis == 0 ? dy : dx) + 1)];
          const auto& along_v = v_parts[static_cast<std::size_t>(dy + 1)];
          return ut >= along_u.min && ut <= along_u.max && vt >= along_v.min && vt <= along_v.max;
        };
        for (std::size_t d = 0; d < 8; ++d) {
          if ((top.send_o >> d & 1U) == 0 || !holds(kDx[d], kDy[d])) continue;
          ++homes;
          ASSERT_EQ(at[0] + kDx[d], next[0]);
          ASSERT_EQ(at[1] + kDy[d], next[1]);
          ASSERT_EQ(split_z, next[2]);
        }
        if (top.own_o != 0 && holds(0, 0)) {
          ++homes;
          ASSERT_EQ(at[0], next[0]);
          ASSERT_EQ(at[1], next[1]);
          ASSERT_EQ(split_z, next[2]);
        }
        ASSERT_EQ(homes, now && inside ? 1 : 0)
            << "trial " << trial << " target " << ut << "," << vt;
        served += now ? 1 : 0;
        kept += now && inside ? 1 : 0;
        escapes += now && !inside ? 1 : 0;
        remainders += now ? 0 : 1;
      }
    }
    ASSERT_EQ(top.more_o, waiting <= kLmax ? 1 : 0);
    if (waiting <= kLmax) {
      const int sign = static_cast<int>(top.resume_o) >> (kTargetW - 1);
      ASSERT_EQ(static_cast<int>(top.resume_o) - (sign << kTargetW), waiting);
    }
    ASSERT_EQ(top.served_u_o * top.served_v_o, served);
    ASSERT_EQ(top.kept_u_o * top.kept_v_o, kept);
    shapes.insert(__builtin_popcount(top.send_o) + (top.own_o != 0 ? 1 : 0));
  }
  // All shapes but those that no digital ray makes must have been met, and both ways to lose a
  // target.
  for (const int children : {0, 1, 2, 3, 4, 6, 9})
    EXPECT_EQ(shapes.count(children), 1U) << children;
  EXPECT_GT(escapes, 1000);
  EXPECT_GT(remainders, 1000);
}

}  // namespace
