// How far what the machine's rays see is from the continuous scene (docs/render.md).
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "sim/bounce.h"
#include "sim/drive.h"
#include "sim/job.h"
#include "sim/render_job.h"
#include "sim/table_command.h"
#include "sim/true_picture.h"
#include "sw/facet/optics.h"
#include "sw/golden/golden_machine.h"
#include "sw/picture/compose.h"
#include "sw/picture/difference.h"
#include "sw/truth/whitted.h"

namespace rc2 {
namespace {

struct RenderErrorOptions : TableOptions {
  RenderErrorOptions() { sides = {32, 64, 128}; }
  std::vector<int> depths = {0, 1, 4};
  std::string view = "front";
};

// A picture of the machine against the true one.
struct Compared {
  int depth;
  bool has_shadows;  // by the machine's light; else lamps shine everywhere, in truth too
  bool is_smooth;    // shaded by smooth normals, in truth too: the first picture
  picture::Difference difference;
};

struct Row {
  std::string scene;
  int n = 0;
  Bounce bounce;
  std::vector<Compared> pictures;
};

class Bench {
 public:
  Bench(const std::string& name, int n, const RenderErrorOptions& options, ProgressBar& bar)
      : n_(n),
        options_(options),
        job_(prepare(scene_options(name, n), true)),
        machine_(machine_config(n)),
        drive_(machine_, "golden", bar),
        truth_(job_.scene, bodies_of(job_), n) {
    drive_.load(job_.facets);
    optics_ = facet::find_optics(job_.facets.facets, job_.scene.materials);
    sights_ = sights_of(job_.scene, options.view, n);
  }

  Row measure(const std::string& title) {
    const auto trace = [this](const RayJob& job) { return drive_.trace(job); };
    Row row{title, n_, measure_bounce(truth_, job_.scene, optics_, trace, n_), {}};
    compare_pictures(row);
    return row;
  }

 private:
  static SceneOptions scene_options(const std::string& name, int n) {
    SceneOptions options;
    options.scene = name;
    options.n = n;
    options.fraction_bits = kRenderFraction;
    return options;
  }

  static MachineConfig machine_config(int n) {
    MachineConfig config;
    config.n = n;
    config.fraction_bits = kRenderFraction;
    config.max_distance = 2 * n;
    return config;
  }

  void compare_pictures(Row& row) {
    Lamps lamps = choose_lamps({}, job_.scene, n_);
    place_lamps(lamps, drive_.memories().voxels, n_);
    drive_.light(lamps.list, 2 * n_, 1, LightRule::accurate);
    const int deepest = *std::max_element(options_.depths.begin(), options_.depths.end());
    const std::vector<RayStart> starts = ray_starts(sights_, n_);
    const RayResult result =
        drive_.trace({{deepest, weight_of(kDefaultLeastWeight)}, &optics_, &starts});
    compare_first_picture(row, lamps, result);
    for (const bool has_shadows : {false, true}) {
      const std::vector<picture::Lamp> lit =
          lit_lamps(lamps.list, has_shadows ? drive_.memories().lights
                                            : std::vector<LightMemory>(lamps.list.size()));
      for (const int depth : options_.depths) {
        const picture::Image image = picture::compose(
            {n_, drive_.memories().voxels, job_.facets.facets, job_.scene.materials, result.hits},
            lit, depth);
        row.pictures.push_back({depth, has_shadows, false,
                                picture::difference(image, true_picture(truth_, sights_, lamps.list,
                                                                        depth, has_shadows))});
      }
    }
  }

  // What is shown before there is light (thesis 1.3.2).
  void compare_first_picture(Row& row, const Lamps& lamps, const RayResult& result) const {
    const scene::SmoothNormals smooth(job_.scene);
    const truth::Whitted truth(job_.scene, bodies_of(job_), n_, &smooth);
    const std::vector<LightMemory> none(lamps.list.size());
    const picture::Image image = picture::compose({n_, drive_.memories().voxels, job_.facets.facets,
                                                   job_.scene.materials, result.hits, &smooth},
                                                  lit_lamps(lamps.list, none), 0);
    row.pictures.push_back(
        {0, false, true,
         picture::difference(image, true_picture(truth, sights_, lamps.list, 0, false))});
  }

  int n_;
  const RenderErrorOptions& options_;
  Job job_;
  golden::GoldenMachine machine_;
  Drive drive_;
  truth::Whitted truth_;
  std::vector<rays::Facet> optics_;
  std::vector<Sight> sights_;
};

void measure(const std::string& name, int n, const RenderErrorOptions& options, ProgressBar& bar,
             std::vector<Row>& rows) {
  rows.push_back(
      Bench(name, n, options, bar).measure(std::filesystem::path(name).filename().string()));
}

double percent(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

// Of the hits that are not gross.
double mean_distance(const Bounce& bounce) {
  const std::int64_t good = bounce.rays - bounce.gross;
  return good == 0 ? 0 : bounce.distance / static_cast<double>(good);
}

void print(const std::vector<Row>& rows) {
  fmt::print("{:<24}{:>5}{:>8}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "scene", "n", "rays", "> 2 vx %",
             "early %", "edges %", "mean vx", "1 deg %");
  for (const Row& row : rows) {
    const Bounce& bounce = row.bounce;
    fmt::print("{:<24}{:>5}{:>8}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.4f}{:>10.2f}\n", row.scene, row.n,
               bounce.rays, percent(bounce.gross, bounce.rays), percent(bounce.early, bounce.rays),
               percent(bounce.edges, bounce.rays), mean_distance(bounce),
               percent(bounce.straight, bounce.rays));
  }
  fmt::print("\n{:<24}{:>5}{:>7}{:>9}{:>8}{:>10}{:>10}{:>10}\n", "scene", "n", "depth", "shadows",
             "smooth", "wrong %", "RMSE", "FLIP");
  for (const Row& row : rows)
    for (const auto& [depth, has_shadows, is_smooth, difference] : row.pictures)
      fmt::print("{:<24}{:>5}{:>7}{:>9}{:>8}{:>10.2f}{:>10.4f}{:>10.4f}\n", row.scene, row.n, depth,
                 has_shadows ? "yes" : "no", is_smooth ? "yes" : "no", 100 * difference.wrong,
                 difference.rmse, difference.flip);
}

std::string to_csv(const std::vector<Row>& rows) {
  std::string csv =
      "scene,n,rays,gross_percent,early_percent,edges_percent,mean_distance,straight_percent,depth,"
      "shadows,smooth,wrong_percent,rmse,flip\n";
  for (const Row& row : rows) {
    const Bounce& bounce = row.bounce;
    for (const auto& [depth, has_shadows, is_smooth, difference] : row.pictures)
      csv += fmt::format(
          "{},{},{},{:.4f},{:.4f},{:.4f},{:.5f},{:.4f},{},{},{},{:.4f},{:.5f},{:.5f}\n", row.scene,
          row.n, bounce.rays, percent(bounce.gross, bounce.rays),
          percent(bounce.early, bounce.rays), percent(bounce.edges, bounce.rays),
          mean_distance(bounce), percent(bounce.straight, bounce.rays), depth, has_shadows ? 1 : 0,
          is_smooth ? 1 : 0, 100 * difference.wrong, difference.rmse, difference.flip);
  }
  return csv;
}

}  // namespace

void declare_render_error(Command& program) {
  auto options = std::make_shared<RenderErrorOptions>();
  Command command = program.command(
      "render-error",
      "Compares the rays and pictures of the golden model with the continuous scene (Embree)");
  declare_table_options(command, *options,
                        "Files that Assimp reads, or generated scenes: those of run");
  declare_list(command, "--depth", options->depths, 0, rays::kMaxDepth,
               "Bounces of the pictures compared");
  declare_view(command, options->view);
  command.run([options] {
    return make_table<Row>(
        *options,
        [&](const std::string& scene, int n, ProgressBar& bar, std::vector<Row>& rows) {
          measure(scene, n, *options, bar, rows);
        },
        print, to_csv);
  });
}

}  // namespace rc2
