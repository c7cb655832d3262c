#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <tuple>

#include "sw/thesis/engine.h"
#include "sw/thesis/snapshots.h"
#include "sw/thesis/tables.h"

namespace rc2::thesis {
namespace {

// A table as the thesis prints it, with its heading.
std::string printed(const std::string& table) {
  std::ifstream file(std::string(RC2_SOURCE_DIR "/docs/thesis/diffusion_") + table + ".csv");
  EXPECT_TRUE(file) << table;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct SweepRow {
  int n, fa;
  double t;
};

std::vector<SweepRow> printed_sweep(int n) {
  std::istringstream lines(printed("fa_sweep"));
  std::vector<SweepRow> rows;
  for (std::string line; std::getline(lines, line);) {
    SweepRow row{};
    if (std::sscanf(line.c_str(), "%d,%d,%lf", &row.n, &row.fa, &row.t) == 3 && row.n == n) {
      rows.push_back(row);
    }
  }
  return rows;
}

using Voxel = std::tuple<int, int, int>;
using Voxels = std::set<Voxel>;

bool inside(int n, const glm::ivec3& p) {
  return std::min({p.x, p.y, p.z}) >= 0 && std::max({p.x, p.y, p.z}) < n;
}

// The integer nearest to target * steps / distance, ties downwards, by trying one after another.
int offset_on_ray(int target, int steps, int distance) {
  int offset = -std::abs(target) * steps - 1;
  while (2 * target * steps - 2 * distance * offset > distance) ++offset;
  return offset;
}

// The voxels on the digital rays to all targets, one ray after another: no beams, no time.
Voxels voxels_on_rays(const Experiment& experiment) {
  Voxels voxels;
  for (const Beam& cone : experiment.cones) {
    const int u_axis = cone.axis == 0 ? 1 : 0;
    const int v_axis = cone.axis == 2 ? 1 : 2;
    for (int u = cone.u.first; u <= cone.u.last; ++u) {
      for (int v = cone.v.first; v <= cone.v.last; ++v) {
        for (int steps = 0;; ++steps) {
          glm::ivec3 at = experiment.source;
          at[cone.axis] += cone.side * steps;
          at[u_axis] += offset_on_ray(u, steps, experiment.distance);
          at[v_axis] += offset_on_ray(v, steps, experiment.distance);
          if (!inside(experiment.n, at)) break;
          voxels.insert({at.x, at.y, at.z});
        }
      }
    }
  }
  return voxels;
}

Voxels reached(const Engine& engine, int n) {
  Voxels voxels;
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        if (engine.reached({x, y, z})) voxels.insert({x, y, z});
      }
    }
  }
  return voxels;
}

std::size_t cube(int n) {
  const auto side = static_cast<std::size_t>(n);
  return side * side * side;
}

// Every kind of set-up at side n, with short queues and long ones.
std::vector<Experiment> all_experiments(int n) {
  std::vector<Experiment> experiments = {one_cone(n, 0), one_cone(n, 1), one_cone(n, 2),
                                         plane(n),       corner(n, {}),  centre(n, {})};
  for (const Conflict conflict : {Conflict::kHeadWaits, Conflict::kBackToTail}) {
    for (const int fa : {1, 2, 5}) {
      experiments.push_back(corner(n, fa, conflict));
      experiments.push_back(centre(n, fa, conflict));
    }
  }
  Experiment skew = centre(n, 2);
  skew.source = {0, n - 1, n / 3};
  skew.distance = 2 * n + 1;
  for (Beam& cone : skew.cones) {
    cone.u = {-skew.distance, skew.distance};
    cone.v = {-skew.distance, skew.distance / 2};
  }
  experiments.push_back(skew);
  return experiments;
}

TEST(ThesisTable, LongestQueuesComeOutExactly) {
  EXPECT_EQ(to_csv({Table::kFaMax, {1, 64}, {}}, {}), printed("fa_max"));
}

TEST(ThesisTable, LongQueuesOfTheSweepComeOutExactly) {
  const Cost cost = run(corner(32, {}));
  EXPECT_EQ(cost.cycles, 195);
  const auto rows = printed_sweep(32);
  ASSERT_EQ(rows.size(), 31U);
  for (const SweepRow& row : rows) {
    if (row.fa < cost.longest_queue) continue;
    EXPECT_EQ(row.t, 195) << "FA = " << row.fa;
    EXPECT_EQ(run(corner(32, row.fa)).cycles, 195) << "FA = " << row.fa;
  }
}

TEST(ThesisTable, LastFrameOfTheLongQueueSnapshotsComesOutExactly) {
  EXPECT_EQ(run(centre(16, 16)).cycles, 144);
}

// What docs/thesis-tables.md says of the rows that do not come out exactly.
TEST(ThesisTable, ShortQueuesComeNear) {
  double log_error = 0;
  const auto rows = printed_sweep(32);
  for (const SweepRow& row : rows) {
    const double ratio = static_cast<double>(run(corner(32, row.fa)).cycles) / row.t;
    EXPECT_GT(ratio, 1 / 1.65) << "FA = " << row.fa;
    EXPECT_LT(ratio, 1.65) << "FA = " << row.fa;
    log_error += std::abs(std::log(ratio));
  }
  EXPECT_LT(log_error / static_cast<double>(rows.size()), 0.084);

  std::istringstream lines(printed("fa1"));
  for (std::string line; std::getline(lines, line);) {
    int n = 0;
    double t = 0;
    if (std::sscanf(line.c_str(), "%d,%lf", &n, &t) != 2 || n > 24) continue;
    const double ratio = static_cast<double>(run(corner(n, 1)).cycles) / t;
    EXPECT_GT(ratio, 1 / 1.65) << "n = " << n;
    EXPECT_LT(ratio, 1.65) << "n = " << n;
  }
}

TEST(ThesisTable, RowsHaveTheColumnsOfThePrintedTables) {
  EXPECT_EQ(to_csv({Table::kFa1, {2, 3}, {}}, {}).substr(0, 6), "n,t\n2,");
  const std::string sweep = to_csv({Table::kFaSweep, {4, 5}, Range{2, 3}}, {});
  EXPECT_EQ(std::count(sweep.begin(), sweep.end(), '\n'), 5);
  EXPECT_EQ(sweep.substr(0, 11), "n,fa,t\n4,2,");
  EXPECT_NE(sweep.find("\n5,3,"), std::string::npos);
}

TEST(ThesisTable, RefusesRangesWithoutMeaning) {
  EXPECT_NO_THROW(check({Table::kFaMax, {1, kMaxSide}, {}}));
  EXPECT_THROW(check({Table::kFaMax, {0, 4}, {}}), Error);
  EXPECT_THROW(check({Table::kFaMax, {5, 4}, {}}), Error);
  EXPECT_THROW(check({Table::kFaMax, {5, kMaxSide + 1}, {}}), Error);
  EXPECT_THROW(check({Table::kFa1, {1, 4}, {}}), Error);
  EXPECT_THROW(check({Table::kFa1, {2, 4}, Range{1, 1}}), Error);
  EXPECT_THROW(check({Table::kFaSweep, {2, 4}, {}}), Error);
  EXPECT_THROW(check({Table::kFaSweep, {2, 4}, Range{0, 1}}), Error);
}

TEST(ThesisPartition, EveryTargetHasOneOffset) {
  for (const int distance : {1, 4, 7, 15, 30}) {
    const Partition partition(8, distance);
    for (int steps = 1; steps <= 8; ++steps) {
      for (int target = -distance; target <= distance; ++target) {
        const int expected = offset_on_ray(target, steps, distance);
        for (int offset = -8; offset <= 8; ++offset) {
          const Interval through = partition.through(offset, steps);
          EXPECT_EQ(target >= through.first && target <= through.last, offset == expected)
              << "target " << target << " of " << distance << " after " << steps << " steps";
        }
      }
    }
  }
}

TEST(ThesisEngine, ReachesTheVoxelsOnTheRaysAndNoOthers) {
  for (const int n : {1, 2, 3, 4, 7, 10}) {
    for (const Experiment& experiment : all_experiments(n)) {
      Engine engine(experiment);
      while (!engine.done()) engine.step();
      EXPECT_EQ(reached(engine, n), voxels_on_rays(experiment)) << "n = " << n;
      EXPECT_EQ(engine.home(), engine.targets()) << "n = " << n;
    }
  }
}

TEST(ThesisEngine, FillsTheCube) {
  for (int n = 1; n <= 12; ++n) {
    EXPECT_EQ(voxels_on_rays(corner(n, {})).size(), cube(n));
    for (const Experiment& experiment : {corner(n, 1), centre(n, 1)}) {
      Engine engine(experiment);
      while (!engine.done()) engine.step();
      EXPECT_EQ(reached(engine, n).size(), cube(n)) << "n = " << n;
    }
  }
}

// A beam goes one voxel in a cycle at most, and some cell always has something to do.
TEST(ThesisEngine, EveryCycleServesABeamAndNoneMovesFarther) {
  for (const int n : {2, 5, 9}) {
    for (const Experiment& experiment : all_experiments(n)) {
      Engine engine(experiment);
      while (!engine.done()) {
        const std::int64_t before = engine.visits();
        engine.step();
        ASSERT_GT(engine.visits(), before);
        ASSERT_LE(engine.visits() - before, n * n);
        for (const auto& [x, y, z] : reached(engine, n)) {
          const glm::ivec3 way = glm::ivec3(x, y, z) - experiment.source;
          ASSERT_LE(std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)}), engine.cycles());
        }
      }
    }
  }
}

TEST(ThesisEngine, QueuesThatNeverFillCostNothing) {
  for (const int n : {8, 13}) {
    const Cost endless = run(corner(n, {}));
    const Cost deep = run(corner(n, kMaxFa));
    EXPECT_EQ(endless.cycles, deep.cycles);
    EXPECT_EQ(endless.visits, deep.visits);
    EXPECT_LT(endless.cycles, run(corner(n, 1)).cycles);
    EXPECT_EQ(endless.visits, run(corner(n, 1)).visits) << "waiting must not change the beams";
  }
}

// Thesis 4.2.4: N rays take N + n cycles, and the example with n = 8 ends at time 14, which is the
// 15th cycle.
TEST(ThesisModes, RaysOneByOneNeverMeet) {
  EXPECT_EQ(run(one_by_one(plane(8))).cycles, 14 + 1);
  for (const int n : {2, 5, 12}) {
    EXPECT_EQ(run(one_by_one(plane(n))).cycles, n + n - 1);
    const Cost cone = run(one_by_one(one_cone(n, 0)));
    EXPECT_EQ(cone.cycles, n * n + n - 1);
    EXPECT_EQ(cone.visits, n * n * n);
  }
}

// Along z they do meet, in the column of their cell, which the thesis overlooks.
TEST(ThesisModes, RaysAlongACellsColumnMeet) {
  EXPECT_GT(run(one_by_one(one_cone(8, 2))).cycles, 8 * 8 + 8);
}

TEST(ThesisModes, OneByOneSendsTheSameTargets) {
  for (const Experiment& experiment : {plane(6), corner(6, {}), centre(5, 2)}) {
    const Experiment rays = one_by_one(experiment);
    std::size_t targets = 0;
    for (const Beam& cone : experiment.cones) targets += static_cast<std::size_t>(cone.targets());
    EXPECT_EQ(rays.cones.size(), targets);
    EXPECT_EQ(voxels_on_rays(rays), voxels_on_rays(experiment));
  }
}

// The black squares of a row's slices and of its array.
std::pair<int, int> black_pixels(const ContactSheet& sheet, std::size_t row) {
  const picture::Raster& raster = sheet.raster;
  const int height = (raster.height - 6) / static_cast<int>(sheet.times.size());
  const int label = 6 * 12;
  const int array = raster.width - 6 - 64;
  std::pair<int, int> black;
  for (int y = static_cast<int>(row) * height; y < static_cast<int>(row + 1) * height; ++y) {
    for (int x = label; x < raster.width; ++x) {
      const auto& pixel = raster.pixels.begin()[std::ptrdiff_t{y} * raster.width + x];
      if (pixel == decltype(pixel){}) ++(x < array ? black.first : black.second);
    }
  }
  return black;
}

TEST(ThesisSnapshots, ShowTheSourceFirstAndTheWholeCubeLast) {
  const Experiment experiment = centre(8, 2);
  const ContactSheet sheet = draw_contact_sheet(experiment, {0, 10});
  const auto end = run(experiment).cycles;
  ASSERT_EQ(sheet.times, (std::vector<std::int64_t>{0, 10, end}));
  constexpr int kSquare = 8 * 8;
  EXPECT_EQ(black_pixels(sheet, 0), std::pair(kSquare, kSquare));
  EXPECT_EQ(black_pixels(sheet, 2), std::pair(8 * 8 * 8 * kSquare, 0));

  Engine engine(experiment);
  for (int cycle = 0; cycle < 10; ++cycle) engine.step();
  EXPECT_EQ(black_pixels(sheet, 1).first, kSquare * static_cast<int>(reached(engine, 8).size()));
  int busy = 0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) busy += static_cast<int>(engine.busy(x, y));
  }
  EXPECT_EQ(black_pixels(sheet, 1).second, kSquare * busy);
}

TEST(ThesisSnapshots, RefuseTimesAfterTheEndAndInDisorder) {
  EXPECT_THROW(draw_contact_sheet(centre(4, 1), {1000}), Error);
  EXPECT_THROW(draw_contact_sheet(centre(4, 1), {3, 2}), Error);
}

}  // namespace
}  // namespace rc2::thesis
