// Adversarial scenes through the whole path: packets, voxels, layers, light.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <vector>

#include "sim/rtl_machine.h"
#include "sw/base/config.h"
#include "sw/base/replace_file.h"
#include "tb/stress/rounding.h"
#include "tb/stress/trial.h"

namespace {

using namespace rc2::stress;

// 2 and 3, primes, powers of two and their neighbours. Large ones are in `make oracle`.
const std::vector kSides{2, 3, 4, 5, 7, 8, 11, 13, 16, 17};
const std::vector kLargeSides{31, 32, 37};
constexpr int kOneInLarge = 25;
constexpr std::int64_t kShown = 20;  // differences told in full

struct Options {
  std::int64_t trials = 30, from = 0;
  std::uint64_t seed = 1;
  std::string attack, out;
  std::vector<int> rtl;
};

// The Verilated machines of one side, made when they are first asked for.
class RtlMachines {
 public:
  const std::vector<Named>& of_side(int n) {
    std::vector<Named>& machines = made_[n];
    if (machines.empty()) {
      machines.push_back({"rtl, fast", rc2::make_rtl_machine(fmt::format("n{}", n), {})});
      machines.push_back({"rtl, thesis", rc2::make_rtl_machine(fmt::format("thesis_n{}", n), {})});
    }
    return machines;
  }

 private:
  std::map<int, std::vector<Named>> made_;
};

class Run {
 public:
  explicit Run(const Options& options) : options_(options) {}

  void check() {
    for (const Attack& attack : attacks()) {
      if (!options_.attack.empty() && options_.attack != attack.name) continue;
      for (std::int64_t i = options_.from; i < options_.from + options_.trials; ++i)
        check(attack, i);
    }
    if (options_.attack.empty())
      differences_ += check_rounding(options_.seed, options_.trials, findings_);
  }

  std::string csv() const {
    std::string text =
        "heading,entry,tries,trials,facets,without_area,voxels,lights,targets,refused,"
        "differences\n";
    for (const auto& [heading, entries] : findings_.all())
      for (const auto& [entry, tally] : entries)
        text +=
            fmt::format("{},\"{}\",\"{}\",{},{},{},{},{},{},{},{}\n", heading, entry, tries(entry),
                        tally.trials, tally.facets, tally.without_area, tally.voxels, tally.lights,
                        tally.targets, tally.refused, tally.differences);
    return text;
  }

  void print() const {
    for (const auto& [heading, entries] : findings_.all()) {
      fmt::print("{:<28}{:>7}{:>8}{:>8}{:>12}{:>8}{:>17}{:>8}{:>6}\n", heading, "trials", "facets",
                 "no area", "voxels", "lights", "targets", "refused", "wrong");
      for (const auto& [entry, tally] : entries)
        fmt::print("{:<28}{:>7}{:>8}{:>8}{:>12}{:>8}{:>17}{:>8}{:>6}\n", entry, tally.trials,
                   tally.facets, tally.without_area, tally.voxels, tally.lights, tally.targets,
                   tally.refused, tally.differences);
    }
    fmt::print("differences: {}\n", differences_);
  }

  bool agrees() const { return differences_ == 0; }

 private:
  static const char* tries(const std::string& name) {
    for (const Attack& attack : attacks())
      if (attack.name == name) return attack.tries;
    return "";
  }

  // Whatever is thrown is wrong: what a machine may refuse is counted further down.
  void check(const Attack& attack, std::int64_t number) {
    Dice dice(Dice(options_.seed).bits() ^ Dice(static_cast<std::uint64_t>(number)).bits());
    const int n = side(static_cast<std::size_t>(number));
    const std::vector<Named> more = options_.rtl.empty() ? std::vector<Named>{} : rtl_.of_side(n);
    const int finest =
        more.empty() ? rc2::kMaxFractionBits : more[0].machine->config().fraction_bits;
    const Cube cube{n, static_cast<int>(dice.roll(0, finest))};
    try {
      run_trial(attack, cube, dice.bits(), more, findings_);
    } catch (const std::exception& error) {
      ++findings_.at("attack", attack.name).differences;
      if (++differences_ > kShown) return;
      fmt::print(stderr,
                 "{}, n = {}, f = {}: {}\nAgain: stress_run --attack \"{}\" --seed {} --from {} "
                 "--trials 1{}{}\n",
                 attack.name, cube.n, cube.fraction_bits, error.what(), attack.name, options_.seed,
                 number, options_.rtl.empty() ? "" : " --rtl ", fmt::join(options_.rtl, " "));
    }
  }

  int side(std::size_t number) const {
    if (!options_.rtl.empty()) return options_.rtl[number % options_.rtl.size()];
    const bool is_large = number % kOneInLarge == kOneInLarge - 1;
    return is_large ? kLargeSides[number / kOneInLarge % kLargeSides.size()]
                    : kSides[number % kSides.size()];
  }

  const Options& options_;
  RtlMachines rtl_;
  Findings findings_;
  std::int64_t differences_ = 0;
};

int run_program(int argc, char** argv) {
  Options options;
  CLI::App app("Adversarial numbers through the whole path, against exact oracles.");
  app.add_option("--trials", options.trials, "scenes of each attack");
  app.add_option("--seed", options.seed, "of all scenes");
  app.add_option("--attack", options.attack, "only this one");
  app.add_option("--from", options.from, "number of the first scene, to see one again");
  app.add_option("--rtl", options.rtl,
                 "on the Verilated machines too, with these sides instead of all");
  app.add_option("--out", options.out, "write the table to this CSV file");
  CLI11_PARSE(app, argc, argv);

  Run run(options);
  run.check();
  run.print();
  if (!options.out.empty()) rc2::replace_file(options.out, run.csv());
  return run.agrees() ? 0 : 1;
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
