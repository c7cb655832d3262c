// Chapter 4: a picture of how deep the queues of all cells are while light spreads.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "sim/commands.h"
#include "sim/job.h"
#include "sim/light_sources.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/cycle/cell.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/picture/contact_sheet.h"
#include "sw/picture/png.h"

namespace rc2 {
namespace {

constexpr int kSide = 128;  // pixels of a picture

struct QueuesOptions {
  std::vector<std::string> scenes;
  int n = 64;
  int fa = 8;
  std::vector<std::string> modes = {"fast", "thesis"};
  std::vector<std::int64_t> times = {16, 32, 48, 64, 80, 96, 112, 128};
  std::string out;
};

using Depths = std::vector<std::uint32_t>;

// White if nothing is there, then blue, the darker the deeper.
picture::Colour colour_of(std::uint32_t depth) {
  if (depth == 0) return {255, 255, 255};
  constexpr std::uint32_t kDarkest = 9;
  const std::uint32_t left = kDarkest - std::min(depth, kDarkest);
  const auto shade = [&](std::uint32_t darkest, std::uint32_t lightest) {
    return static_cast<std::uint8_t>(darkest + (lightest - darkest) * left / (kDarkest - 1));
  };
  return {shade(8, 168), shade(40, 208), shade(100, 232)};
}

// Depths of the queues in the cycles asked for; none in those after the end.
std::map<std::int64_t, Depths> watch_light(const std::string& scene, LightMode mode,
                                           const QueuesOptions& options, ProgressBar& bar) {
  SceneOptions loaded;
  loaded.scene = scene;
  loaded.n = options.n;
  check_options(loaded);
  MachineConfig config;
  config.n = options.n;
  config.max_distance = 2 * options.n;
  config.max_fa = options.fa;
  config.feeders = default_feeders(options.n);
  config.mode = mode;
  config.skips = false;  // the wave is to be seen, not what a scene leaves of it
  cycle::CycleMachine machine(config);
  machine.load(prepare(loaded).facets.packets, bar.step(loaded.scene + ", loading"));
  std::map<std::int64_t, Depths> frames;
  machine.observe([&](std::int64_t cycle, const Depths& depths) {
    const bool wanted =
        std::find(options.times.begin(), options.times.end(), cycle) != options.times.end();
    if (wanted) frames[cycle] = depths;
  });
  const glm::ivec3 source = choose_sources(scene, machine.read_voxels(), options.n)[1].voxel;
  const LightResult light =
      machine.light({source, 2 * options.n, options.fa}, bar.step(loaded.scene));
  bar.wipe();
  fmt::print("{}, {}: {} cycles\n", loaded.scene, to_string(mode), light.cycles);
  return frames;
}

ExitCode draw_queues(const QueuesOptions& options) {
  Outputs outputs;
  outputs.add_file(options.out);
  ProgressBar bar;
  const auto rows = static_cast<int>(options.times.size());
  const auto columns = static_cast<int>(options.scenes.size() * options.modes.size());
  picture::ContactSheet sheet(options.n, columns, rows, kSide);
  for (int row = 0; row < rows; ++row) {
    sheet.label(row, options.times[static_cast<std::size_t>(row)]);
  }
  int column = 0;
  for (const std::string& scene : options.scenes) {
    for (const std::string& mode : options.modes) {
      const auto frames = within_memory(
          options.n, [&] { return watch_light(scene, parse_light_mode(mode), options, bar); });
      for (int row = 0; row < rows; ++row) {
        const auto frame = frames.find(options.times[static_cast<std::size_t>(row)]);
        sheet.draw(row, column, [&](int x, int y) {
          const std::size_t cell = cycle::cell_number(x, y, options.n);
          return colour_of(frame == frames.end() ? 0 : frame->second[cell]);
        });
      }
      ++column;
    }
  }
  picture::write_png(options.out, sheet.take());
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_queues(Command& program) {
  auto options = std::make_shared<QueuesOptions>();
  Command command = program.command(
      "queues",
      "Draws how deep the queues are while a light aside spreads, L = 2n: a row for each time, a "
      "column for each scene and mode");
  command.option("SCENE", options->scenes, "Files that Assimp reads, or generated scenes")
      .required();
  command.option("--n", options->n, "Cells per side and voxels per column, 2 to 128")
      .within(2, kSide);
  command.option("--fa", options->fa, "Beams that a cell has room for, 1 to 64").within(1, 64);
  command.option("--mode", options->modes, "How light spreads: fast, thesis")
      .list()
      .one_of({"fast", "thesis"});
  command.option("--times", options->times, "Cycles that are shown")
      .list()
      .within(std::int64_t{1}, std::int64_t{999'999});
  command.option("--out", options->out, "The file to write").type("FILE.png").required();
  command.run([options] { return draw_queues(*options); });
}

}  // namespace rc2
