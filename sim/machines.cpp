#include "sim/machines.h"

#include <fmt/format.h>

#include <algorithm>

#include "sw/cycle/cycle_machine.h"
#include "sw/golden/golden_machine.h"

namespace rc2 {
namespace {

void check_limit(const char* option, int asked, int limit, const std::string& how, int n) {
  if (asked <= limit) return;
  throw Error(
      fmt::format("{} {}: the Verilated machine of n = {} was built for at most {}; ask "
                  "for less, or {} and `make rtl N={}`",
                  option, asked, n, limit, how, n));
}

}  // namespace

std::unique_ptr<Machine> make_machine(const std::string& name, const MachineConfig& job,
                                      const WaveWindow& waves) {
  if (name == "rtl") {
    const char* cells = job.ray_depth > 0               ? "rays_"
                        : job.mode == LightMode::thesis ? "thesis_"
                                                        : "";
    auto machine = make_rtl_machine(fmt::format("{}n{}", cells, job.n), waves);
    const MachineConfig& built = machine->config();
    check_limit("--fraction-bits", job.fraction_bits, built.fraction_bits,
                fmt::format("`cmake -D RC2_RTL_F={} build`", job.fraction_bits), job.n);
    check_limit("--target-distance", job.max_distance, built.max_distance,
                "raise RC2_LMAX in rtl/rc2_pkg.sv", job.n);
    check_limit("--fa", job.max_fa, built.max_fa, "raise RC2_FAMAX in rtl/rc2_pkg.sv", job.n);
    check_limit("--depth", job.ray_depth, built.ray_depth, "raise RC2_RAYDEPTH in rtl/rc2_pkg.sv",
                job.n);
    check_limit("--queue", job.ray_queue, built.ray_queue, "raise RC2_RAYQ in rtl/rc2_pkg.sv",
                job.n);
    if (built.skips && !job.skips) {
      throw Error(fmt::format(
          "--skip off: the Verilated machine of n = {} was built to skip; use --machine cycle",
          job.n));
    }
    if (job.feeders != built.feeders) {
      throw Error(fmt::format(
          "--feeders {}: the Verilated machine of n = {} was built with {} row feeders; ask for "
          "that many, or change RC2_FEEDERS in rtl/rc2_pkg.sv and `make rtl N={}`",
          job.feeders, job.n, built.feeders, job.n));
    }
    return machine;
  }
  MachineConfig config = job;
  config.max_distance = std::max(job.max_distance, 4 * job.n);
  config.max_fa = std::max(job.max_fa, 32);
  if (name == "cycle") return std::make_unique<cycle::CycleMachine>(config);
  return std::make_unique<golden::GoldenMachine>(config);
}

}  // namespace rc2
