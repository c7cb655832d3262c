#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "sim/commands.h"
#include "sim/job.h"
#include "sim/machines.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/base/replace_file.h"
#include "sw/report/dump.h"
#include "sw/report/laws.h"

namespace rc2 {
namespace {

struct VoxelizeOptions : SceneOptions {
  std::string layers = "one";

  bool all_layers() const { return layers == "all"; }
};

void print_layers(const facet::FacetSet& facets, const LayerMemory& voxels) {
  const auto print = [&](const char* name, facet::Layer layer, bool LayerRecord::*mark) {
    const std::vector<facet::PacketHead>& packets = facets.packets.heads;
    fmt::print("{:<8} packets       {}\n", name,
               std::count_if(packets.begin(), packets.end(),
                             [&](const facet::PacketHead& p) { return p.layer == layer; }));
    fmt::print("{:<8} voxels        {}\n", name,
               std::count_if(voxels.begin(), voxels.end(),
                             [&](const LayerRecord& voxel) { return voxel.*mark; }));
  };
  print("armour", facet::Layer::armour, &LayerRecord::armour);
  print("shown", facet::Layer::shown, &LayerRecord::shown);
  print("inside", facet::Layer::inside, &LayerRecord::inside);
  print("guard", facet::Layer::guard, &LayerRecord::guard);
  fmt::print(
      "solids                 {}\n"
      "of them, holes capped  {}\n"
      "rooms, nothing inside  {}\n"
      "open, nothing inside   {}\n"
      "crowded facets         {}\n",
      facets.counts.objects_closed, facets.counts.objects_capped, facets.counts.rooms,
      facets.counts.objects_open, facets.counts.crowded);
}

ExitCode voxelize(VoxelizeOptions options) {
  check_options(options);
  const Job job = prepare(options, options.all_layers());
  Outputs outputs;
  if (!options.dump.empty()) outputs.add_file(options.dump);

  const auto machine = make_machine(
      options.machine, {options.n, options.fraction_bits, 1, 1, options.feeder_count()});
  ProgressBar bar;
  const LoadResult load =
      machine->load(job.facets.packets, bar.step("loading on " + options.machine));
  const report::Memories memories{machine->read_voxels(), {}};
  const LayerMemory layers = options.all_layers() ? machine->read_layers() : LayerMemory();
  bar.wipe();
  report::check_voxels(memories.voxels, options.n, job.facets.facets.size());
  if (!options.dump.empty()) replace_file(options.dump, report::to_csv(memories));

  const facet::FacetCounts& counts = job.facets.counts;
  fmt::print(
      "polygons read          {}\n"
      "split into triangles   {}\n"
      "without area, dropped  {}\n"
      "outside, dropped       {}\n"
      "facets loaded          {}\n"
      "voxels occupied        {}\n",
      counts.read, counts.triangulated, counts.degenerate, counts.outside, counts.loaded,
      memories.voxels.size());
  if (options.all_layers()) print_layers(job.facets, layers);
  if (options.machine != "golden") fmt::print("clock cycles           {}\n", load.cycles);
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_voxelize(Command& program) {
  auto options = std::make_shared<VoxelizeOptions>();
  Command command =
      program.command("voxelize", "Loads a scene without lighting it and counts its voxels");
  declare_scene_options(command, *options);
  declare_machine_options(command, *options, "golden");
  command
      .option("--layers", options->layers,
              "one: what the facets fill; all: also what is shown, inside solids and guards")
      .one_of({"one", "all"});
  command.run([options] { return within_memory(options->n, [&] { return voxelize(*options); }); });
}

}  // namespace rc2
