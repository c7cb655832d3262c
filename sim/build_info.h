#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rc2 {

/// The commit of the source code (sim/commit.cmake), or "unknown".
std::string source_commit();

/// Name and version of what this program was made with.
std::vector<std::pair<std::string, std::string>> tool_versions();

}  // namespace rc2
