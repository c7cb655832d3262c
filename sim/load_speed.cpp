// How long the host takes from a scene to voxels, beside a voxeliser that does nothing else.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "sim/commands.h"
#include "sim/memory.h"
#include "sw/direct/voxeliser.h"
#include "sw/facet/facet.h"
#include "sw/golden/golden_machine.h"
#include "sw/golden/voxelise.h"
#include "sw/scene/random.h"
#include "sw/scene/shapes.h"

namespace rc2 {
namespace {

using scene::Scene;

constexpr int kFractionBits = 4;
constexpr int kLargeTriangles = 1000;

struct SpeedOptions {
  std::vector<std::string> scenes;
  int n = 256;
  int repeats = 10;
};

// Processor time of the fastest of several runs: what else runs on this computer is not to blame.
class Best {
 public:
  template <typename Step>
  auto time(Step step) {
    const std::clock_t start = std::clock();
    auto result = step();
    clocks_ = std::min(clocks_, std::clock() - start);
    return result;
  }

  double seconds() const { return static_cast<double>(clocks_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t clocks_ = std::numeric_limits<std::clock_t>::max();
};

struct Measured {
  std::string name;
  std::size_t polygons, triangles, facets;
  std::int64_t filled;  ///< voxels, those of several facets counted for each
  Best import, packets, load, list, direct;
  bool agrees;

  double golden_seconds() const { return packets.seconds() + load.seconds(); }
};

// A sphere whose triangles, at n = 256, are smaller than a voxel's side.
Scene make_small(int n) {
  constexpr int kLevel = 7;
  Scene sphere;
  const glm::dvec3 centre(0.5 * (n - 1));
  const double radius = 0.5 * (n - 3);
  scene::add_sphere(sphere, centre, radius, 0, 0);
  const auto between = [&](const glm::dvec3& p, const glm::dvec3& q) {
    return centre + radius * glm::normalize(p + q - 2.0 * centre);
  };
  for (int level = scene::kMaxSphereLevel; level < kLevel; ++level) {
    Scene finer;
    for (std::size_t i = 0; i < sphere.polygon_count(); ++i) {
      const glm::dvec3 *p = &sphere.vertices[sphere.first[i]], ab = between(p[0], p[1]),
                       bc = between(p[1], p[2]), ca = between(p[2], p[0]);
      finer.add({p[0], ab, ca}, 0);
      finer.add({ab, p[1], bc}, 0);
      finer.add({ca, bc, p[2]}, 0);
      finer.add({ab, bc, ca}, 0);
    }
    sphere = std::move(finer);
  }
  return sphere;
}

// Corners anywhere in the cube.
Scene make_large(int n) {
  Scene scene;
  scene::Random random(1);
  for (int i = 0; i < kLargeTriangles; ++i) {
    std::vector<glm::dvec3> corners(3);
    for (glm::dvec3& corner : corners)
      for (int axis = 0; axis < 3; ++axis) corner[axis] = random.between(0, n - 1);
    scene.add(corners, 0);
  }
  return scene;
}

Scene make_scene(const std::string& name, int n) {
  if (scene::is_generated_name(name)) return scene::generate(name, n);
  Scene scene = scene::read_file(name);
  scene::fit_to_cube(scene, n);
  return scene;
}

// Every polygon as a fan of triangles.
Scene cut_to_triangles(const Scene& scene) {
  Scene triangles;
  for (std::size_t i = 0; i < scene.polygon_count(); ++i) {
    const glm::dvec3* corners = &scene.vertices[scene.first[i]];
    for (std::uint32_t k = 2; k < scene.first[i + 1] - scene.first[i]; ++k)
      triangles.add({corners[0], corners[k - 1], corners[k]}, 0);
  }
  return triangles;
}

std::int64_t count_filled(const facet::PacketStream& packets) {
  std::int64_t filled = 0;
  for (const facet::PacketHead& head : packets.heads)
    golden::for_each_dexel(
        head, packets.sides.data() + head.first_side,
        [&](const golden::Dexel& dexel) { filled += dexel.z.last - dexel.z.first + 1; });
  return filled;
}

bool same_voxels(const VoxelMemory& voxels, const direct::Voxeliser& voxeliser) {
  return static_cast<std::int64_t>(voxels.size()) == voxeliser.voxel_count() &&
         std::all_of(voxels.begin(), voxels.end(), [&](const VoxelRecord& voxel) {
           return voxeliser.owner(voxel.at) != direct::Voxeliser::kFree;
         });
}

template <typename Make>
Measured measure(const std::string& name, const SpeedOptions& options, Make make) {
  Measured measured;
  measured.name = name;
  const Scene scene = measured.import.time([&] { return make(); });
  const Scene triangles = cut_to_triangles(scene);
  MachineConfig config;
  config.n = options.n;
  config.fraction_bits = kFractionBits;
  for (int i = 0; i < options.repeats; ++i) {
    VoxelMemory voxels;
    {
      const facet::FacetSet facets = measured.packets.time([&] {
        return facet::build_facets(scene, options.n, kFractionBits, facet::Rule::armoured);
      });
      golden::GoldenMachine machine(config);
      measured.load.time([&] { return machine.load(facets.packets, {}); });
      voxels = measured.list.time([&] { return machine.read_voxels(); });
      measured.facets = facets.facets.size();
      if (i == 0) measured.filled = count_filled(facets.packets);
    }
    direct::Voxeliser voxeliser(options.n, kFractionBits);
    measured.direct.time([&] {
      voxeliser.fill(triangles);
      return true;
    });
    // A polygon's triangles may fill voxels at its corners that it does not fill as a whole.
    measured.agrees =
        triangles.polygon_count() != scene.polygon_count() || same_voxels(voxels, voxeliser);
  }
  measured.polygons = scene.polygon_count();
  measured.triangles = triangles.polygon_count();
  return measured;
}

void print_tables(const std::vector<Measured>& rows, const SpeedOptions& options) {
  std::size_t width = 24;
  for (const Measured& row : rows) width = std::max(width, row.name.size() + 1);
  fmt::print("{:<{}}{:>11}{:>11}{:>11}{:>11}\n", fmt::format("n = {}", options.n), width,
             "polygons", "triangles", "facets", "voxels");
  for (const Measured& row : rows)
    fmt::print("{:<{}}{:>11}{:>11}{:>11}{:>11}\n", row.name, width, row.polygons, row.triangles,
               row.facets, row.filled);
  fmt::print("\n{:<{}}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "milliseconds", width, "import", "packets",
             "load", "list", "direct");
  for (const Measured& row : rows) {
    fmt::print("{:<{}}", row.name, width);
    for (const Best* step : {&row.import, &row.packets, &row.load, &row.list, &row.direct})
      fmt::print("{:>11.2f}", 1e3 * step->seconds());
    fmt::print("\n");
  }
  fmt::print("\n{:<{}}{:>22}{:>22}{:>11}\n", "", width, "M triangles/s", "M voxels/s", "golden");
  fmt::print("{:<{}}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "", width, "golden", "direct", "golden",
             "direct", "/ direct");
  for (const Measured& row : rows) {
    fmt::print("{:<{}}", row.name, width);
    for (const double count : {static_cast<double>(row.triangles), static_cast<double>(row.filled)})
      for (const double seconds : {row.golden_seconds(), row.direct.seconds()})
        fmt::print("{:>11.3f}", 1e-6 * count / seconds);
    fmt::print("{:>11.2f}\n", row.golden_seconds() / row.direct.seconds());
  }
  fmt::print(
      "\npackets and load: the golden machine; direct: a voxeliser without packets or claims, "
      "from\n"
      "the same scene, its polygons cut into triangles beforehand. golden / direct: packets + "
      "load\n"
      "over direct; import, which both share, and list, for whoever reads the voxels, are not in\n"
      "it. voxels: filled, once for each facet. Processor time of one thread, the fastest of {}.\n",
      options.repeats);
}

ExitCode measure_speed(const SpeedOptions& options) {
  std::vector<Measured> rows;
  rows.push_back(measure("small triangles", options, [&] { return make_small(options.n); }));
  rows.push_back(measure("large triangles", options, [&] { return make_large(options.n); }));
  for (const std::string& name : options.scenes)
    rows.push_back(measure(name.substr(name.rfind('/') + 1), options,
                           [&] { return make_scene(name, options.n); }));
  print_tables(rows, options);
  for (const Measured& row : rows) {
    if (row.agrees) continue;
    fmt::print(stderr, "rc2: {}: the golden machine and the direct voxeliser differ\n", row.name);
    return kDisagreement;
  }
  return kDone;
}

}  // namespace

void declare_load_speed(CLI::App& program, ExitCode& exit_code) {
  auto options = std::make_shared<SpeedOptions>();
  auto* command = program.add_subcommand(
      "load-speed", "Times the way from a scene to voxels on the golden machine");
  command->add_option("scenes", options->scenes,
                      "Files that Assimp reads, fitted into the cube, or generated scenes, besides "
                      "a sphere of small triangles and some large ones");
  command->add_option("--n", options->n, "Voxels per side")
      ->check(CLI::Range(16, kMaxSide))
      ->capture_default_str();
  command->add_option("--repeats", options->repeats, "Runs, of which the fastest counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->callback([options, &exit_code] {
    exit_code = within_memory(options->n, [&] { return measure_speed(*options); });
  });
}

}  // namespace rc2
