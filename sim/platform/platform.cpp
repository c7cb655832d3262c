// rc2_platform: an example of RC2 in a SystemC virtual platform. A host, a memory and the TLM-2.0
// target in front of a machine do what `rc2 run` does.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "sim/commands.h"
#include "sim/drive.h"
#include "sim/machines.h"
#include "sim/outputs.h"
#include "sim/platform/bus.h"
#include "sim/platform/host.h"
#include "sim/platform/memory.h"
#include "sim/results.h"
#include "sw/tlm/target.h"

namespace rc2 {
namespace {

ExitCode render(RunOptions& options) {
  check_options(options);
  const Job job = prepare(options, options.rule_of_light() == LightRule::accurate);
  Lamps lamps = choose_lamps(options.lights, job.scene, options.n);
  Outputs outputs;
  outputs.add_folder(options.out);
  if (!options.dump.empty()) outputs.add_file(options.dump);
  const auto machine = make_machine(options.machine, options.needs(),
                                    {options.waves, options.waves_from, options.waves_cycles});

  const sc_core::sc_time period(10, sc_core::SC_NS);
  report::Memories memories;
  ProgressBar bar;
  const auto software = [&](Machine& seen) {
    Drive drive(seen, options.machine, bar);
    drive.load(job.facets);
    place_lamps(lamps, drive.memories().voxels, options.n);
    drive.light(lamps.list, options.distance(), options.fa, options.rule_of_light());
    memories = drive.memories();
  };
  tlm::Target target("rc2", *machine, period);
  Memory memory("memory", Bus::kMemory.size, period);
  Bus bus("bus");
  Host host("host", software, [&] { return target.last_error(); });
  host.socket.bind(bus.from_host);
  bus.to_memory.bind(memory.socket);
  bus.to_machine.bind(target.socket);
  ::tlm::tlm_global_quantum::instance().set(sc_core::sc_time(1, sc_core::SC_US));
  sc_core::sc_start();
  if (host.failure()) std::rethrow_exception(host.failure());

  report::Report report;
  write_pictures(options, job, lamps.list, memories, report);
  outputs.keep();
  fmt::print("{} on {}, n = {}: {} voxels, {} lights, {} transactions, {} of simulated time\n",
             options.scene, options.machine, options.n, memories.voxels.size(), lamps.list.size(),
             host.transactions(), sc_core::sc_time_stamp().to_string());
  for (const auto& [kind, path] : report.written) fmt::print("{}: {}\n", kind, path);
  return kDone;
}

}  // namespace
}  // namespace rc2

int sc_main(int argc, char** argv) {
  const auto complain = [](const char* message) {
    fmt::print(stderr, "rc2_platform: {}\n", message);
    return rc2::kBadInput;
  };
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  rc2::RunOptions options;
  auto exit_code = rc2::kDone;
  CLI::App program("RC2 behind a TLM-2.0 target in a small virtual platform: what `rc2 run` does");
  rc2::Command command(&program, &exit_code);
  rc2::declare_run_options(command, options);
  command.run([&] { return rc2::render(options); });
  try {
    program.parse(argc, argv);
    return exit_code;
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(error.what());
  } catch (const rc2::Error& error) {
    return complain(error.what());
  } catch (const std::exception& error) {
    complain(error.what());
    return rc2::kBroken;
  }
}
