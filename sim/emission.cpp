// Thesis 4.1 and 4.2: what each way of finding out what a light reaches costs.
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "sim/job.h"
#include "sim/light_sources.h"
#include "sim/table_command.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/emission/beams.h"
#include "sw/emission/rays.h"

namespace rc2 {
namespace {

using emission::Cost;
using emission::Ledger;
using emission::Targets;

// FA of the cycle model's cells, in both modes.
constexpr int kQueue = 8;

struct Row {
  std::string scene;
  int n;
  const char* source;
  std::size_t occupied;
  const char* way;
  Cost cost;
  std::int64_t cycles;         // that it takes; of rays, no less than
  std::int64_t lit = 0;        // occupied voxels
  std::int64_t differ = 0;     // occupied voxels for which the rays of 4.3 find otherwise
  std::int64_t untouched = 0;  // free voxels that nothing came to, but for the light's
  std::int64_t looks = 0;      // entries of tables
};

std::vector<glm::ivec3> places_of(const VoxelMemory& voxels) {
  std::vector<glm::ivec3> places;
  places.reserve(voxels.size());
  for (const VoxelRecord& voxel : voxels) places.push_back(voxel.at);
  return places;
}

// The foremost voxel of each column: what primary rays from the front hit (4.1.3).
std::vector<glm::ivec3> seen_of(const VoxelMemory& voxels) {
  std::map<std::pair<int, int>, glm::ivec3> foremost;  // voxels come in the order of their z
  for (const VoxelRecord& voxel : voxels) foremost[{voxel.at.y, voxel.at.x}] = voxel.at;
  std::vector<glm::ivec3> places;
  places.reserve(foremost.size());
  for (const auto& [column, place] : foremost) places.push_back(place);
  return places;
}

golden::Grid grid_of(const VoxelMemory& voxels, int n) {
  golden::Grid grid(n);
  for (std::size_t i = 0; i < voxels.size(); ++i)
    grid[grid.index(voxels[i].at)] = static_cast<std::uint32_t>(i);
  return grid;
}

std::unique_ptr<cycle::CycleMachine> cycle_machine(int n, LightMode mode,
                                                   const facet::PacketStream& packets) {
  MachineConfig config;
  config.n = n;
  config.max_distance = n;
  config.max_fa = kQueue;
  config.mode = mode;
  config.skips = false;
  auto machine = std::make_unique<cycle::CycleMachine>(config);
  machine->load(packets, {});
  return machine;
}

class Bench {
 public:
  Bench(const std::string& scene, int n, std::vector<Row>& rows) : n_(n), grid_(n), rows_(rows) {
    SceneOptions options;
    options.scene = scene;
    options.n = n;
    check_options(options);
    const facet::PacketStream packets = prepare(options).facets.packets;
    name_ = scene::is_generated_name(options.scene)
                ? options.scene
                : std::filesystem::path(options.scene).filename().string();
    cells_ = cycle_machine(n, LightMode::thesis, packets);
    lanes_ = cycle_machine(n, LightMode::fast, packets);
    voxels_ = cells_->read_voxels();
    grid_ = grid_of(voxels_, n);
  }

  void measure(const Progress& progress) {
    const std::vector<LightSource> sources = choose_sources(name_, voxels_, n_);
    for (std::size_t i = 0; i < sources.size(); ++i) {
      progress("light", 0, static_cast<double>(i) / static_cast<double>(sources.size()));
      source_ = sources[i];
      measure_source();
    }
  }

 private:
  void measure_source() {
    Ledger reference = ledger();
    send_one_by_one(reference, Targets::virtual_, source_.voxel);
    expected_ = reference.lit();

    const auto ask = [this](const std::vector<glm::ivec3>& voxels) {
      return [this, &voxels](Ledger& ledger) { ask_light(ledger, voxels, source_.voxel); };
    };
    add_rays("ask-all", ask(places_of(voxels_)), false);
    add_rays("ask-seen", ask(seen_of(voxels_)), false);
    const auto send = [this](Targets targets) {
      return [this, targets](Ledger& ledger) { send_one_by_one(ledger, targets, source_.voxel); };
    };
    add_rays("voxels", send(Targets::voxels), true);
    add_rays("border", send(Targets::border), true);
    add_rays("virtual", send(Targets::virtual_), true);

    const LightJob job{source_.voxel, n_ - 1, kQueue};
    const std::int64_t cycles = cells_->light(job, {}).cycles;
    Ledger beams = ledger();
    send_beams(beams, source_.voxel);
    add("beams", beams, cycles);
    Ledger table = ledger();
    const std::int64_t looks = send_beams_by_table(table, source_.voxel);
    add("table", table, cycles).looks = looks;

    const LightResult light = lanes_->light(job, {});
    const LightMemory arrived = lanes_->read_light();
    Row& row = add("lanes", {6, light.visits, 0, 0}, light.cycles);
    compare(row, {arrived.begin(), arrived.end()});
  }

  Ledger ledger() const { return {grid_, voxels_.size()}; }

  // A cell handles one ray in a cycle, and the source sends one in a cycle.
  template <typename Run>
  void add_rays(const char* way, const Run& run, bool source_sends) {
    Ledger ledger = this->ledger();
    run(ledger);
    const Cost& cost = ledger.cost();
    add(way, ledger, source_sends ? std::max(cost.busiest, cost.rays) : cost.busiest);
  }

  Row& add(const char* way, const Ledger& ledger, std::int64_t cycles) {
    Row& row = add(way, ledger.cost(), cycles);
    row.untouched = ledger.untouched() - 1;
    compare(row, ledger.lit());
    return row;
  }

  Row& add(const char* way, const Cost& cost, std::int64_t cycles) {
    return rows_.emplace_back(Row{name_, n_, source_.name, voxels_.size(), way, cost, cycles});
  }

  void compare(Row& row, const std::vector<bool>& lit) const {
    for (std::size_t i = 0; i < lit.size(); ++i) {
      row.lit += lit[i];
      row.differ += lit[i] != expected_[i];
    }
  }

  int n_;
  std::string name_;
  std::unique_ptr<cycle::CycleMachine> cells_, lanes_;
  VoxelMemory voxels_;
  golden::Grid grid_;
  LightSource source_{};
  std::vector<bool> expected_;  // what the rays of 4.3 light
  std::vector<Row>& rows_;
};

void print(const std::vector<Row>& rows) {
  fmt::print("{:<16}{:>5}  {:<7}{:>9}  {:<9}{:>10}{:>13}{:>13}{:>10}{:>10}{:>9}{:>9}{:>10}\n",
             "scene", "n", "source", "occupied", "way", "rays", "visits", "messages", "busiest",
             "cycles", "lit", "differ", "untouched");
  for (const Row& row : rows)
    fmt::print("{:<16}{:>5}  {:<7}{:>9}  {:<9}{:>10}{:>13}{:>13}{:>10}{:>10}{:>9}{:>9}{:>10}\n",
               row.scene, row.n, row.source, row.occupied, row.way, row.cost.rays, row.cost.visits,
               row.cost.messages, row.cost.busiest, row.cycles, row.lit, row.differ, row.untouched);
}

std::string to_csv(const std::vector<Row>& rows) {
  std::string csv =
      "scene,n,source,occupied,way,rays,visits,messages,busiest,cycles,lit,differ,untouched,"
      "looks\n";
  for (const Row& row : rows)
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.scene, row.n, row.source,
                       row.occupied, row.way, row.cost.rays, row.cost.visits, row.cost.messages,
                       row.cost.busiest, row.cycles, row.lit, row.differ, row.untouched, row.looks);
  return csv;
}

}  // namespace

void declare_emission(Command& program) {
  auto options = std::make_shared<TableOptions>();
  options->sides = {16, 32};
  Command command = program.command(
      "emission",
      "Counts rays, voxels and messages of each way to find what a light reaches (4.1, 4.2)");
  declare_table_options(command, *options, "Files that Assimp reads, or generated scenes");
  command.run([options] {
    return make_table<Row>(
        *options,
        [](const std::string& scene, int n, ProgressBar& bar, std::vector<Row>& rows) {
          Bench(scene, n, rows).measure(bar.step(fmt::format("{}, n = {}", scene, n)));
        },
        print, to_csv);
  });
}

}  // namespace rc2
