#include "sw/base/replace_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "sw/base/error.h"

namespace rc2 {

void replace_file(const std::string& path, const std::string& bytes) {
  const auto fail = [&](std::error_code reason) {
    throw Error(
        fmt::format("cannot write {}: {}; choose a path in a folder that exists, may be "
                    "written to and has room",
                    path, reason.message()));
  };
  const std::string temporary = path + ".part";
  std::ofstream file(temporary, std::ios::binary);
  if (!file) fail({errno, std::generic_category()});
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();

  std::error_code reason;
  if (!file) {
    reason = {errno, std::generic_category()};
  } else {
    std::filesystem::rename(temporary, path, reason);
  }
  if (reason) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    fail(reason);
  }
}

}  // namespace rc2
