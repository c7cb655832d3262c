#include "sim/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "sw/base/error.h"

namespace rc2 {
namespace {

namespace fs = std::filesystem;

// Permissions do not tell whether a file can be made (root, read-only disks); making one does.
std::error_code try_to_write_in(const fs::path& folder) {
  const fs::path trial = folder / ".rc2-trial.part";
  std::ofstream file(trial);
  if (!file) return {errno, std::generic_category()};
  file.close();
  std::error_code ignored;
  fs::remove(trial, ignored);
  return {};
}

}  // namespace

Outputs::~Outputs() {
  if (kept_) return;
  std::error_code ignored;
  for (const fs::path& file : streamed_) fs::remove(file, ignored);
  // A folder that is not empty holds somebody's files; remove leaves it alone.
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
}

void Outputs::add_folder(const std::string& path) {
  const auto refuse = [&](std::error_code reason) {
    throw Error(fmt::format("--out {}: cannot be written to: {}; choose another folder", path,
                            reason.message()));
  };
  std::error_code reason;
  std::vector<fs::path> missing;
  for (fs::path folder = fs::absolute(path).lexically_normal();
       !fs::exists(folder, reason) && folder.has_relative_path(); folder = folder.parent_path()) {
    missing.push_back(folder);
  }
  for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) {
    if (fs::create_directory(*folder, reason)) made_.push_back(*folder);
    if (reason) refuse(reason);
  }
  reason = try_to_write_in(path);
  if (reason) refuse(reason);
}

void Outputs::add_file(const std::string& path) {
  const fs::path folder = fs::absolute(path).parent_path();
  std::error_code reason;
  if (fs::is_directory(path, reason)) {
    reason = std::make_error_code(std::errc::is_a_directory);
  } else {
    reason = try_to_write_in(folder);
  }
  if (reason) {
    throw Error(fmt::format("{}: cannot be written: {}; choose a path in a folder that exists",
                            path, reason.message()));
  }
}

void Outputs::add_waves(const std::string& path) {
  add_file(path);
  std::error_code ignored;
  for (const fs::path& file : {fs::path(path), fs::path(path).replace_extension(".gtkw")}) {
    fs::remove(file, ignored);
    streamed_.push_back(file);
  }
}

}  // namespace rc2
