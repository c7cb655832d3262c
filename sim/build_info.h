#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rc2 {

/// The state of the source code: git describe of the last configuration, or "unknown".
std::string source_commit();

/// Name and version of what this program was made with.
std::vector<std::pair<std::string, std::string>> tool_versions();

}  // namespace rc2
