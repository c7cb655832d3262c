// Chapter 3: what passes the voxels of closed meshes, for every way to make voxels of a mesh.
#include "sw/surface/leaks.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "sim/commands.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/base/replace_file.h"
#include "sw/surface/closed_meshes.h"

namespace rc2 {
namespace {

using surface::kDiscretisers;

constexpr int kFileSide = 64;  // meshes from files are fitted into a cube of this side

struct LeakOptions {
  std::vector<std::string> files;
  int meshes = 200;
  std::string out;
};

// Means over the meshes of a family.
struct Means {
  double voxels = 0;  ///< relative to the first discretiser, armoured
  double by_6 = 0, by_18 = 0, by_26 = 0;
  double leaking_6 = 0, leaking_26 = 0;  ///< share of meshes with any such tunnel
};

struct Row {
  std::string name;
  int n, meshes;
  std::array<Means, kDiscretisers.size()> means;

  void add(const surface::LeakRow& found) {
    for (std::size_t i = 0; i < means.size(); ++i) {
      const auto& [voxels, tunnels] = found[i];
      const auto share = [&](auto value) { return static_cast<double>(value) / meshes; };
      means[i].voxels += share(voxels) / static_cast<double>(found[0].voxels);
      means[i].by_6 += share(tunnels.by_6);
      means[i].by_18 += share(tunnels.by_18);
      means[i].by_26 += share(tunnels.by_26);
      means[i].leaking_6 += share(tunnels.by_6 > 0);
      means[i].leaking_26 += share(tunnels.by_26 > 0);
    }
  }
};

Row measure_family(const surface::MeshFamily& family, int meshes, ProgressBar& bar) {
  Row row{family.name, family.n, meshes, {}};
  const Progress progress = bar.step(row.name);
  for (int seed = 1; seed <= meshes; ++seed) {
    row.add(surface::find_leaks(make_mesh(family, static_cast<std::uint64_t>(seed)), family.n));
    progress("leaks", 0, static_cast<double>(seed) / meshes);
  }
  return row;
}

Row measure_file(const std::string& path) {
  scene::Scene scene = scene::read_file(path);
  scene::fit_to_cube(scene, kFileSide);
  Row row{std::filesystem::path(path).filename(), kFileSide, 1, {}};
  row.add(surface::find_leaks(scene, kFileSide));
  return row;
}

std::size_t name_width(const std::vector<Row>& rows) {
  std::size_t width = 24;
  for (const Row& row : rows) width = std::max(width, row.name.size());
  return width;
}

template <typename Value>
void print_table(const char* title, const std::vector<Row>& rows, int digits, const Value& value) {
  const std::size_t width = name_width(rows);
  fmt::print("\n{:<{}}", title, width);
  for (const auto discretiser : kDiscretisers) fmt::print("{:>11}", to_string(discretiser));
  fmt::print("\n");
  for (const Row& row : rows) {
    fmt::print("{:<{}}", row.name, width);
    for (const Means& means : row.means) fmt::print("{:>11.{}f}", value(means), digits);
    fmt::print("\n");
  }
}

void print_tables(const std::vector<Row>& rows) {
  const std::size_t width = name_width(rows);
  fmt::print("{:<{}}{:>11}{:>11}\n", "closed meshes", width, "side n", "meshes");
  for (const Row& row : rows)
    fmt::print("{:<{}}{:>11}{:>11}\n", row.name, width, row.n, row.meshes);
  print_table("voxels / armoured", rows, 3, [](const Means& means) { return means.voxels; });
  print_table("6-tunnels per mesh", rows, 1, [](const Means& means) { return means.by_6; });
  print_table("26-tunnels per mesh", rows, 1, [](const Means& means) { return means.by_26; });
  print_table("% of meshes leaking (6)", rows, 1,
              [](const Means& means) { return 100 * means.leaking_6; });
  print_table("% of meshes leaking (26)", rows, 1,
              [](const Means& means) { return 100 * means.leaking_26; });
  fmt::print(
      "\ntunnels: pairs of free neighbours, one inside and one outside; 6: they share a face,\n"
      "26: at least a corner. bilinear and slices: vertices are rounded to whole voxels.\n");
}

std::string to_csv(const std::vector<Row>& rows) {
  std::string csv =
      "mesh,n,meshes,discretiser,voxels_to_armoured,tunnels_6,tunnels_18,tunnels_26,leaking_6,"
      "leaking_26\n";
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.means.size(); ++i) {
      const Means& means = row.means[i];
      csv += fmt::format("{},{},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", row.name, row.n,
                         row.meshes, to_string(kDiscretisers[i]), means.voxels, means.by_6,
                         means.by_18, means.by_26, means.leaking_6, means.leaking_26);
    }
  }
  return csv;
}

ExitCode measure_leaks(const LeakOptions& options) {
  Outputs outputs;
  if (!options.out.empty()) outputs.add_file(options.out);
  ProgressBar bar;
  std::vector<Row> rows;
  for (const std::string& path : options.files) rows.push_back(measure_file(path));
  for (const surface::MeshFamily& family : surface::kMeshFamilies)
    rows.push_back(measure_family(family, options.meshes, bar));
  bar.wipe();
  print_tables(rows);
  if (!options.out.empty()) replace_file(options.out, to_csv(rows));
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_leaks(Command& program) {
  auto options = std::make_shared<LeakOptions>();
  Command command = program.command(
      "leaks", "Counts what passes the voxels of closed meshes, by discretiser (thesis chapter 3)");
  command.option("files", options->files,
                 fmt::format("Closed meshes that Assimp reads, fitted into {} voxels a side, "
                             "besides the generated ones",
                             kFileSide));
  command.option("--meshes", options->meshes, "Generated meshes of each kind").within(1, 100'000);
  command.option("--out", options->out, "Write the table to this CSV file").type("FILE.csv");
  command.run([options] { return measure_leaks(*options); });
}

}  // namespace rc2
