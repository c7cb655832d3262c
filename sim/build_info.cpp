#include "sim/build_info.h"

#include <OpenEXR/OpenEXRConfig.h>
#include <assimp/version.h>
#include <fmt/format.h>

#include "commit.h"

namespace rc2 {

std::string source_commit() { return RC2_COMMIT; }

std::vector<std::pair<std::string, std::string>> tool_versions() {
  return {{"rc2", RC2_VERSION},
          {"compiler", RC2_COMPILER},
          {"verilator", RC2_VERILATOR},
          {"assimp",
           fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())},
          {"openexr", OPENEXR_VERSION_STRING}};
}

}  // namespace rc2
