// Chapter 4: where the light of the golden model differs from that of the continuous scene.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include "sim/light_stage.h"
#include "sim/table_command.h"
#include "sw/golden/golden_machine.h"
#include "sw/report/laws.h"

namespace rc2 {
namespace {

struct LightErrorOptions : TableOptions {
  LightErrorOptions() { sides = {64, 128}; }
  std::vector<int> reaches = {2};
  std::vector<std::string> rules = {"thesis", "accurate"};
  int fraction_bits = 6;
};

struct Row {
  std::string scene;
  int n, reach;
  std::string rule;
  glm::ivec3 light;
  std::int64_t visits;
  std::array<Errors, kPopulations.size()> errors;
};

void measure(const std::string& name, int n, const LightErrorOptions& options, ProgressBar& bar,
             std::vector<Row>& rows) {
  const LightStage stage(name, n, options.fraction_bits, facet::Rule::armoured, {},
                         bar.step(fmt::format("{}, n = {}: loading", name, n)));
  MachineConfig config;
  config.n = n;
  config.fraction_bits = options.fraction_bits;
  config.max_distance = n * *std::max_element(options.reaches.begin(), options.reaches.end());
  golden::GoldenMachine machine(config);
  machine.load(stage.facets.packets, {});
  for (int i = 0; i < kStageLights; ++i) {
    const glm::ivec3 light = stage.light(i);
    const std::vector<truth::Verdict> verdicts = stage.judge(light);
    const std::vector<bool> away = stage.away(light);
    for (const int reach : options.reaches) {
      for (const std::string& rule : options.rules) {
        const LightJob job{light, reach * n, 1, parse_light_rule(rule)};
        const auto progress =
            bar.step(fmt::format("{}, n = {}, L = {}, {}", stage.title, n, reach * n, rule));
        const LightResult result = machine.light(job, progress);
        const LightMemory arrived = machine.read_light();
        report::check_light(result, arrived, job, stage.voxels.size());
        Row row{stage.title, n, reach, rule, light, result.visits, {}};
        for (std::size_t k = 0; k < kPopulations.size(); ++k)
          row.errors[k] = stage.shown.compare(verdicts, kPopulations[k], arrived, away);
        rows.push_back(row);
      }
    }
  }
}

// Errors over all lights, pooled.
void print(const std::vector<Row>& rows) {
  fmt::print("{:<28}{:>5}{:>5}{:>10}", "scene", "n", "L/n", "rule");
  for (const Population population : kPopulations) fmt::print("{:>26}", to_string(population));
  fmt::print("\n");
  for (std::size_t first = 0; first < rows.size();) {
    std::map<std::pair<int, std::string>, std::array<Errors, kPopulations.size()>> sums;
    std::size_t last = first;
    for (; last < rows.size() && rows[last].scene == rows[first].scene &&
           rows[last].n == rows[first].n;
         ++last)
      for (std::size_t i = 0; i < kPopulations.size(); ++i)
        sums[{rows[last].reach, rows[last].rule}][i].add(rows[last].errors[i]);
    for (const auto& [key, errors] : sums) {
      fmt::print("{:<28}{:>5}{:>5}{:>10}", rows[first].scene, rows[first].n, key.first, key.second);
      for (const Errors& of : errors)
        fmt::print("  {:>5.2f}+{:>5.2f} / {:>4.2f}+{:>4.2f}", of.percent(of.dark),
                   of.percent(of.lit), of.percent(of.dark_tolerant), of.percent(of.lit_tolerant));
      fmt::print("\n");
    }
    first = last;
  }
}

std::string to_csv(const std::vector<Row>& rows) {
  std::string csv =
      "scene,n,L,rule,light_x,light_y,light_z,visits,population,voxels,false_dark,false_lit,"
      "false_dark_tolerant,false_lit_tolerant\n";
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < kPopulations.size(); ++i) {
      const Errors& of = row.errors[i];
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.scene, row.n,
                         row.reach * row.n, row.rule, row.light.x, row.light.y, row.light.z,
                         row.visits, to_string(kPopulations[i]), of.voxels, of.dark, of.lit,
                         of.dark_tolerant, of.lit_tolerant);
    }
  }
  return csv;
}

}  // namespace

void declare_light_error(Command& program) {
  auto options = std::make_shared<LightErrorOptions>();
  Command command = program.command(
      "light-error", "Compares the light of the golden model with the continuous scene (Embree)");
  declare_table_options(command, *options,
                        "Files that Assimp reads, or generated scenes: those of run; boxes, tori, "
                        "plates:THICKNESS, sheets");
  declare_list(command, "--reach", options->reaches, 1, 8,
               "Distances L of the virtual faces, over n");
  command.option("--light-rule", options->rules, "Rules of light")
      .list()
      .one_of({"thesis", "accurate"});
  command.option("--fraction-bits", options->fraction_bits, "Vertices are multiples of 2^-f voxel")
      .within(0, kMaxFractionBits);
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
