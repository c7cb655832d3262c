#include "sw/network/network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <tuple>

#include "sw/base/error.h"
#include "sw/network/measure.h"
#include "sw/network/raster.h"
#include "sw/network/tree.h"
#include "sw/network/write.h"
#include "tb/unit/network_oracle.h"

namespace rc2::network {
namespace {

using Rule = bool (*)(std::int64_t, std::int64_t, glm::ivec2);

const std::vector<std::string> kSchemes{"star", "chain", "tree", "nearest", "tree:3", "tree:4"};

std::vector<glm::ivec2> octant(int size) {
  std::vector<glm::ivec2> pixels;
  for (int x = 0; x <= size; ++x) {
    for (int y = 0; y <= x; ++y) pixels.emplace_back(x, y);
  }
  return pixels;
}

/// height[s][x] of every segment, from the definition.
std::vector<std::vector<int>> heights(int n, Rule rule) {
  std::vector<std::vector<int>> height(n + 1, std::vector<int>(n + 1));
  for (int s = 0; s <= n; ++s) {
    for (int x = 0; x <= n; ++x) {
      int& y = height[s][x];
      y = s * x / n;
      if (!rule(n, s, {x, y})) ++y;
      EXPECT_TRUE(rule(n, s, {x, y}));
    }
  }
  return height;
}

/// The cells that must be lit, one byte a cell.
std::vector<std::uint8_t> expected(Shape shape, const Network& network,
                                   const std::vector<int>& drawings) {
  std::vector<std::uint8_t> lit(network.cells.size(), 0);
  for (std::size_t cell = 0; cell < lit.size(); ++cell) {
    lit[cell] = std::any_of(drawings.begin(), drawings.end(), [&](int drawing) {
      return shape == Shape::Circles ? on_circle(drawing, network.cells[cell])
                                     : on_segment(network.size, drawing, network.cells[cell]);
    });
  }
  return lit;
}

std::vector<int> random_drawings(std::mt19937& random, int size) {
  std::vector<int> drawings(1 + random() % 8);
  for (int& drawing : drawings) drawing = static_cast<int>(random() % (size + 1));
  return drawings;
}

std::vector<int> depths_of(const Network& network) {
  std::vector<int> depth(network.cells.size(), 0);
  for (const Link& link : network.links) {
    depth[link.to] = std::max(depth[link.to], depth[link.from] + 1);
  }
  return depth;
}

TEST(NetworkRaster, CircleIsTheNearestPixelInEveryRow) {
  for (int radius = 0; radius <= 1024; ++radius) {
    const std::vector<glm::ivec2> arc = circle_arc(radius);
    int y = 0;
    for (const glm::ivec2 at : arc) {
      ASSERT_EQ(at.y, y++);
      ASSERT_LE(at.y, at.x);
      ASSERT_TRUE(on_circle(radius, at)) << radius << " in row " << at.y;
    }
    // The arc ends where the octant does: the next row's nearest pixel lies beyond the diagonal.
    for (int x = y; x <= radius; ++x) ASSERT_FALSE(on_circle(radius, {x, y})) << radius;
  }
}

TEST(NetworkRaster, SegmentIsTheNearestPixelInEveryColumn) {
  for (const int n : {1, 2, 3, 4, 5, 7, 16, 31, 32, 100, 127, 128, 512}) {
    for (int s = 0; s <= n; ++s) {
      const std::vector<glm::ivec2> pixels = segment(n, s);
      ASSERT_EQ(pixels.size(), n + 1);
      for (int x = 0; x <= n; ++x) {
        ASSERT_EQ(pixels[x].x, x);
        ASSERT_TRUE(on_segment(n, s, pixels[x])) << n << ' ' << s << ' ' << x;
      }
      EXPECT_EQ(pixels.back(), glm::ivec2(n, s));
    }
  }
}

TEST(NetworkRaster, TheTwoTieRulesAreMirrorImages) {
  for (int n = 1; n <= 64; ++n) {
    for (int s = 0; s <= n; ++s) {
      for (const glm::ivec2 at : segment(n, s)) {
        ASSERT_TRUE(on_printed_segment(n, n - s, {at.x, at.x - at.y})) << n << ' ' << s;
      }
    }
  }
}

// Thesis 2.4.1: "un cercle de rayon R et un cercle de rayon R+1 n'ont aucun pixel commun".
TEST(Circles, NoTwoShareAPixel) {
  std::set<std::pair<int, int>> seen;
  for (int radius = 0; radius <= 1024; ++radius) {
    for (const glm::ivec2 at : circle_arc(radius)) {
      ASSERT_TRUE(seen.emplace(at.x, at.y).second) << radius << ": " << at.x << ',' << at.y;
    }
  }
}

TEST(Circles, EveryOneIsDrawn) {
  for (const std::string& scheme : kSchemes) {
    for (const int size : {1, 2, 3, 10, 256}) {
      const Network network = build(Shape::Circles, size, scheme_of(scheme));
      for (int radius = 0; radius <= size; ++radius) {
        ASSERT_EQ(draw(network, {radius}), expected(Shape::Circles, network, {radius}))
            << scheme << " R=" << radius;
      }
    }
  }
}

// What is drawn is only compared on the cells that are there.
TEST(Circles, HaveOneCellForEachPixelOnACircle) {
  const Network network = build(Shape::Circles, 64, scheme_of("tree"));
  std::set<std::pair<int, int>> cells;
  for (const glm::ivec2 at : network.cells) EXPECT_TRUE(cells.emplace(at.x, at.y).second);
  for (const glm::ivec2 at : octant(64)) {
    bool any = false;
    for (int radius = 0; radius <= 64; ++radius) any = any || on_circle(radius, at);
    EXPECT_EQ(cells.count({at.x, at.y}) == 1, any) << at.x << ',' << at.y;
  }
}

TEST(Segments, EveryOneIsDrawn) {
  for (const std::string& scheme : kSchemes) {
    for (int n = 1; n <= 128; ++n) {
      const Network network = build(Shape::Segments, n, scheme_of(scheme));
      ASSERT_EQ(network.cells.size(), (n + 1) * (n + 2) / 2);
      for (int s = 0; s <= n; ++s) {
        ASSERT_EQ(draw(network, {s}), expected(Shape::Segments, network, {s}))
            << scheme << " N=" << n << " s=" << s;
      }
    }
  }
}

TEST(Segments, SamplesOf512AreDrawn) {
  std::mt19937 random(512);
  for (const std::string& scheme : kSchemes) {
    const Network network = build(Shape::Segments, 512, scheme_of(scheme));
    for (int sample = 0; sample < 24; ++sample) {
      const int s = static_cast<int>(random() % 513);
      ASSERT_EQ(draw(network, {s}), expected(Shape::Segments, network, {s})) << scheme << ' ' << s;
    }
  }
}

TEST(Networks, DrawSeveralAtOnceAsTheirUnion) {
  std::mt19937 random(1);
  for (const Shape shape : {Shape::Circles, Shape::Segments}) {
    for (const std::string& scheme : kSchemes) {
      for (const int size : {5, 33, 64}) {
        const Network network = build(shape, size, scheme_of(scheme));
        for (int sample = 0; sample < 40; ++sample) {
          const std::vector<int> drawings = random_drawings(random, size);
          ASSERT_EQ(draw(network, drawings), expected(shape, network, drawings)) << scheme;
        }
      }
    }
  }
}

TEST(Networks, LinksGoForwardAndAreThereOnce) {
  for (const Shape shape : {Shape::Circles, Shape::Segments}) {
    for (const std::string& scheme : kSchemes) {
      const Network network = build(shape, 48, scheme_of(scheme));
      const Link* last = nullptr;
      for (const Link& link : network.links) {
        EXPECT_LT(link.from, link.to);
        if (last != nullptr) {
          EXPECT_LT(std::tie(last->to, last->from), std::tie(link.to, link.from));
        }
        last = &link;
      }
    }
  }
}

// 2.4.2: a link needs every segment of its tail on its head.
TEST(Segments, NoLinkIsWrong) {
  for (const std::string& scheme : kSchemes) {
    for (const int n : {2, 3, 12, 31, 32, 60}) {
      const Network network = build(Shape::Segments, n, scheme_of(scheme));
      for (const Link& link : network.links) {
        for (int s = 0; s <= n; ++s) {
          ASSERT_TRUE(!on_segment(n, s, network.cells[link.from]) ||
                      on_segment(n, s, network.cells[link.to]))
              << scheme << " N=" << n;
        }
      }
    }
  }
}

/// The tails that segments.h asks for, found by trying every column, and the wrong links of
/// the plain scheme.
struct BruteForce {
  std::set<std::tuple<int, int, int, int>> links;  // tail x, y, head x, y
  std::set<std::tuple<int, int, int, int>> wrong;
  int threshold = 0;
};

BruteForce brute_force(int n, Scheme scheme) {
  const std::vector<std::vector<int>> height = heights(n, on_segment);
  const std::vector<int> parents = tree_parents(n + 1, scheme.fan_out);
  std::vector<int> level(n + 1, 0);
  for (int place = 1; place <= n; ++place) level[place] = level[parents[place]] + 1;
  const auto right = [&](int tail_x, int tail_y, int head_x, int head_y) {
    for (int s = 0; s <= n; ++s) {
      if (height[s][tail_x] == tail_y && height[s][head_x] != head_y) return false;
    }
    return true;
  };
  BruteForce result;
  std::map<std::pair<int, int>, int> depth;
  for (int x = n - 1; x >= 0; --x) {
    const int planned = n - parents[n - x];
    for (int s = 0; s <= n; ++s) {
      const int y = height[s][x];
      int best = -1;
      // From the end point inwards, so that the first of two equally near ones stays.
      for (int tail = n; tail > x; --tail) {
        const int tail_y = height[s][tail];
        if (!right(tail, tail_y, x, y)) continue;
        if (scheme.keep_depth && depth[{tail, tail_y}] >= level[n - x]) continue;
        if (best < 0 || std::abs(tail - planned) < std::abs(best - planned)) best = tail;
      }
      result.links.emplace(best, height[s][best], x, y);
      if (!right(planned, height[s][planned], x, y)) {
        result.wrong.emplace(planned, height[s][planned], x, y);
      }
      result.threshold = std::max(result.threshold, std::abs(best - planned));
    }
    for (int s = 0; s <= n; ++s) {
      for (const auto& [tail_x, tail_y, head_x, head_y] : result.links) {
        if (head_x != x || head_y != height[s][x]) continue;
        int& deep = depth[{head_x, head_y}];
        deep = std::max(deep, depth[{tail_x, tail_y}] + 1);
      }
    }
  }
  return result;
}

TEST(Segments, WrongLinksMoveToTheNearestRightTail) {
  for (const std::string& scheme : kSchemes) {
    for (const int n : {1, 2, 3, 4, 9, 16, 21, 24}) {
      const Network network = build(Shape::Segments, n, scheme_of(scheme));
      const BruteForce brute = brute_force(n, scheme_of(scheme));
      std::set<std::tuple<int, int, int, int>> links;
      for (const Link& link : network.links) {
        const glm::ivec2 tail = network.cells[link.from];
        const glm::ivec2 head = network.cells[link.to];
        links.emplace(tail.x, tail.y, head.x, head.y);
      }
      EXPECT_EQ(links, brute.links) << scheme << " N=" << n;
      EXPECT_EQ(network.repair.wrong, brute.wrong.size()) << scheme << " N=" << n;
      EXPECT_EQ(network.repair.threshold, brute.threshold) << scheme << " N=" << n;
    }
  }
}

TEST(Segments, ThePlainChainAndTreeAreWrongAndTheStarIsNot) {
  EXPECT_EQ(build(Shape::Segments, 64, scheme_of("star")).repair.wrong, 0);
  EXPECT_GT(build(Shape::Segments, 64, scheme_of("chain")).repair.wrong, 0);
  EXPECT_GT(build(Shape::Segments, 64, scheme_of("tree")).repair.wrong, 0);
}

TEST(NetworkDepth, OfAStarIsOneOfAChainItsLengthOfATreeLogarithmic) {
  for (const Shape shape : {Shape::Circles, Shape::Segments}) {
    for (const int size : {8, 20, 64, 100}) {
      const int places =
          shape == Shape::Circles ? static_cast<int>(circle_arc(size).size()) : size + 1;
      EXPECT_EQ(measure(build(shape, size, scheme_of("star"))).depth, 1);
      EXPECT_EQ(measure(build(shape, size, scheme_of("chain"))).depth, places - 1);
      for (const int fan_out : {2, 3, 4}) {
        // A full tree of depth d has 1 + F + ... + F^d places.
        int depth = 0;
        for (int room = 1, level = 1; room < places; room += level) {
          level *= fan_out;
          ++depth;
        }
        const int measured = measure(build(shape, size, {fan_out})).depth;
        EXPECT_EQ(measured, depth) << size << ' ' << fan_out;
      }
    }
  }
}

TEST(NetworkDepth, NoMovedLinkPutsACellDeeperThanPlanned) {
  for (const int n : {16, 50, 128}) {
    const Network network = build(Shape::Segments, n, scheme_of("tree"));
    const std::vector<int> parents = tree_parents(n + 1, 2);
    std::vector<int> level(n + 1, 0);
    for (int place = 1; place <= n; ++place) level[place] = level[parents[place]] + 1;
    const std::vector<int> depth = depths_of(network);
    for (std::size_t cell = 0; cell < depth.size(); ++cell) {
      EXPECT_LE(depth[cell], level[n - network.cells[cell].x]);
    }
  }
}

TEST(NetworkFanOut, OfACircleIsTheScheme) {
  for (const int fan_out : {1, 2, 3, 5}) {
    const Measures measures = measure(build(Shape::Circles, 100, {fan_out}));
    EXPECT_EQ(measures.max_fan_out, fan_out);
    EXPECT_EQ(measures.max_fan_in, 1);
  }
  EXPECT_EQ(measure(build(Shape::Circles, 100, scheme_of("star"))).max_fan_out,
            circle_arc(100).size() - 1);
}

// Remark of 2.4.2: right of the middle column a cell of the star has at most two inputs.
TEST(Segments, AtMostTwoPassRightOfTheMiddle) {
  for (int n = 1; n <= 256; ++n) {
    const std::vector<std::vector<int>> height = heights(n, on_segment);
    for (int x = n / 2 + 1; x <= n; ++x) {
      for (int s = 0; s + 2 <= n; ++s) ASSERT_NE(height[s][x], height[s + 2][x]) << n;
    }
  }
}

/// Pixels of the theorem of 2.4.2: s and s+1 share (x, y), part on its right and on its left, and
/// cross over nothing.
int shared_pixels(int n, Rule rule) {
  const std::vector<std::vector<int>> height = heights(n, rule);
  int found = 0;
  for (int s = 0; s < n; ++s) {
    for (int x = 1; x < n; ++x) {
      const int y = height[s][x];
      if (height[s + 1][x] == y && height[s][x + 1] == y && height[s + 1][x + 1] == y + 1 &&
          height[s + 1][x - 1] == y && height[s][x - 1] == y - 1) {
        ++found;
      }
    }
  }
  return found;
}

TEST(SharedPixels, ExistForEveryNFromThree) {
  for (const Rule rule : {on_segment, on_printed_segment}) {
    EXPECT_EQ(shared_pixels(1, rule), 0);
    EXPECT_EQ(shared_pixels(2, rule), 0);
    for (int n = 3; n <= 256; ++n) ASSERT_GT(shared_pixels(n, rule), 0) << n;
  }
}

// Lemma of 4.1.4: some segment from the origin to the last column passes through any given pixel.
TEST(Lemma, EveryPixelIsReached) {
  for (const Rule rule : {on_segment, on_printed_segment}) {
    for (int n = 1; n <= 512; n += n < 256 ? 1 : 64) {
      const std::vector<std::vector<int>> height = heights(n, rule);
      for (int x = 0; x <= n; ++x) {
        std::vector<bool> reached(x + 1, false);
        for (int s = 0; s <= n; ++s) reached.at(height[s][x]) = true;
        ASSERT_EQ(std::count(reached.begin(), reached.end(), false), 0) << n << ' ' << x;
      }
    }
  }
}

Network wires(const std::vector<glm::ivec2>& cells, const std::vector<Link>& links) {
  Network network;
  network.cells = cells;
  network.links = links;
  return network;
}

TEST(Planarity, StraightWiresAreJudgedExactly) {
  const std::vector<glm::ivec2> square{{0, 0}, {0, 2}, {2, 2}, {2, 0}, {1, 1}, {4, 4}, {5, 0}};
  const auto judge = [&](const std::vector<Link>& links) {
    const Disturbances found = straight_wires(wires(square, links));
    return std::vector<std::int64_t>{found.crossings, found.overlaps, found.through};
  };
  using Counts = std::vector<std::int64_t>;
  EXPECT_EQ(judge({{0, 1}, {2, 3}}), (Counts{0, 0, 0})) << "parallel";
  EXPECT_EQ(judge({{0, 2}, {1, 3}}), (Counts{1, 0, 0})) << "diagonals";
  EXPECT_EQ(judge({{0, 2}, {0, 3}}), (Counts{0, 0, 0})) << "a common end";
  EXPECT_EQ(judge({{0, 2}, {0, 5}}), (Counts{0, 1, 0})) << "one on the other";
  EXPECT_EQ(judge({{0, 4}, {4, 2}}), (Counts{0, 0, 0})) << "one after the other";
  EXPECT_EQ(judge({{0, 2}, {2, 0}}), (Counts{0, 1, 0})) << "the same twice";
  EXPECT_EQ(judge({{0, 2}, {1, 4}}), (Counts{0, 0, 1})) << "ending inside";
  EXPECT_EQ(judge({{0, 4}, {2, 5}}), (Counts{0, 0, 0})) << "on one line, apart";
  EXPECT_EQ(judge({{0, 1}, {4, 6}}), (Counts{0, 0, 0})) << "pointing at, not reaching";
}

TEST(Planarity, PagesCountCrossedWires) {
  const std::vector<glm::ivec2> line(8, glm::ivec2(0, 0));
  EXPECT_EQ(page(wires(line, {{0, 2}, {1, 3}})).crossed, 1);
  EXPECT_EQ(page(wires(line, {{0, 3}, {1, 2}, {3, 4}})).crossed, 0);
  EXPECT_EQ(page(wires(line, {{0, 3}, {1, 2}, {3, 4}})).tracks, 2);
  EXPECT_EQ(page(wires(line, {{0, 1}, {0, 2}, {0, 3}})).crossed, 0);
}

// 2.4.1 claims a planar graph: true with the wires beside their arcs, which do not meet each other;
// false with straight wires, but for the chain.
TEST(Planarity, OfCirclesHoldsBesideTheArcAndNotForStraightWires) {
  for (const std::string& scheme : kSchemes) {
    const Network network = build(Shape::Circles, 128, scheme_of(scheme));
    EXPECT_EQ(page(network).crossed, 0) << scheme;
    EXPECT_EQ(straight_wires(network).none(), scheme == "chain") << scheme;
  }
}

TEST(NetworkDescription, IsTheNetwork) {
  const Network network = build(Shape::Segments, 20, scheme_of("tree"));
  const auto json = nlohmann::json::parse(description(network));
  EXPECT_EQ(json["size"], 20);
  ASSERT_EQ(json["cells"].size(), network.cells.size());
  ASSERT_EQ(json["links"].size(), network.links.size());
  Network copy;
  copy.starts = json["starts"].get<std::vector<int>>();
  for (const auto& at : json["cells"]) copy.cells.emplace_back(at[0], at[1]);
  for (const auto& link : json["links"]) copy.links.push_back({link[0], link[1]});
  EXPECT_EQ(copy.cells, network.cells);
  for (int s = 0; s <= 20; ++s) EXPECT_EQ(draw(copy, {s}), draw(network, {s}));
}

TEST(NetworkInput, ThatMakesNoSenseIsRefused) {
  EXPECT_THROW(build(Shape::Circles, 0, {2}), Error);
  EXPECT_THROW(build(Shape::Segments, kMaxSize + 1, {2}), Error);
  EXPECT_THROW(build(Shape::Circles, 8, {0}), Error);
  for (const char* name :
       {"", "stars", "tree:", "tree:0", "tree:-2", "tree:2x", "tree:99999999999"}) {
    EXPECT_THROW(scheme_of(name), Error) << name;
  }
  EXPECT_THROW(shape_of("ellipses"), Error);
}

}  // namespace
}  // namespace rc2::network
