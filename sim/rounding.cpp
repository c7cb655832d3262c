// Chapter 3: voxels from coefficients of few bits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/commands.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/base/replace_file.h"
#include "sw/scene/random.h"
#include "sw/scene/shapes.h"
#include "sw/surface/rounding_error.h"

namespace rc2 {
namespace {

using scene::Random;
using scene::Scene;
using surface::kRoundings;
using surface::Rounding;
using surface::RoundingError;

constexpr int kSmallest = 20, kLargest = 512;  // sides; a sphere fits into the smallest

struct RoundingOptions {
  std::vector<int> sides = {64, 256};
  std::vector<int> bits = {8, 10, 12, 14, 16, 18, 20, 22, 24};
  std::string out;
};

// So few that they rarely overlap.
Scene random_facets(int n, Random& random) {
  Scene scene;
  scene.materials.resize(1);
  scene::add_random_triangles(scene, n / 4, n, random, 0);
  return scene;
}

// Of 1280 triangles at n = 64, 5120 at n = 256: finer, but less than the voxels.
Scene sphere(int n, Random& random) {
  Scene scene;
  scene.materials.resize(1);
  glm::dvec3 centre;
  for (int axis = 0; axis < 3; ++axis) centre[axis] = 0.5 * (n - 1) + random.between(-1, 1);
  const double radius = random.between(0.3 * n, 0.45 * n);
  scene::add_sphere(scene, centre, radius, radius / std::sqrt(n), 0);
  return scene;
}

struct Family {
  const char* name;
  bool closed;
  Scene (*make)(int n, Random& random);
  int (*scenes)(int n);  // how many
};

constexpr Family kFamilies[] = {
    {"random", false, random_facets, [](int n) { return 1024 / n; }},
    {"sphere", true, sphere, [](int n) { return std::max(1, 256 / n); }}};

// Sums over the scenes of a family.
struct Row {
  int bits;
  std::array<RoundingError, kRoundings.size()> errors;
};

struct Table {
  const Family* family;
  int n, scenes;
  std::int64_t facets = 0, voxels = 0;
  std::vector<Row> rows;

  double relative(const RoundingError& error) const {
    return static_cast<double>(error.missing + error.extra) / static_cast<double>(voxels);
  }
};

Table measure(const Family& family, int n, const std::vector<int>& bits, ProgressBar& bar) {
  Table table{&family, n, family.scenes(n), 0, 0, {}};
  for (const int w : bits) table.rows.push_back({w, {}});
  const Progress progress = bar.step(fmt::format("{}, n = {}", family.name, n));
  const auto steps = static_cast<double>(table.scenes) * static_cast<double>(bits.size());
  int done = 0;
  Random random(1);
  for (int i = 0; i < table.scenes; ++i) {
    const surface::RoundingTrial trial(family.make(n, random), n);
    table.facets += trial.facets();
    table.voxels += trial.voxels();
    for (Row& row : table.rows) {
      for (std::size_t k = 0; k < kRoundings.size(); ++k) {
        const RoundingError found = trial.measure(row.bits, kRoundings[k]);
        row.errors[k].missing += found.missing;
        row.errors[k].extra += found.extra;
        row.errors[k].tunnels.by_6 += found.tunnels.by_6;
        row.errors[k].tunnels.by_26 += found.tunnels.by_26;
      }
      progress("rounding", 0, ++done / steps);
    }
  }
  return table;
}

void print_table(const Table& table) {
  fmt::print("\n{}, n = {}; scenes: {}, facets: {}, voxels: {}\n", table.family->name, table.n,
             table.scenes, table.facets, table.voxels);
  std::vector<const char*> titles = {"voxel error", "voxels missing"};
  if (table.family->closed) titles.insert(titles.end(), {"6-tunnels", "26-tunnels"});
  fmt::print("{:4}", "");
  for (const char* title : titles) fmt::print("   {:-^27}", fmt::format(" {} ", title));
  fmt::print("\n{:>4}", "W");
  for (std::size_t i = 0; i < titles.size(); ++i) {
    fmt::print("   ");
    for (const Rounding rounding : kRoundings) fmt::print("{:>9}", to_string(rounding));
  }
  fmt::print("\n");
  for (const Row& row : table.rows) {
    fmt::print("{:>4}   ", row.bits);
    const auto print_all = [&](const auto& value) {
      for (const RoundingError& error : row.errors) fmt::print("{:>9}", value(error));
    };
    print_all([&](const RoundingError& error) {
      return error.missing + error.extra == 0 ? "0" : fmt::format("{:.1e}", table.relative(error));
    });
    fmt::print("   ");
    print_all([](const RoundingError& error) { return error.missing; });
    if (table.family->closed) {
      fmt::print("   ");
      print_all([](const RoundingError& error) { return error.tunnels.by_6; });
      fmt::print("   ");
      print_all([](const RoundingError& error) { return error.tunnels.by_26; });
    }
    fmt::print("\n");
  }
}

std::string to_csv(const std::vector<Table>& tables) {
  std::string csv =
      "scene,n,scenes,facets,voxels,bits,rounding,missing,extra,error,tunnels_6,tunnels_26\n";
  for (const Table& table : tables) {
    for (const Row& row : table.rows) {
      for (std::size_t k = 0; k < kRoundings.size(); ++k) {
        const RoundingError& error = row.errors[k];
        const auto tunnels = [&](std::int64_t count) {
          return table.family->closed ? std::to_string(count) : std::string();
        };
        csv +=
            fmt::format("{},{},{},{},{},{},{},{},{},{:.9f},{},{}\n", table.family->name, table.n,
                        table.scenes, table.facets, table.voxels, row.bits,
                        to_string(kRoundings[k]), error.missing, error.extra, table.relative(error),
                        tunnels(error.tunnels.by_6), tunnels(error.tunnels.by_26));
      }
    }
  }
  return csv;
}

ExitCode measure_rounding(const RoundingOptions& options) {
  Outputs outputs;
  if (!options.out.empty()) outputs.add_file(options.out);
  ProgressBar bar;
  std::vector<Table> tables;
  for (const Family& family : kFamilies)
    for (const int n : options.sides)
      within_memory(n, [&] { tables.push_back(measure(family, n, options.bits, bar)); });
  bar.wipe();
  fmt::print(
      "Plane coefficients rounded to W bits (armoured rule, sides exact). origin: D scaled and\n"
      "rounded as A, B, C are; centroid: D anew, for a plane through the facet's centroid;\n"
      "widened: a slab thick enough to lose no voxel. Voxel error: those missing and those too\n"
      "many, over all.\n");
  for (const Table& table : tables) print_table(table);
  if (!options.out.empty()) replace_file(options.out, to_csv(tables));
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_rounding(Command& program) {
  auto options = std::make_shared<RoundingOptions>();
  Command command = program.command(
      "rounding", "Measures what coefficients of few bits do to a scene's voxels (chapter 3)");
  command
      .option("--n", options->sides,
              fmt::format("Sides of the cube, {} to {}", kSmallest, kLargest))
      .list()
      .within(kSmallest, kLargest);
  const int exact = plane_bits(kMaxSide, kMaxFractionBits);
  command
      .option("--bits", options->bits,
              fmt::format("Bits W of a coefficient, sign included, 2 to {}", exact))
      .list()
      .within(2, exact);
  command.option("--out", options->out, "Write the table to this CSV file").type("FILE.csv");
  command.run([options] { return measure_rounding(*options); });
}

}  // namespace rc2
