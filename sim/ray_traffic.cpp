// How long the network takes to trace rays, and what holds it up (docs/render.md).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>

#include "sim/job.h"
#include "sim/render_job.h"
#include "sim/table_command.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/facet/optics.h"
#include "sw/report/laws.h"

namespace rc2 {
namespace {

struct RayTrafficOptions : TableOptions {
  RayTrafficOptions() { sides = {32, 64}; }
  std::vector<int> depths = {1, 4};
  std::vector<int> queues = {1, 2, 4};
  std::vector<int> looks = {RayUnits{}.looks}, arithmetic = {RayUnits{}.arithmetic};
  std::string view = "front";
  bool all_mirrors = false;

  std::vector<RayUnits> units() const {
    std::vector<RayUnits> all;
    for (const int of_look : looks)
      for (const int of_rest : arithmetic) all.push_back({of_look, of_rest});
    return all;
  }
};

struct Row {
  std::string scene;
  int n, depth, queue;
  RayCounts counts;
  RayTraffic traffic;
};

void measure(const std::string& name, int n, const RayTrafficOptions& options, ProgressBar& bar,
             std::vector<Row>& rows) {
  SceneOptions scene;
  scene.scene = name;
  scene.n = n;
  scene.fraction_bits = kRenderFraction;
  const Job job = prepare(scene, true);
  const std::string title = std::filesystem::path(name).filename().string();
  std::vector<rays::Facet> optics = facet::find_optics(job.facets.facets, job.scene.materials);
  if (options.all_mirrors) make_mirrors(optics);
  const std::vector<RayStart> starts = ray_starts(sights_of(job.scene, options.view, n), n);
  for (const RayUnits& units : options.units()) {
    MachineConfig config;
    config.n = n;
    config.fraction_bits = kRenderFraction;
    config.feeders = default_feeders(n);
    config.ray_units = units;
    cycle::CycleMachine machine(config);
    machine.load(job.facets.packets, bar.step(fmt::format("{}, n = {}: loading", title, n)));
    for (const int depth : options.depths) {
      for (const int queue : options.queues) {
        const RayJob rays{{depth, weight_of(kDefaultLeastWeight)},
                          &optics,
                          starts_for(options.view, starts),
                          queue};
        const RayResult result = machine.trace(
            rays,
            bar.step(fmt::format("{}, n = {}, depth {}, queues of {}", title, n, depth, queue)));
        report::check_rays(result);
        rows.push_back({title, n, depth, queue, result.counts, result.traffic});
      }
    }
  }
}

double ratio(std::int64_t a, std::int64_t b) {
  return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
}

// Of what all links could have carried.
double utilisation(const Row& row) {
  return ratio(row.traffic.messages, row.traffic.cycles * 4 * row.n * (row.n - 1));
}

void print(const std::vector<Row>& rows) {
  fmt::print(
      "{:<12}{:>5}{:>6}{:>6}{:>6}{:>6}{:>8}{:>7}{:>7}{:>7}{:>7}{:>7}{:>6}{:>9}{:>7}{:>8}{:>7}{:>8}"
      "\n",
      "scene", "n", "depth", "queue", "looks", "arith", "rays", "load", "look", "read", "launch",
      "meet", "link", "latency", "T", "T/max", "link %", "again %");
  for (const Row& row : rows) {
    const RayTraffic& of = row.traffic;
    const auto& [look, read, launch, meet] = of.work;
    fmt::print(
        "{:<12}{:>5}{:>6}{:>6}{:>6}{:>6}{:>8}{:>7}{:>7}{:>7}{:>7}{:>7}{:>6}{:>9}{:>7}{:>8.2f}{:>7."
        "2f}{:>8.2f}"
        "\n",
        row.scene, row.n, row.depth, row.queue, of.units.looks, of.units.arithmetic,
        row.counts.total(), of.load_cycles, look, read, launch, meet, of.busiest_link, of.latency,
        of.cycles, ratio(of.cycles, std::max(of.busiest().cycles, of.latency)),
        100 * utilisation(row), 100 * ratio(of.sent_again, row.counts.total()));
  }
}

std::string to_csv(const std::vector<Row>& rows) {
  std::string csv =
      "scene,n,depth,queue,looks,arithmetic,rays,probes,load,look,read,launch,meet,busiest,link,"
      "latency,T,utilisation,hops,waits,run_on,sent_again,max_stack\n";
  for (const Row& row : rows) {
    const RayTraffic& of = row.traffic;
    csv +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.5f},{},{},{},{},{}\n", row.scene,
                    row.n, row.depth, row.queue, of.units.looks, of.units.arithmetic,
                    row.counts.total(), row.counts.probes, of.load_cycles, fmt::join(of.work, ","),
                    of.busiest().cycles, of.busiest_link, of.latency, of.cycles, utilisation(row),
                    of.hops, of.waits, of.run_on, of.sent_again, of.max_stack);
  }
  return csv;
}

}  // namespace

void declare_ray_traffic(Command& program) {
  auto options = std::make_shared<RayTrafficOptions>();
  Command command = program.command(
      "ray-traffic", "Cycles that the cycle model takes to trace rays, and what holds them up");
  declare_table_options(command, *options,
                        "Files that Assimp reads, or generated scenes: those of run");
  declare_list(command, "--depth", options->depths, 0, rays::kMaxDepth, "Bounces");
  declare_list(command, "--queue", options->queues, 1, 1024, "Places of each queue");
  command.option("--looks", options->looks, "Looks of a cell").list().one_of({1, 2, 4});
  declare_list(command, "--arithmetic", options->arithmetic, 1, 2,
               "Units of a cell in which rays begin, and as many in which they meet a plane");
  declare_view(command, options->view);
  command.flag("--all-mirrors", options->all_mirrors, "Make every facet a perfect mirror");
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
