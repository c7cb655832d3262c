#include "sw/report/dump.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <limits>
#include <string_view>
#include <system_error>
#include <tuple>

namespace rc2::report {
namespace {

constexpr std::size_t kVoxelColumns = 6;
constexpr const char* kMend = "write it with rc2 run --dump or rc2 voxelize --dump";

std::string header(std::size_t lights) {
  std::string line = "x,y,z,facet,core,gap";
  for (std::size_t k = 0; k < lights; ++k) line += fmt::format(",light{}", k);
  return line;
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!file_) refuse_file(errno);
  }

  Memories read() {
    if (!next_line()) refuse("there is no header");
    const auto commas = static_cast<std::size_t>(std::count(line_.begin(), line_.end(), ','));
    const std::size_t lights = commas + 1 < kVoxelColumns ? 0 : commas + 1 - kVoxelColumns;
    if (line_ != header(lights)) refuse("the header is not x,y,z,facet,core,gap,light0,light1,...");
    memories_.lights.resize(lights);
    while (next_line()) add_row();
    if (file_.bad()) refuse_file(errno);
    return std::move(memories_);
  }

 private:
  [[noreturn]] void refuse_file(int reason) const {
    throw Error(fmt::format("{}: cannot be read: {}; name a file that rc2 run --dump wrote", path_,
                            std::generic_category().message(reason)));
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(fmt::format("{}: line {}: {}; {}", path_, number_, what, kMend));
  }

  bool next_line() {
    ++number_;
    return static_cast<bool>(std::getline(file_, line_));
  }

  void add_row() {
    rest_ = line_;
    words_left_ = kVoxelColumns + memories_.lights.size();
    constexpr auto kAny = std::numeric_limits<std::uint32_t>::max();
    VoxelRecord voxel{};
    for (int axis = 0; axis < 3; ++axis) voxel.at[axis] = static_cast<int>(take(0, kMaxSide - 1));
    voxel.owner.facet = static_cast<std::uint32_t>(take(0, kMaxFacets - 1));
    voxel.owner.core = take(0, 1) != 0;
    constexpr int kGapEnd = 1 << (kGapBits - 1);
    voxel.owner.gap = static_cast<int>(take(-kGapEnd, kGapEnd - 1));
    for (LightMemory& light : memories_.lights)
      light.push_back(static_cast<std::uint32_t>(take(0, kAny)));
    if (!memories_.voxels.empty()) {
      const glm::ivec3 before = memories_.voxels.back().at, at = voxel.at;
      if (std::tie(before.z, before.y, before.x) >= std::tie(at.z, at.y, at.x)) {
        refuse("the voxel is not after the one before it in the order of z, y, x");
      }
    }
    memories_.voxels.push_back(voxel);
  }

  std::int64_t take(std::int64_t lowest, std::int64_t highest) {
    const auto comma = rest_.find(',');
    --words_left_;
    if ((comma == std::string_view::npos) != (words_left_ == 0)) {
      refuse(fmt::format("the row has {} words where the header has {}",
                         std::count(line_.begin(), line_.end(), ',') + 1,
                         kVoxelColumns + memories_.lights.size()));
    }
    const std::string_view word = rest_.substr(0, comma);
    rest_.remove_prefix(comma == std::string_view::npos ? rest_.size() : comma + 1);
    std::int64_t value = 0;
    const auto [stop, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || stop != word.data() + word.size() || value < lowest ||
        value > highest) {
      refuse(fmt::format("'{}' is not a whole number from {} to {}", word, lowest, highest));
    }
    return value;
  }

  std::string path_;
  std::ifstream file_;
  std::string line_;
  std::int64_t number_ = 0;
  std::string_view rest_;
  std::size_t words_left_ = 0;
  Memories memories_;
};

}  // namespace

std::string to_csv(const Memories& memories) {
  std::string csv = header(memories.lights.size()) + '\n';
  const auto end = std::back_inserter(csv);
  for (std::size_t i = 0; i < memories.voxels.size(); ++i) {
    const VoxelRecord& voxel = memories.voxels[i];
    fmt::format_to(end, "{},{},{},{},{},{}", voxel.at.x, voxel.at.y, voxel.at.z, voxel.owner.facet,
                   voxel.owner.core ? 1 : 0, voxel.owner.gap);
    for (const LightMemory& light : memories.lights) fmt::format_to(end, ",{}", light[i]);
    csv += '\n';
  }
  return csv;
}

Memories read_csv(const std::string& path) { return Reader(path).read(); }

}  // namespace rc2::report
