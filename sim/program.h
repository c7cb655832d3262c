// The host program as a function.
#pragma once

#include "sim/commands.h"

namespace rc2 {

/// Declares all commands and the options of the program itself; what a command returns goes to
/// `exit_code`.
void declare_all(CLI::App& app, ExitCode& exit_code);

/// Does what the command line says. What the user can mend and what is broken it says in one line
/// on stderr.
ExitCode run_program(int argc, const char* const* argv);

}  // namespace rc2
