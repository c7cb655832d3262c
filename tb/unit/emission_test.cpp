// The ways of finding out what a light reaches (thesis 4.1, 4.2), against each other, the golden
// model, the thesis's engine and the thesis's printed table.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "sw/emission/beams.h"
#include "sw/emission/rays.h"
#include "sw/golden/diffuse.h"
#include "sw/lines/bresenham.h"
#include "sw/thesis/engine.h"

namespace rc2::emission {
namespace {

using golden::Grid;

struct World {
  World(int n, double share, unsigned seed) : grid(n) {
    std::mt19937 random(seed);
    std::bernoulli_distribution is_occupied(share);
    for (glm::ivec3 at{0}; at.z < n; ++at.z)
      for (at.y = 0; at.y < n; ++at.y)
        for (at.x = 0; at.x < n; ++at.x) {
          if (at == source || !is_occupied(random)) continue;
          grid[grid.index(at)] = static_cast<std::uint32_t>(voxels.size());
          voxels.push_back(at);
        }
  }

  Ledger ledger() const { return {grid, voxels.size()}; }

  glm::ivec3 source{1, 3, 2};
  Grid grid;
  std::vector<glm::ivec3> voxels;
};

void expect_same(const Ledger& a, const Ledger& b) {
  EXPECT_EQ(a.lit(), b.lit());
  EXPECT_EQ(a.untouched(), b.untouched());
  EXPECT_EQ(a.cost().visits, b.cost().visits);
  EXPECT_EQ(a.cost().messages, b.cost().messages);
  EXPECT_EQ(a.cost().busiest, b.cost().busiest);
}

TEST(Emission, RaysToTheVirtualFacesAreGoldens) {
  for (const int n : {5, 8, 11}) {
    const World world(n, 0.1, static_cast<unsigned>(n));
    LightMemory arrived(world.voxels.size());
    std::vector<golden::Matter> field(world.grid.size(), golden::Matter::outside);
    for (std::size_t place = 0; place < field.size(); ++place) {
      const std::uint32_t holds = world.grid[static_cast<std::ptrdiff_t>(place)];
      if (holds == Grid::kFree) field[place] = golden::Matter::free;
      if (holds < Grid::kOutside) field[place] = golden::Matter::stop;
    }
    const auto golden = golden::diffuse(world.grid, field, world.source, n - 1, arrived, {});
    Ledger ledger = world.ledger();
    send_one_by_one(ledger, Targets::virtual_, world.source);
    EXPECT_EQ(ledger.cost().rays, golden.targets.total);
    EXPECT_EQ(ledger.cost().visits, golden.visits);
    EXPECT_EQ(ledger.lit(), (std::vector<bool>{arrived.begin(), arrived.end()}));
  }
}

TEST(Emission, BeamsLightWhatTheirRaysLight) {
  for (const int n : {5, 8, 11}) {
    const World world(n, 0.1, static_cast<unsigned>(n));
    Ledger rays = world.ledger(), beams = world.ledger(), table = world.ledger();
    send_one_by_one(rays, Targets::virtual_, world.source);
    send_beams(beams, world.source);
    EXPECT_EQ(beams.lit(), rays.lit());
    EXPECT_EQ(beams.untouched(), rays.untouched());
    EXPECT_LT(beams.cost().visits, rays.cost().visits);
    // A beam is the rays that have come the same way, whoever says where it parts.
    EXPECT_GT(send_beams_by_table(table, world.source), 0);
    expect_same(table, beams);
  }
}

// The engine counts the six beams in the source's voxel too, and shares no target out.
TEST(Emission, EnginesBeams) {
  const int n = 8;
  const World empty(n, 0, 0);
  Ledger beams = empty.ledger();
  send_beams(beams, glm::ivec3((n - 1) / 2));
  thesis::Experiment experiment = thesis::centre(n, {});
  for (thesis::Beam& cone : experiment.cones) {
    if (cone.axis > 0) cone.u = {1 - experiment.distance, experiment.distance - 1};
    if (cone.axis > 1) cone.v = cone.u;
  }
  EXPECT_EQ(beams.cost().visits + 6, thesis::run(experiment).visits);
}

TEST(Emission, AskingFollowsBresenhamsLine) {
  const World world(9, 0.05, 3);
  Ledger ledger = world.ledger();
  ask_light(ledger, world.voxels, world.source);
  std::int64_t visits = 0, messages = 0;
  for (std::size_t i = 0; i < world.voxels.size(); ++i) {
    const glm::ivec3 from = world.voxels[i];
    glm::ivec3 last = from;
    bool is_lit = true;
    lines::bresenham(from, world.source, [&](const glm::ivec3& at) {
      if (at == from || !is_lit) return;
      ++visits;
      messages += at.x != last.x || at.y != last.y;
      last = at;
      is_lit = world.grid[world.grid.index(at)] == Grid::kFree;
    });
    messages += std::max(std::abs(last.x - from.x), std::abs(last.y - from.y));
    EXPECT_EQ(ledger.lit()[i], is_lit) << i;
  }
  EXPECT_EQ(ledger.cost().rays, 2 * static_cast<std::int64_t>(world.voxels.size()));
  EXPECT_EQ(ledger.cost().visits, visits);
  EXPECT_EQ(ledger.cost().messages, messages);
}

// Thesis 4.1.4, proved there for one octant of a plane: rays to the border fill the empty cube.
TEST(Emission, BorderFillsTheCubeFromAnywhere) {
  for (const int n : {2, 3, 4, 5, 6, 7}) {
    const World empty(n, 0, 0);
    for (int place = 0; place < n * n * n; ++place) {
      const glm::ivec3 source(place % n, place / n % n, place / n / n);
      for (const Targets targets : {Targets::border, Targets::virtual_}) {
        Ledger ledger = empty.ledger();
        send_one_by_one(ledger, targets, source);
        EXPECT_EQ(ledger.untouched(), 1) << n << ' ' << place;
      }
    }
  }
}

TEST(Emission, NumbersOfRays) {
  const int n = 8;
  const World empty(n, 0, 0);
  const auto rays = [&](Targets targets, const glm::ivec3& source) {
    Ledger ledger = empty.ledger();
    send_one_by_one(ledger, targets, source);
    return ledger.cost().rays;
  };
  EXPECT_EQ(rays(Targets::voxels, {3, 3, 3}), n * n * n - 1);
  EXPECT_EQ(rays(Targets::border, {3, 3, 3}), 6 * (n - 1) * (n - 1) + 2);
  EXPECT_EQ(rays(Targets::border, {0, 0, 0}), 6 * (n - 1) * (n - 1) + 1);
  EXPECT_EQ(rays(Targets::virtual_, {0, 0, 0}), 24 * (n - 1) * (n - 1) + 2);
}

// "Exemple de table pour N=16" (4.3.2), 15 steps of each ray. The last row but two is printed
// 111011111111011, which is not the complement of row 2, as the thesis itself wants it.
TEST(PathTable, PrintedTable) {
  EXPECT_EQ(PathTable(0, 15, 15).paths(),
            (std::vector<Path>{
                "000000000000000", "000000010000000", "000100000001000", "001000010000100",
                "010001000100010", "010010010010010", "010100101001010", "010101010101010",
                "101010101010101", "101011010110101", "101101101101101", "101110111011101",
                "110111101111011", "111011111110111", "111111101111111", "111111111111111"}));
}

// F0 and F1 of the first ways (4.3.2).
TEST(PathTable, PrintedChoices) {
  const PathTable table(0, 3, 3);
  std::int64_t looks = 0;
  const auto choice = [&](const Path& way) {
    return std::make_pair(table.has(way + '0', looks), table.has(way + '1', looks));
  };
  for (const char* way : {"0", "1"}) EXPECT_EQ(choice(way), std::make_pair(true, true)) << way;
  for (const char* way : {"00", "01"}) EXPECT_EQ(choice(way), std::make_pair(true, false)) << way;
  for (const char* way : {"10", "11"}) EXPECT_EQ(choice(way), std::make_pair(false, true)) << way;
  EXPECT_GT(looks, 0);
}

// 4.3.2: half the table is the complement of the other, if no ray ties between two voxels; N = 16
// has two ways that are alike in nine steps and part in the tenth; about 2n/3 steps are enough.
TEST(PathTable, PrintedFacts) {
  for (const int n : {4, 16, 34}) {
    const std::vector<Path> paths = PathTable(0, n - 1, n - 1).paths();
    for (std::size_t i = 0; i < paths.size(); ++i) {
      Path complement = paths[paths.size() - 1 - i];
      for (char& step : complement) step = step == '0' ? '1' : '0';
      EXPECT_EQ(paths[i], complement) << n << ' ' << i;
    }
  }
  EXPECT_EQ(octant_facts(16).last_steps, 10);
  for (const int n : {64, 128}) EXPECT_NEAR(octant_facts(n).last_steps, 2 * n / 3.0, 1.5) << n;
}

// Every way that a beam can have come, counted apart.
TEST(PathTable, Prefixes) {
  std::set<Path> ways;
  const PathTable table(0, 8, 8);
  for (const Path& path : table.paths())
    for (std::size_t length = 0; length < path.size(); ++length)
      ways.insert(path.substr(0, length));
  EXPECT_EQ(octant_facts(9).prefixes, static_cast<std::int64_t>(ways.size()));
}

}  // namespace
}  // namespace rc2::emission
