// rc2: the host of an RC2 machine, in silicon to be or in software.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>

#include "sim/commands.h"
#include "sw/base/error.h"

namespace {

// One line, whatever a library put into its message.
void complain(std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  fmt::print(stderr, "rc2: {}\n", message);
}

rc2::ExitCode run_program(int argc, char** argv) {
  auto exit_code = rc2::kDone;
  CLI::App program("RC2, a ray-tracing cellular machine: loads scenes into it and lights them.",
                   "rc2");
  program.set_version_flag("--version", RC2_VERSION);
  program.require_subcommand(0, 1);
  rc2::declare_run(program, exit_code);
  rc2::declare_voxelize(program, exit_code);
  rc2::declare_compare(program, exit_code);
  rc2::declare_lines(program, exit_code);
  rc2::declare_tunnels(program, exit_code);
  rc2::declare_leaks(program, exit_code);
  rc2::declare_rounding(program, exit_code);
  rc2::declare_loading(program, exit_code);
  rc2::declare_load_speed(program, exit_code);
  rc2::declare_walk(program, exit_code);
  rc2::declare_diffusion(program, exit_code);
  rc2::declare_queues(program, exit_code);
  rc2::declare_light_error(program, exit_code);
  rc2::declare_measure(program, exit_code);
  rc2::declare_peers(program, exit_code);
  rc2::declare_render(program, exit_code);
  rc2::declare_render_error(program, exit_code);
  rc2::declare_ray_traffic(program, exit_code);
  rc2::declare_network(program, exit_code);
  rc2::declare_thesis(program, exit_code);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    program.exit(help_or_version);
    return rc2::kDone;
  } catch (const CLI::ParseError& error) {
    std::string command = "rc2";
    for (const CLI::App* chosen : program.get_subcommands()) command += ' ' + chosen->get_name();
    throw rc2::Error(fmt::format("{}; see {} --help", error.what(), command));
  }
  if (program.get_subcommands().empty()) {
    throw rc2::Error("there is nothing to do; name a command, rc2 --help lists them");
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const rc2::Error& error) {
    complain(error.what());
    return rc2::kBadInput;
  } catch (const std::bad_alloc&) {
    complain("there is not enough memory; use smaller files or close other programs");
    return rc2::kBadInput;
  } catch (const std::exception& error) {
    complain(fmt::format("internal error: {}", error.what()));
    return rc2::kBroken;
  }
}
