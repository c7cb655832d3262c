#pragma once

#include <CLI/CLI.hpp>

namespace rc2 {

/// What the program returns to the shell.
enum ExitCode {
  kDone = 0,
  kDifferent = 1,     ///< compare: the files differ
  kBadInput = 2,      ///< the user can mend it
  kDisagreement = 3,  ///< the machine and what it is compared with differ
  kBroken = 4,        ///< a law that holds for every machine is broken
};

/// Each declares one command, which sets `exit_code` when it has run. Errors are thrown.
void declare_run(CLI::App& program, ExitCode& exit_code);
void declare_voxelize(CLI::App& program, ExitCode& exit_code);
void declare_compare(CLI::App& program, ExitCode& exit_code);
void declare_lines(CLI::App& program, ExitCode& exit_code);
void declare_tunnels(CLI::App& program, ExitCode& exit_code);
void declare_leaks(CLI::App& program, ExitCode& exit_code);
void declare_rounding(CLI::App& program, ExitCode& exit_code);
void declare_loading(CLI::App& program, ExitCode& exit_code);
void declare_load_speed(CLI::App& program, ExitCode& exit_code);
void declare_emission(CLI::App& program, ExitCode& exit_code);
void declare_virtual_image(CLI::App& program, ExitCode& exit_code);
void declare_walk(CLI::App& program, ExitCode& exit_code);
void declare_diffusion(CLI::App& program, ExitCode& exit_code);
void declare_difference(CLI::App& program, ExitCode& exit_code);
void declare_queues(CLI::App& program, ExitCode& exit_code);
void declare_light_error(CLI::App& program, ExitCode& exit_code);
void declare_measure(CLI::App& program, ExitCode& exit_code);
void declare_peers(CLI::App& program, ExitCode& exit_code);
void declare_choices(CLI::App& program, ExitCode& exit_code);
void declare_path_table(CLI::App& program, ExitCode& exit_code);
void declare_ray_traffic(CLI::App& program, ExitCode& exit_code);
void declare_render(CLI::App& program, ExitCode& exit_code);
void declare_render_error(CLI::App& program, ExitCode& exit_code);
void declare_network(CLI::App& program, ExitCode& exit_code);
void declare_thesis(CLI::App& program, ExitCode& exit_code);

}  // namespace rc2
