// Chapter 3: how fast the host itself is on the way from a scene to voxels.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "sim/commands.h"
#include "sim/job.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/timed_load.h"
#include "sw/base/replace_file.h"
#include "sw/scene/shapes.h"

namespace rc2 {
namespace {

using scene::Scene;

constexpr int kSmallestSide = 16;

struct SpeedOptions {
  std::vector<std::string> scenes;
  int n = 256;
  int repeats = 10;
  std::string out;
};

// A sphere whose triangles, at n = 256, are smaller than a voxel's side.
Scene small_triangles(int n) {
  Scene sphere;
  scene::add_sphere(sphere, glm::dvec3(0.5 * (n - 1)), 0.5 * (n - 3), 0, 0, 7);
  return sphere;
}

Scene large_triangles(int n) {
  Scene scene;
  scene::Random random(1);
  scene::add_random_triangles(scene, 1000, n, random, 0);
  return scene;
}

std::vector<TimedLoad> time_all(const SpeedOptions& options) {
  std::vector<SceneOptions> scenes(options.scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    scenes[i].scene = options.scenes[i];
    scenes[i].n = options.n;
    check_options(scenes[i]);
  }
  const auto timed = [&](const std::string& name, auto make) {
    return time_load(name, options.n, options.repeats, make);
  };
  std::vector<TimedLoad> all = {
      timed("small triangles", [&] { return small_triangles(options.n); }),
      timed("large triangles", [&] { return large_triangles(options.n); })};
  for (const SceneOptions& scene : scenes) {
    all.push_back(
        timed(std::filesystem::path(scene.scene).filename(), [&] { return read_scene(scene); }));
  }
  return all;
}

void print_tables(const std::vector<TimedLoad>& all, const SpeedOptions& options) {
  std::size_t width = 24;
  for (const TimedLoad& row : all) width = std::max(width, row.scene.size() + 1);
  fmt::print("{:<{}}{:>11}{:>11}{:>11}{:>11}\n", fmt::format("n = {}", options.n), width,
             "polygons", "triangles", "facets", "voxels");
  for (const TimedLoad& row : all)
    fmt::print("{:<{}}{:>11}{:>11}{:>11}{:>11}\n", row.scene, width, row.polygons, row.triangles,
               row.facets, row.filled);
  fmt::print("\n{:<{}}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "milliseconds", width, "import", "packets",
             "load", "list", "direct");
  for (const TimedLoad& row : all) {
    fmt::print("{:<{}}", row.scene, width);
    for (const Best* step : {&row.import, &row.packets, &row.load, &row.list, &row.direct})
      fmt::print("{:>11.2f}", 1e3 * step->seconds());
    fmt::print("\n");
  }
  fmt::print("\n{:<{}}{:>22}{:>22}{:>11}\n", "", width, "M triangles/s", "M voxels/s", "golden");
  fmt::print("{:<{}}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "", width, "golden", "direct", "golden",
             "direct", "/ direct");
  for (const TimedLoad& row : all) {
    fmt::print("{:<{}}", row.scene, width);
    for (const double count : {static_cast<double>(row.triangles), static_cast<double>(row.filled)})
      for (const double seconds : {row.golden_seconds(), row.direct.seconds()})
        fmt::print("{:>11.3f}", 1e-6 * count / seconds);
    fmt::print("{:>11.2f}\n", row.golden_seconds() / row.direct.seconds());
  }
  fmt::print(
      "\npackets and load: the golden machine; direct: a voxeliser without packets or claims, "
      "from\n"
      "the same scene, its polygons cut into triangles beforehand. golden / direct: packets and\n"
      "load over direct; import, which both share, and list, for whoever reads the voxels, are "
      "not\n"
      "in it. voxels: filled, once for each facet. Processor time of one thread, the fastest of "
      "{}.\n",
      options.repeats);
}

std::string to_csv(const std::vector<TimedLoad>& all, int n) {
  std::string csv =
      "scene,n,polygons,triangles,facets,voxels,import_ms,packets_ms,load_ms,list_ms,direct_ms\n";
  for (const TimedLoad& row : all) {
    csv += fmt::format("{},{},{},{},{},{}", row.scene, n, row.polygons, row.triangles, row.facets,
                       row.filled);
    for (const Best* step : {&row.import, &row.packets, &row.load, &row.list, &row.direct})
      csv += fmt::format(",{:.3f}", 1e3 * step->seconds());
    csv += '\n';
  }
  return csv;
}

ExitCode measure_speed(const SpeedOptions& options) {
  Outputs outputs;
  if (!options.out.empty()) outputs.add_file(options.out);
  const std::vector<TimedLoad> all = time_all(options);
  print_tables(all, options);
  if (!options.out.empty()) replace_file(options.out, to_csv(all, options.n));
  outputs.keep();
  for (const TimedLoad& row : all) {
    if (row.agrees) continue;
    fmt::print(stderr, "rc2: {}: the golden machine and the direct voxeliser differ\n", row.scene);
    return kDisagreement;
  }
  return kDone;
}

}  // namespace

void declare_load_speed(Command& program) {
  auto options = std::make_shared<SpeedOptions>();
  Command command = program.command(
      "load-speed", "Times the way from a scene to voxels on the golden machine (chapter 3)");
  command.option("SCENE", options->scenes,
                 "Files that Assimp reads, or generated scenes, besides a sphere of small "
                 "triangles and some large ones");
  command
      .option("--n", options->n, fmt::format("Voxels per side, {} to {}", kSmallestSide, kMaxSide))
      .within(kSmallestSide, kMaxSide);
  command.option("--repeats", options->repeats, "Runs, of which the fastest counts")
      .within(1, 1000);
  command.option("--out", options->out, "Write the table to this CSV file").type("FILE.csv");
  command.run(
      [options] { return within_memory(options->n, [&] { return measure_speed(*options); }); });
}

}  // namespace rc2
