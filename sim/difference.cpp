// The first difference: where, when and how the Verilated array, the cycle model and the golden
// model part, and a waveform of that moment.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <map>
#include <memory>

#include "sim/commands.h"
#include "sim/drive.h"
#include "sim/job.h"
#include "sim/lights.h"
#include "sim/machines.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sw/report/compare.h"

namespace rc2 {
namespace {

constexpr int kBefore = 20, kWindow = 60;  // cycles of the waveform

struct DifferenceOptions : LightOptions {
  std::string waves = "difference.fst";
};

using Depths = std::vector<std::uint32_t>;

// The queues of one light, from the first to the last cycle in which one holds a beam.
struct Light {
  std::int64_t first = 0;  // its number, as the machine counts
  std::vector<Depths> cycles;

  void add(std::int64_t cycle, const Depths& depths) {
    if (std::all_of(depths.begin(), depths.end(), [](auto depth) { return depth == 0; })) return;
    if (cycles.empty()) first = cycle;
    cycles.resize(static_cast<std::size_t>(cycle - first), Depths(depths.size()));
    cycles.push_back(depths);
  }
};

// What one machine did with the job.
struct Run {
  std::string name;
  report::Memories memories;
  std::int64_t load_cycles = 0;
  std::vector<LightResult> results;
  std::vector<Light> lights;
};

struct Moment {
  std::size_t light;
  std::int64_t cycle;  // of Light::cycles
  glm::ivec2 cell;
};

Run run(const std::string& name, const DifferenceOptions& options, const Job& job, Lamps& lamps,
        ProgressBar& bar, const WaveWindow& waves = {}) {
  Run run;
  run.name = name;
  const auto machine = make_machine(name, options.needs(), waves);
  Drive drive(*machine, name, bar);
  drive.load(job.facets);
  place_lamps(lamps, drive.memories().voxels, options.n);
  machine->observe([&](std::int64_t cycle, const Depths& depths) {
    run.lights.resize(drive.memories().lights.size() + 1);
    run.lights.back().add(cycle, depths);
  });
  run.results = drive.light(lamps.list, options.distance(), options.fa, options.rule_of_light());
  run.load_cycles = drive.load_cycles();
  run.lights.resize(lamps.list.size());
  run.memories = drive.memories();
  return run;
}

// A machine whose light has ended has empty queues.
std::uint32_t depth(const Light& light, std::int64_t cycle, std::size_t cell) {
  const bool seen = cycle >= 0 && cycle < static_cast<std::int64_t>(light.cycles.size());
  return seen ? light.cycles[static_cast<std::size_t>(cycle)][cell] : 0;
}

std::optional<Moment> first_moment(const Run& cycle, const Run& rtl, int n) {
  for (std::size_t k = 0; k < cycle.lights.size(); ++k) {
    const std::size_t cycles = std::max(cycle.lights[k].cycles.size(), rtl.lights[k].cycles.size());
    for (std::size_t t = 0; t < cycles; ++t) {
      const auto at = static_cast<std::int64_t>(t);
      for (std::size_t cell = 0; cell < static_cast<std::size_t>(n) * n; ++cell)
        if (depth(cycle.lights[k], at, cell) != depth(rtl.lights[k], at, cell))
          return Moment{k, at, {static_cast<int>(cell) % n, static_cast<int>(cell) / n}};
    }
  }
  return {};
}

void print_queues(const Run& cycle, const Run& rtl, const Moment& moment, int n) {
  for (const std::int64_t at : {moment.cycle - 1, moment.cycle}) {
    fmt::print("  queues around it {}, cycle model/rtl:\n",
               at < moment.cycle ? "a cycle before" : "then");
    for (int y = std::min(moment.cell.y + 1, n - 1); y >= std::max(moment.cell.y - 1, 0); --y) {
      fmt::print("    y = {:2}", y);
      for (int x = std::max(moment.cell.x - 1, 0); x <= std::min(moment.cell.x + 1, n - 1); ++x) {
        const auto cell = static_cast<std::size_t>(y) * n + x;
        const auto expected = depth(cycle.lights[moment.light], at, cell);
        const auto got = depth(rtl.lights[moment.light], at, cell);
        fmt::print("   x = {}: {}/{}{}", x, expected, got, expected == got ? " " : "!");
      }
      fmt::print("\n");
    }
  }
}

// What the machine holds of a column in the end: z of each voxel, its facet, its counts of light.
std::string column(const Run& run, const glm::ivec2& cell) {
  std::string text;
  for (std::size_t i = 0; i < run.memories.voxels.size(); ++i) {
    const VoxelRecord& voxel = run.memories.voxels[i];
    if (glm::ivec2(voxel.at) != cell) continue;
    text += fmt::format(" z{} facet {}", voxel.at.z, voxel.owner.facet);
    for (const LightMemory& light : run.memories.lights) text += fmt::format(" light {}", light[i]);
    text += ';';
  }
  return text.empty() ? " no voxel" : text;
}

// Whether the models take the same time; what they do not is said.
bool same_cycles(const Run& cycle, const Run& rtl) {
  bool same = true;
  const auto compare = [&](const std::string& what, std::int64_t expected, std::int64_t got) {
    if (expected == got) return;
    same = false;
    fmt::print("  {}: {} cycles on the cycle model, {} on rtl\n", what, expected, got);
  };
  compare("loading", cycle.load_cycles, rtl.load_cycles);
  for (std::size_t k = 0; k < cycle.results.size(); ++k) {
    const std::string light = fmt::format("light {}", k);
    compare("preparing " + light, cycle.results[k].prepare_cycles, rtl.results[k].prepare_cycles);
    compare(light, cycle.results[k].cycles, rtl.results[k].cycles);
  }
  return same;
}

void print_columns(const std::vector<const Run*>& runs, const glm::ivec2& cell) {
  fmt::print("  column ({},{}) in the end:\n", cell.x, cell.y);
  for (const Run* run : runs) fmt::print("    {:6}{}\n", run->name, column(*run, cell));
}

ExitCode find_difference(const DifferenceOptions& options, ProgressBar& bar) {
  const Job job = prepare(options, options.rule_of_light() == LightRule::accurate);
  Lamps lamps = choose_lamps(options.lights, job.scene, options.n);
  const Run golden = run("golden", options, job, lamps, bar);
  const Run cycle = run("cycle", options, job, lamps, bar);
  const Run rtl = run("rtl", options, job, lamps, bar);

  const std::optional<Moment> moment = first_moment(cycle, rtl, options.n);
  std::optional<glm::ivec2> cell;
  if (moment) {
    cell = moment->cell;
    const Lamp& lamp = lamps.list[moment->light];
    fmt::print(
        "first difference: light {} at ({},{},{}), cycle {} ({} since the reset of rtl), cell "
        "({},{})\n",
        moment->light, lamp.voxel.x, lamp.voxel.y, lamp.voxel.z,
        cycle.lights[moment->light].first + moment->cycle,
        rtl.lights[moment->light].first + moment->cycle, cell->x, cell->y);
    print_queues(cycle, rtl, *moment, options.n);
  }
  for (const Run* other : {&cycle, &rtl}) {
    const report::Comparison compared = report::compare(golden.memories, other->memories);
    for (const report::Difference& difference : compared.first) {
      fmt::print("  {} and golden: {}\n", other->name, report::to_string(difference));
      if (!cell) cell = glm::ivec2(difference.at);
    }
  }
  const bool in_time = same_cycles(cycle, rtl);
  if (!cell && !in_time) return kDisagreement;
  if (!cell) {
    std::size_t cycles = 0;
    for (const Light& light : rtl.lights) cycles += light.cycles.size();
    fmt::print("no difference: {} voxels, {} lights, {} cells in each of {} cycles\n",
               golden.memories.voxels.size(), lamps.list.size(), options.n * options.n, cycles);
    return kDone;
  }
  print_columns({&golden, &cycle, &rtl}, *cell);

  // Without a moment the first light from its start is all there is to show.
  const std::size_t light = moment ? moment->light : 0;
  const std::int64_t from = rtl.lights[light].first + (moment ? moment->cycle : 0) - kBefore;
  Outputs outputs;
  outputs.add_waves(options.waves);
  run("rtl", options, job, lamps, bar,
      {options.waves, std::max<std::int64_t>(from, 0), kWindow, cell});
  outputs.keep();
  fmt::print("  waves: {}, {} cycles from {} on\n", options.waves, kWindow,
             std::max<std::int64_t>(from, 0));
  return kDisagreement;
}

}  // namespace

void declare_difference(Command& program) {
  auto options = std::make_shared<DifferenceOptions>();
  Command command = program.command(
      "difference",
      "Where and when the Verilated array, the cycle model and the golden model first differ on a "
      "job: cycle, cell, what is around it, a waveform of that moment; exit code 3 if they do");
  declare_light_options(command, *options);
  command.option("--waves", options->waves, "Where the waveform goes, and its list of signals")
      .type("FILE.fst");
  command.run([options] {
    check_options(*options);
    ProgressBar bar;
    return within_memory(options->n, [&] { return find_difference(*options, bar); });
  });
}

}  // namespace rc2
