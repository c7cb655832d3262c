// Voxels of random facets on the golden machine and the cycle model against an exact oracle.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <map>

#include "sw/base/config.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/golden/golden_machine.h"
#include "tb/load/facet_case.h"
#include "tb/load/golden_check.h"
#include "tb/load/machine_check.h"

namespace {

using namespace rc2::facet;

constexpr std::array kRules{Rule::armoured, Rule::naive, Rule::supercover, Rule::half,
                            Rule::blindee};
const std::vector<int> kSides{4, 5, 7, 8, 16, 31, 64, 127, 256, 511, 1000, 1024};
const std::vector<int> kMachineSides{4, 5, 7, 8, 16, 31, 64};

constexpr std::int64_t kColumns = 16384;  // see draw_case
constexpr int kCasesPerLoad = 24;
constexpr int kVoxelsApart = 4;

struct Options {
  std::int64_t facets = 30000, from = 0, loads = -1, columns = 4096;
  std::uint64_t seed = 1;
  std::string rule;
};

class Run {
 public:
  explicit Run(const Options& options) : options_(options), rules_(kRules.begin(), kRules.end()) {
    if (!options.rule.empty()) rules_ = {parse_rule(options.rule)};
  }

  void check_golden() {
    std::int64_t facets = 0;
    for (number_ = options_.from; facets < options_.facets; ++number_) {
      const FacetCase drawn = draw_case(options_.seed, number_, kSides, kColumns);
      for (const Border& border : drawn.borders) {
        what_ = fmt::format("{} facet, {}", to_string(drawn.kind), describe(border, drawn.cube));
        for (const Rule rule : rules_) check_one(drawn, border, rule);
        ++facets;
        ++per_side_[drawn.cube.n];
        ++per_fraction_[drawn.cube.fraction_bits];
      }
    }
  }

  void check_machines() {
    const std::int64_t loads = options_.loads < 0 ? options_.facets / 100 : options_.loads;
    is_loading_ = true;
    for (number_ = options_.from; loads_ < loads; ++number_) {
      Dice dice(Dice(options_.seed).bits() + static_cast<std::uint64_t>(number_));
      const auto side = dice.roll(0, static_cast<std::int64_t>(kMachineSides.size()) - 1);
      const Cube cube{kMachineSides[static_cast<std::size_t>(side)],
                      static_cast<int>(dice.roll(0, rc2::kMaxFractionBits))};
      rule_ = rules_[static_cast<std::size_t>(number_) % rules_.size()];
      const std::vector<Border> borders =
          draw_apart(options_.seed, number_, cube, kCasesPerLoad, kVoxelsApart);
      rc2::MachineConfig config;
      config.n = cube.n;
      config.fraction_bits = cube.fraction_bits;
      config.feeders = random_feeders(cube.n, dice);
      what_ = fmt::format("a load of {} facets, n = {}, f = {}, {} feeders", borders.size(), cube.n,
                          cube.fraction_bits, config.feeders);
      rc2::golden::GoldenMachine golden(config);
      rc2::cycle::CycleMachine cycle(config);
      loaded_voxels_ += rc2::facet::check_machines({&golden, &cycle}, borders, cube, rule_);
      loaded_cells_ += std::int64_t{cube.n} * cube.n * cube.n;
      loaded_facets_ += static_cast<std::int64_t>(borders.size());
      ++loads_;
    }
  }

  void print() const {
    fmt::print("{:13} {:10} {:>9} {:>9} {:>13} {:>15} {:>13} {:>11}\n", "class", "rule", "facets",
               "sampled", "columns", "voxels", "filled", "differences");
    Compared all;
    for (const auto& [key, sum] : sums_) {
      print(to_string(key.first), to_string(key.second), sum);
      all += sum;
    }
    print("all", "", all);
    fmt::print("\nfacets per n:");
    for (const auto& [n, count] : per_side_) fmt::print(" {}: {},", n, count);
    fmt::print("\nfacets per f:");
    for (const auto& [f, count] : per_fraction_) fmt::print(" {}: {},", f, count);
    fmt::print(
        "\nwhole machines, golden and cycle: {} loads of {} facets, {} voxels, {} filled, 0 "
        "differences\n",
        loads_, loaded_facets_, loaded_cells_, loaded_voxels_);
  }

  std::string where() const {
    return fmt::format("{}\nAgain: oracle_run --seed {} --from {} --rule {} {}", what_,
                       options_.seed, number_, to_string(rule_),
                       is_loading_ ? "--facets 0 --loads 1" : "--facets 1 --loads 0");
  }

 private:
  static void print(const char* kind, const char* rule, const Compared& sum) {
    fmt::print("{:13} {:10} {:>9} {:>9} {:>13} {:>15} {:>13} {:>11}\n", kind, rule, sum.facets,
               sum.sampled, sum.columns, sum.voxels, sum.filled, 0);
  }

  void check_one(const FacetCase& drawn, const Border& border, Rule rule) {
    rule_ = rule;
    Dice dice(options_.seed + static_cast<std::uint64_t>(number_));
    sums_[{drawn.kind, rule}] += golden_.check(border, drawn.cube, rule, options_.columns, dice);
  }

  const Options& options_;
  std::vector<Rule> rules_;
  GoldenCheck golden_;
  std::map<std::pair<FacetClass, Rule>, Compared> sums_;
  std::map<int, std::int64_t> per_side_, per_fraction_;
  std::int64_t loads_ = 0, loaded_facets_ = 0, loaded_cells_ = 0, loaded_voxels_ = 0;
  std::int64_t number_ = 0;
  Rule rule_ = Rule::armoured;
  bool is_loading_ = false;
  std::string what_;
};

int run_program(int argc, char** argv) {
  Options options;
  CLI::App app("Compares random facets voxel by voxel with an exact oracle.");
  app.add_option("--facets", options.facets, "facets, each under every rule");
  app.add_option("--seed", options.seed, "of all facets");
  app.add_option("--rule", options.rule, "only this rule");
  app.add_option("--from", options.from, "number of the first case and load, to see one again");
  app.add_option("--loads", options.loads, "loads of whole machines; default: facets / 100");
  app.add_option("--columns", options.columns, "columns compared per facet and rule at most");
  CLI11_PARSE(app, argc, argv);

  Run run(options);
  try {
    run.check_golden();
    run.check_machines();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n{}\n", error.what(), run.where());
    return 1;
  }
  run.print();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
    return 2;
  }
}
