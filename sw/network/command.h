#pragma once

#include <CLI/CLI.hpp>

namespace rc2::network {

/// Adds `network SHAPE SIZE SCHEME [--emit DIR] [--planarity]` to a program: prints the measures
/// of a network, one "name value" a line, and writes DIR/SHAPE_SCHEME.v and .json.
void add_command(CLI::App& program);

}  // namespace rc2::network
