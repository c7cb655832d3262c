#include "sim/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <new>

#include "sw/base/error.h"

namespace rc2 {
namespace {

// One line, whatever a library put into its message.
void complain(std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  fmt::print(stderr, "rc2: {}\n", message);
}

ExitCode parse_and_run(int argc, const char* const* argv) {
  auto exit_code = kDone;
  CLI::App program("RC2, a ray-tracing cellular machine: loads scenes into it and lights them.",
                   "rc2");
  declare_all(program, exit_code);
  // CLI11 2.1 goes round for ever on an empty word before an option.
  for (int i = 1; i < argc; ++i) {
    if (*argv[i] != '\0') continue;
    const std::string before = argv[i - 1];
    throw Error(fmt::format("{}word {} of the command line is empty; fill it or leave it out",
                            before.rfind("--", 0) == 0 ? before + ": " : "", i));
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    program.exit(help_or_version);
    return kDone;
  } catch (const CLI::ParseError& error) {
    std::string command = "rc2";
    for (const CLI::App* chosen : program.get_subcommands()) command += ' ' + chosen->get_name();
    throw Error(fmt::format("{}; see {} --help", error.what(), command));
  }
  if (program.get_subcommands().empty()) {
    throw Error("there is nothing to do; name a command, rc2 --help lists them");
  }
  return exit_code;
}

}  // namespace

void declare_all(CLI::App& app, ExitCode& exit_code) {
  app.set_version_flag("--version", RC2_VERSION);
  app.require_subcommand(0, 1);
  Command program(&app, &exit_code);
  declare_run(program);
  declare_voxelize(program);
  declare_compare(program);
  declare_lines(program);
  declare_tunnels(program);
  declare_leaks(program);
  declare_rounding(program);
  declare_loading(program);
  declare_load_speed(program);
  declare_virtual_image(program);
  declare_walk(program);
  declare_emission(program);
  declare_diffusion(program);
  declare_difference(program);
  declare_queues(program);
  declare_light_error(program);
  declare_measure(program);
  declare_peers(program);
  declare_render(program);
  declare_render_error(program);
  declare_choices(program);
  declare_path_table(program);
  declare_ray_traffic(program);
  declare_network(program);
  declare_thesis(program);
}

ExitCode run_program(int argc, const char* const* argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const Error& error) {
    complain(error.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    complain("there is not enough memory; use smaller files or close other programs");
    return kBadInput;
  } catch (const std::exception& error) {
    complain(fmt::format("internal error: {}", error.what()));
    return kBroken;
  }
}

}  // namespace rc2
