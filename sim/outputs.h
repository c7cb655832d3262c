// The places that a run writes to, tried before the long work and tidied up if it fails.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rc2 {

class Outputs {
 public:
  Outputs() = default;
  /// Removes what this run has made, unless keep() was called.
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Makes the folder and those above it. Throws Error if it cannot be made or written to.
  void add_folder(const std::string& path);

  /// Throws Error if no file of this name could be written.
  void add_file(const std::string& path);

  /// Like add_file, for a file that is written bit by bit: an older one is removed now, a part of
  /// a new one at the end, together with its list of signals.
  void add_waves(const std::string& path);

  void keep() { kept_ = true; }

 private:
  std::vector<std::filesystem::path> made_;  ///< folders, a parent before its children
  std::vector<std::filesystem::path> streamed_;
  bool kept_ = false;
};

}  // namespace rc2
