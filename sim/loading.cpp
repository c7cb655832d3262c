// Chapter 3: cycles to load scenes, with few or many row feeders, beside the thesis's wave.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>

#include "sim/commands.h"
#include "sim/job.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/base/replace_file.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/machine/checks.h"
#include "sw/machine/feeder.h"

namespace rc2 {
namespace {

using facet::PacketHead;
using facet::PacketStream;

// In the wave every cell sees every packet, which takes long to simulate: a sample has to do. It
// must be larger than what the pipes hold, two words in each stage.
constexpr int kSample = 512, kSmallestSample = 4;

struct LoadingOptions {
  std::vector<std::string> scenes;
  std::vector<int> sides = {64, 256};
  std::vector<int> feeders = {1, 2, 4, 8, 16};
  int sample = kSample;
  std::string out;
};

// With some number of feeders.
struct Load {
  int feeders;
  std::int64_t feeder_words;  ///< of the feeder that has most
  std::int64_t cycles;
};

// The thesis's wave, all of it or scaled up from a sample of the packets.
struct Wave {
  std::size_t sample;
  double per_facet;          ///< what half the sample adds to the other half
  double per_facet_of_half;  ///< likewise, of half the sample
  std::int64_t cycles;       ///< of all packets
};

struct Measured {
  std::string scene;
  int n;
  std::size_t facets;
  std::int64_t words;       ///< of all packets, each once
  std::int64_t row_words;   ///< of the row that sees most: what no number of feeders undercuts
  std::int64_t cell_words;  ///< of the cell that sees most
  std::vector<Load> loads;
  Wave wave;

  std::int64_t bound(const Load& load) const { return std::max(load.feeder_words, cell_words); }
  const char* bound_by(const Load& load) const {
    return load.feeder_words >= cell_words ? "feeder" : "cell";
  }
  double to_bound(const Load& load) const {
    return static_cast<double>(load.cycles) / static_cast<double>(bound(load));
  }
  double per_facet(const Load& load) const {
    return static_cast<double>(load.cycles) / static_cast<double>(facets);
  }
  double gain(const Load& load) const {
    return static_cast<double>(wave.cycles) / static_cast<double>(load.cycles);
  }
};

std::int64_t count_words(const PacketStream& packets) {
  return std::accumulate(packets.heads.begin(), packets.heads.end(), std::int64_t{0},
                         [](auto sum, const auto& head) { return sum + words_of(head); });
}

std::int64_t busiest_cell_words(const PacketStream& packets, int n) {
  const auto side = static_cast<std::size_t>(n);
  std::vector<std::int64_t> words(side * side);
  for (const PacketHead& head : packets.heads) {
    for (int y = head.lo.y; y <= head.hi.y; ++y) {
      for (int x = head.lo.x; x <= head.hi.x; ++x) {
        words[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)] += words_of(head);
      }
    }
  }
  return *std::max_element(words.begin(), words.end());
}

// Of a cell that divides whatever it can be asked to divide.
int most_cycles(const PacketStream& packets, const PacketHead& head) {
  int divided = head.slab.value.c != 0 ? 1 : 0;
  for (std::uint32_t i = 0; i < head.side_count; ++i) {
    if (packets.sides[head.first_side + i].value.c != 0) ++divided;
  }
  return static_cast<int>(words_of(head)) + divided * bits_for(head.hi.z - head.lo.z + 1);
}

// Some of the packets as the thesis sends them: past all cells. The box keeps its range of z, and
// so the divisions the few bits that they need. The packets are picked evenly from all, ordered by
// what they can cost, so that even a small sample has the mean of all.
PacketStream widened_sample(const PacketStream& packets, std::size_t count, int n) {
  std::vector<PacketHead> heads = packets.heads;
  std::stable_sort(heads.begin(), heads.end(), [&](const PacketHead& a, const PacketHead& b) {
    return most_cycles(packets, a) < most_cycles(packets, b);
  });
  PacketStream wide;
  wide.sides = packets.sides;
  for (std::size_t k = 0; k < count; ++k) {
    PacketHead head = heads[(2 * k + 1) * heads.size() / (2 * count)];
    const auto from_corner = [&](facet::Linear& value) {
      value.d -= value.a * head.lo.x + value.b * head.lo.y;
    };
    from_corner(head.slab.value);
    from_corner(head.gap);
    for (std::uint32_t i = 0; i < head.side_count; ++i) {
      from_corner(wide.sides[head.first_side + i].value);
    }
    head.lo.x = head.lo.y = 0;
    head.hi.x = head.hi.y = n - 1;
    wide.heads.push_back(head);
  }
  return wide;
}

std::int64_t cycles_to_load(const PacketStream& packets, int n, int feeders,
                            const Progress& progress) {
  MachineConfig config;
  config.n = n;
  config.max_distance = config.max_fa = 1;
  config.feeders = feeders;
  return cycle::CycleMachine(config).load(packets, progress).cycles;
}

Wave measure_wave(const PacketStream& packets, std::size_t most, int n, const Progress& progress) {
  const std::size_t all = packets.heads.size(), sample = std::min(most, all);
  const auto cycles = [&](std::size_t count) {
    return cycles_to_load(widened_sample(packets, count, n), n, 1, progress);
  };
  const auto ratio = [](std::int64_t cycles_of, std::size_t count) {
    return static_cast<double>(cycles_of) / static_cast<double>(count);
  };
  const std::int64_t of_sample = cycles(sample);
  if (sample == all) return {all, ratio(of_sample, all), ratio(of_sample, all), of_sample};
  const std::size_t half = sample / 2, quarter = sample / 4;
  const std::int64_t of_half = cycles(half), of_quarter = cycles(quarter);
  const double per_facet = ratio(of_sample - of_half, sample - half);
  return {sample, per_facet, ratio(of_half - of_quarter, half - quarter),
          of_sample + std::llround(per_facet * static_cast<double>(all - sample))};
}

Measured measure(const std::string& scene, int n, const LoadingOptions& options, ProgressBar& bar) {
  SceneOptions loaded;
  loaded.scene = scene;
  loaded.n = n;
  check_options(loaded);
  const PacketStream packets = prepare(loaded).facets.packets;
  if (packets.heads.empty()) {
    throw Error(
        fmt::format("{}: no facet is left to load with n = {}; choose another scene", scene, n));
  }
  const std::string name = std::filesystem::path(scene).filename();
  const std::string title = fmt::format("{}, n = {}", name, n);
  Measured found{name,
                 n,
                 packets.heads.size(),
                 count_words(packets),
                 busiest_feeder_words(packets, n),  // a feeder for each row
                 busiest_cell_words(packets, n),
                 {},
                 measure_wave(packets, static_cast<std::size_t>(options.sample), n,
                              bar.step(title + ", wave"))};
  for (const int feeders : options.feeders) {
    const Progress progress = bar.step(fmt::format("{}, R = {}", title, feeders));
    found.loads.push_back({feeders, busiest_feeder_words(packets, feeders),
                           cycles_to_load(packets, n, feeders, progress)});
  }
  return found;
}

void print(const Measured& found) {
  fmt::print("\n{}, n = {}; facets: {}, words: {}, of the busiest row: {}, cell: {}\n", found.scene,
             found.n, found.facets, found.words, found.row_words, found.cell_words);
  const Wave& wave = found.wave;
  if (wave.sample == found.facets) {
    fmt::print("thesis wave: {} cycles, {:.2f} per facet\n", wave.cycles, wave.per_facet);
  } else {
    fmt::print(
        "thesis wave: about {} cycles, scaled up from a sample of {} facets: {:.2f} per facet\n"
        "({:.2f} from half of it)\n",
        wave.cycles, wave.sample, wave.per_facet, wave.per_facet_of_half);
  }
  fmt::print("{:>4}{:>16}{:>10}{:>11}{:>12}{:>12}{:>14}\n", "R", "busiest feeder", "bound by",
             "cycles", "to bound", "per facet", "wave / ours");
  for (const Load& load : found.loads) {
    fmt::print("{:>4}{:>16}{:>10}{:>11}{:>12.3f}{:>12.3f}{:>14.2f}\n", load.feeders,
               load.feeder_words, found.bound_by(load), load.cycles, found.to_bound(load),
               found.per_facet(load), found.gain(load));
  }
}

std::string to_csv(const std::vector<Measured>& all) {
  std::string csv =
      "scene,n,facets,words,row_words,cell_words,feeders,feeder_words,bound,bound_by,cycles,cycles_"
      "to_bound,"
      "cycles_per_facet,wave_sample,wave_cycles_per_facet,wave_cycles_per_facet_of_half,"
      "wave_cycles,wave_to_ours\n";
  for (const Measured& found : all) {
    for (const Load& load : found.loads) {
      csv += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{},{:.6f},{:.6f},{},{:.6f},{:.6f},{},{:.6f}\n",
          found.scene, found.n, found.facets, found.words, found.row_words, found.cell_words,
          load.feeders, load.feeder_words, found.bound(load), found.bound_by(load), load.cycles,
          found.to_bound(load), found.per_facet(load), found.wave.sample, found.wave.per_facet,
          found.wave.per_facet_of_half, found.wave.cycles, found.gain(load));
    }
  }
  return csv;
}

ExitCode measure_loading(const LoadingOptions& options) {
  for (const int n : options.sides) {
    for (const int feeders : options.feeders) check_feeders("--feeders", feeders, n);
  }
  Outputs outputs;
  if (!options.out.empty()) outputs.add_file(options.out);
  ProgressBar bar;
  std::vector<Measured> all;
  for (const std::string& scene : options.scenes) {
    for (const int n : options.sides) {
      within_memory(n, [&] { all.push_back(measure(scene, n, options, bar)); });
    }
  }
  bar.wipe();
  fmt::print(
      "Loading on the cycle model (armoured rule). R feeders take a word each per cycle. The\n"
      "bound: no load is shorter than the words of the busiest feeder, or of the busiest cell.\n"
      "The thesis wave: the same words, past all n x n cells from one feeder.\n");
  for (const Measured& found : all) print(found);
  if (!options.out.empty()) replace_file(options.out, to_csv(all));
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_loading(Command& program) {
  auto options = std::make_shared<LoadingOptions>();
  Command command = program.command(
      "loading",
      "Counts the cycles that scenes take to load, beside the thesis's wave (chapter 3)");
  command.option("SCENE", options->scenes, "Files that Assimp reads, or generated scenes")
      .required();
  command
      .option("--n", options->sides,
              fmt::format("Cells per side and voxels per column, 2 to {}", kMaxSide))
      .list()
      .within(2, kMaxSide);
  command.option("--feeders", options->feeders, "Numbers of row feeders, powers of two up to n")
      .list();
  command
      .option("--sample", options->sample,
              "Facets that the wave is simulated with, evenly picked; the others are reckoned")
      .within(kSmallestSample, kMaxFacets);
  command.option("--out", options->out, "Write the table to this CSV file").type("FILE.csv");
  command.run([options] { return measure_loading(*options); });
}

}  // namespace rc2
