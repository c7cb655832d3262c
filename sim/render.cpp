// Pictures by rays: a scene into a machine, light into the scene, rays through both.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "sim/commands.h"
#include "sim/drive.h"
#include "sim/machines.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/render_job.h"
#include "sim/render_report.h"
#include "sw/base/replace_file.h"
#include "sw/facet/optics.h"
#include "sw/picture/compose.h"
#include "sw/picture/exr.h"
#include "sw/picture/png.h"
#include "sw/picture/raster.h"
#include "sw/report/dump.h"

namespace rc2 {
namespace {

struct RenderOptions : SceneOptions {
  std::vector<std::string> lights;
  std::string view = "front";
  int depth = 4;
  double least_weight = kDefaultLeastWeight;
  int queue = 2;
  bool progressive = false;
  std::string out = "out";
};

void check(RenderOptions& options) {
  check_options(options);
  if (!(options.least_weight >= 0 && options.least_weight <= 1))
    throw Error(
        fmt::format("--least-weight {} is out of range; choose 0 to 1", options.least_weight));
}

class Renderer {
 public:
  Renderer(const RenderOptions& options, Outputs& outputs) : options_(options), outputs_(outputs) {}

  ExitCode render() {
    const Job job = prepare(options_, true);
    // Asked for before the long work: it may be refused.
    const std::vector<Sight> sights = sights_of(job.scene, options_.view, options_.n);
    Lamps lamps = choose_lamps(options_.lights, job.scene, options_.n);
    outputs_.add_folder(options_.out);
    if (!options_.dump.empty()) outputs_.add_file(options_.dump);
    MachineConfig config{options_.n, options_.fraction_bits, 2 * options_.n, 1,
                         options_.feeder_count()};
    config.ray_depth = std::max(1, options_.depth);
    config.ray_queue = options_.queue;
    const auto machine = make_machine(options_.machine, config);
    Drive drive(*machine, options_.machine, bar_);
    drive.load(job.facets);
    place_lamps(lamps, drive.memories().voxels, options_.n);

    const std::vector<rays::Facet> optics =
        facet::find_optics(job.facets.facets, job.scene.materials);
    const std::vector<RayStart> starts = ray_starts(sights, options_.n);
    const RayJob rays{{options_.depth, weight_of(options_.least_weight)},
                      &optics,
                      starts_for(options_.view, starts),
                      options_.queue};
    const RayResult result = drive.trace(rays);
    const picture::Traced traced{options_.n, drive.memories().voxels, job.facets.facets,
                                 job.scene.materials, result.hits};
    if (options_.progressive) {
      const std::vector<LightMemory> none(lamps.list.size());
      const scene::SmoothNormals smooth(job.scene);
      picture::Traced first = traced;
      first.smooth = &smooth;
      write("0-loaded", picture::compose(first, lit_lamps(lamps.list, none), 0));
    }
    drive.light(lamps.list, 2 * options_.n, 1, kLightRule);
    if (!options_.dump.empty()) {
      replace_file(options_.dump, report::to_csv(drive.memories()));
      written_.push_back(options_.dump);
    }
    const std::vector<picture::Lamp> lit = lit_lamps(lamps.list, drive.memories().lights);
    for (int depth = 0; options_.progressive && depth < options_.depth; ++depth)
      write(fmt::format("{}-depth-{}", depth + 1, depth), picture::compose(traced, lit, depth));
    write("picture", picture::compose(traced, lit, options_.depth));
    const bool agrees =
        options_.machine == kReference || agrees_with_golden(job, config, rays, result);
    write_report(job, lamps, result, agrees);
    if (agrees) return kDone;
    fmt::print(stderr, "rc2: the rays of {} and {} differ; see the report\n", options_.machine,
               kReference);
    return kDisagreement;
  }

 private:
  static constexpr LightRule kLightRule = LightRule::accurate;
  static constexpr const char* kReference = "golden";

  bool agrees_with_golden(const Job& job, const MachineConfig& config, const RayJob& rays,
                          const RayResult& result) {
    const auto golden = make_machine(kReference, config);
    Drive drive(*golden, kReference, bar_);
    drive.load(job.facets);
    const RayResult expected = drive.trace(rays);
    return result.hits == expected.hits && result.counts == expected.counts;
  }

  void write(const std::string& name, const picture::Image& image) {
    const std::string path = (std::filesystem::path(options_.out) / name).string();
    picture::write_exr(path + ".exr", image);
    picture::write_png(path + ".png", picture::develop(image));
    written_.push_back(path + ".exr");
    written_.push_back(path + ".png");
  }

  void write_report(const Job& job, const Lamps& lamps, const RayResult& result, bool agrees) {
    RenderReport report;
    report.scene = options_.scene;
    report.machine = options_.machine;
    report.view = options_.view;
    report.has_unused_camera = options_.view == "front" && job.scene.camera;
    report.light_rule = to_string(kLightRule);
    report.n = options_.n;
    report.depth = options_.depth;
    report.least_weight = options_.least_weight;
    report.queue = options_.queue;
    report.facets = job.facets.counts.loaded;
    report.lights = static_cast<std::int64_t>(lamps.list.size());
    report.result = &result;
    report.agrees = agrees;
    const std::string path = (std::filesystem::path(options_.out) / "report.json").string();
    written_.push_back(path);
    report.written = written_;
    replace_file(path, to_json(report));
    fmt::print("{}", to_text(report));
  }

  const RenderOptions& options_;
  Outputs& outputs_;
  ProgressBar bar_;
  std::vector<std::string> written_;
};

}  // namespace

void declare_render(Command& program) {
  auto options = std::make_shared<RenderOptions>();
  options->n = 128;
  options->fraction_bits = kRenderFraction;
  Command command = program.command(
      "render", "Loads a scene, lights it, and follows reflected and refracted rays");
  declare_scene_options(command, *options);
  declare_machine_options(command, *options, "golden");
  declare_lights(command, options->lights);
  declare_view(command, options->view);
  command.option("--depth", options->depth, "Bounces of a ray, at most").within(0, rays::kMaxDepth);
  command.option("--least-weight", options->least_weight,
                 "Share of its pixel that a ray must be worth to be followed, 0 to 1");
  command.option("--queue", options->queue, "Places of each queue of the network (cycle, rtl)")
      .within(1, 1024);
  command.flag("--progressive", options->progressive,
               "Write a picture after loading, with light, and after each bounce");
  command.option("--out", options->out, "Folder of the pictures and report.json").type("DIR");
  command.run([options] {
    return within_memory(options->n, [&] {
      check(*options);
      Outputs outputs;
      const ExitCode code = Renderer(*options, outputs).render();
      outputs.keep();
      return code;
    });
  });
}

}  // namespace rc2
