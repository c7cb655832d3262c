#include "sw/scene/check_header.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "fmt/format.h"
#include "sw/base/error.h"

namespace rc2::scene {
namespace {

constexpr int kMaxHeaderLines = 1000;

// Counts are floating point: a number of any length can be compared, none wraps around.
using Counts = std::vector<double>;

Counts ply_counts(std::ifstream& file, const std::string& path) {
  Counts counts;
  std::string line;
  for (int i = 0; i < kMaxHeaderLines && std::getline(file, line); ++i) {
    std::istringstream words(line);
    std::string word, name;
    double count = 0;
    words >> word >> name >> count;
    if (word == "end_header" && name.empty()) return counts;
    if (word == "element" && words) counts.push_back(count);
  }
  throw Error(
      fmt::format("{}: the header of the file does not end; the file is damaged, export "
                  "it again",
                  path));
}

// The counts stand behind the magic word or on the first line that is not a comment.
Counts off_counts(std::ifstream& file, std::string line) {
  line.erase(0, line.find("OFF") + 3);
  for (int i = 0; i < kMaxHeaderLines; ++i) {
    std::istringstream words(line.substr(0, line.find('#')));
    double vertices = 0, faces = 0;
    if (words >> vertices >> faces) return {vertices, faces};
    if (!std::getline(file, line)) break;
  }
  return {};
}

}  // namespace

void check_header(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  if (!file || unknown) return;
  std::string line, magic;
  std::getline(file, line);
  std::istringstream(line) >> magic;
  Counts counts;
  if (magic == "ply" && line.find('\r') >= line.size() - 1)  // not one long line
    counts = ply_counts(file, path);
  else if (magic.size() >= 3 && magic.compare(magic.size() - 3, 3, "OFF") == 0)
    counts = off_counts(file, line);
  for (const double count : counts)
    if (count < 0 || count > static_cast<double>(bytes))
      throw Error(
          fmt::format("{}: the header announces {:.0f} elements but the file has only {} "
                      "bytes; the file is damaged, export it again",
                      path, count, bytes));
}

}  // namespace rc2::scene
