// What one would take instead of the machine, on the same scenes and lights, in the same table.
#include <fmt/format.h>

#include <memory>

#include "sim/bench_row.h"
#include "sim/commands.h"
#include "sim/light_stage.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sim/stage_command.h"
#include "sim/timed_load.h"
#include "sw/base/replace_file.h"
#include "sw/direct/voxeliser.h"
#include "sw/peers/grid_walk.h"
#include "sw/peers/layer_sweep.h"
#include "sw/peers/mesh_volume.h"
#include "sw/peers/shadow_rays.h"

namespace rc2 {
namespace {

constexpr int kRepeats = 3;  // of which the fastest counts
// Armour is up to three voxels thick along a way.
constexpr int kLeave = 3;

class Peers {
 public:
  Peers(const StageOptions& options, ProgressBar& bar)
      : stage_(options.scene, options.n, options.fraction_bits, facet::Rule::armoured, {},
               bar.step("loading")),
        picture_(stage_) {
    row_.scene = stage_.title;
    row_.n = stage_.n;
    row_.fraction_bits = stage_.fraction_bits;
    row_.facets = static_cast<std::int64_t>(stage_.facets.facets.size());
  }

  void run(int lights) {
    load_with_openvdb("openvdb-0.5", 0.5);
    load_with_openvdb("openvdb-0.867", 0.8661);
    load_directly();
    prepare();
    for (int i = 0; i < lights; ++i) light(i);
  }

  const std::vector<BenchRow>& rows() const { return rows_; }

 private:
  template <typename Step>
  static auto timed(double& seconds, const Step& step) {
    Best watch;
    auto result = watch.time(step);
    for (int i = 1; i < kRepeats; ++i) watch.time(step);
    seconds = watch.seconds();
    return result;
  }

  void load_with_openvdb(const char* name, double distance) {
    BenchRow row = row_;
    row.method = name;
    const auto voxels = timed(row.load_seconds, [&] {
      return peers::mesh_to_voxels(stage_.surface.triangles(), stage_.n, distance);
    });
    row.voxels = voxel_error(stage_, voxels);
    rows_.push_back(row);
  }

  // The scene's triangles only, as the voxeliser takes no other polygons.
  void load_directly() {
    BenchRow row = row_;
    row.method = "direct";
    scene::Scene triangles;
    const truth::Triangles& of = stage_.surface.triangles();
    for (const glm::uvec3& t : of.corners)
      triangles.add({of.vertices[t.x], of.vertices[t.y], of.vertices[t.z]}, 0);
    const auto voxeliser = timed(row.load_seconds, [&] {
      auto made = std::make_unique<direct::Voxeliser>(stage_.n, stage_.fraction_bits);
      made->fill(triangles);
      return made;
    });
    std::vector<glm::ivec3> voxels;
    for (glm::ivec3 at{0}; at.z < stage_.n; ++at.z)
      for (at.y = 0; at.y < stage_.n; ++at.y)
        for (at.x = 0; at.x < stage_.n; ++at.x)
          if (voxeliser->owner(at) != direct::Voxeliser::kFree) voxels.push_back(at);
    row.voxels = voxel_error(stage_, voxels);
    rows_.push_back(row);
  }

  // What does not depend on the light.
  void prepare() {
    rays_ = timed(rays_seconds_,
                  [&] { return std::make_unique<peers::ShadowRays>(stage_.surface.triangles()); });
    // Where a voxel's own piece of surface is, a program that draws it knows: this is not timed.
    for (const glm::ivec3& voxel : stage_.shown.places()) {
      const truth::Surface::Foot foot = stage_.surface.nearest(voxel);
      places_.push_back(truth::make_sample(stage_.surface, foot.at, foot.triangle).at);
    }
    for (const VoxelRecord& voxel : stage_.voxels) armour_.set(voxel.at);
    row_.load_seconds = stage_.packet_seconds + stage_.load_seconds;
  }

  // What the accurate rule stops light at, but for walls thinner than the armour.
  peers::BitGrid accurate_stops(const std::vector<bool>& away) const {
    peers::BitGrid stops(stage_.n);
    for (const VoxelRecord& voxel : stage_.voxels)
      if (away[voxel.owner.facet]) stops.set(voxel.at);
    for (const LayerRecord& layer : stage_.layers)
      if (layer.inside && !layer.armour) stops.set(layer.at);
    return stops;
  }

  void light(int number) {
    const glm::ivec3 at = stage_.light(number);
    const std::vector<truth::Verdict> verdicts = stage_.judge(at);
    const std::vector<bool> away = stage_.away(at);
    row_.light = number;
    row_.at = at;
    const std::vector<glm::ivec3>& shown = stage_.shown.places();

    BenchRow row = row_;
    row.prepare_seconds = rays_seconds_;
    row.load_seconds = 0;
    const auto with_rays = [&](const char* name, auto trace) {
      row.method = name;
      double seconds = 0;
      const std::vector<bool> lit = timed(seconds, trace);
      row.light_seconds = seconds;
      add(row, lit, verdicts, away);
    };
    with_rays("embree-1", [&] { return rays_->one_by_one(places_, at); });
    with_rays("embree-8", [&] { return rays_->by_eight(places_, at); });

    row = row_;
    with_rays("walk", [&] { return peers::walk_to_light(armour_, shown, at, 0); });
    with_rays("walk-leaving", [&] { return peers::walk_to_light(armour_, shown, at, kLeave); });

    const auto with_sweep = [&](const char* name, const char* rule, const auto& make_stops) {
      row.method = name;
      row.light_rule = rule;
      double seconds = 0;
      const peers::BitGrid reached =
          timed(seconds, [&] { return peers::sweep_layers(make_stops(), at); });
      row.light_seconds = seconds;
      std::vector<bool> lit;
      lit.reserve(shown.size());
      for (const glm::ivec3& voxel : shown) lit.push_back(reached.at(voxel));
      add(row, lit, verdicts, away);
    };
    with_sweep("sweep", "thesis", [&] { return armour_; });
    with_sweep("sweep", "accurate", [&] { return accurate_stops(away); });
  }

  void add(BenchRow row, const std::vector<bool>& lit, const std::vector<truth::Verdict>& verdicts,
           const std::vector<bool>& away) {
    LightMemory arrived(stage_.voxels.size());
    for (std::size_t i = 0; i < lit.size(); ++i)
      arrived[stage_.shown.numbers()[i]] = lit[i] ? 1 : 0;
    row.errors.emplace();
    for (std::size_t i = 0; i < kPopulations.size(); ++i)
      (*row.errors)[i] = stage_.shown.compare(verdicts, kPopulations[i], arrived, away);
    row.picture = picture_.compare(row.at, arrived);
    rows_.push_back(row);
  }

  LightStage stage_;
  PictureError picture_;
  BenchRow row_;  ///< what all rows have in common
  double rays_seconds_ = 0;
  std::unique_ptr<peers::ShadowRays> rays_;
  std::vector<glm::vec3> places_;
  peers::BitGrid armour_{stage_.n};
  std::vector<BenchRow> rows_;
};

ExitCode measure_peers(const StageOptions& options) {
  Outputs outputs;
  outputs.add_file(options.out);
  ProgressBar bar;
  Peers peers(options, bar);
  peers.run(options.lights);
  bar.wipe();
  replace_file(options.out, to_csv(peers.rows()));
  fmt::print("{} lines written\n", peers.rows().size());
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_peers(Command& program) {
  auto options = std::make_shared<StageOptions>();
  Command command = program.command(
      "peers",
      "The same scenes, lights and errors as measure with what one would take instead: "
      "Embree, a walk through the voxels, a sweep over layers; OpenVDB for loading");
  declare_stage_options(command, *options);
  command.run(
      [options] { return within_memory(options->n, [&] { return measure_peers(*options); }); });
}

}  // namespace rc2
