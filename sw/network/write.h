// A network as files: hardware, and a description for other programs.
#pragma once

#include <string>

#include "sw/network/network.h"

namespace rc2::network {

/// The bit of a network's output that shows a pixel of the first octant.
constexpr int output_bit(glm::ivec2 pixel) { return pixel.x * (pixel.x + 1) / 2 + pixel.y; }

/// Synthesizable Verilog-2001: a module of the given name with inputs start[size:0], one a drawing,
/// and outputs lit[], one a pixel of the octant at its output_bit. Pixels without a cell stay dark.
std::string verilog(const Network& network, const std::string& module);

/// JSON: {"size", "cells": [[x, y], ...], "starts": [cell, ...], "links": [[from, to], ...]}.
std::string description(const Network& network);

}  // namespace rc2::network
