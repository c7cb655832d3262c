// Chapter 2: the line algorithms side by side.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <glm/geometric.hpp>
#include <memory>
#include <random>

#include "sim/commands.h"
#include "sim/line_picture.h"
#include "sim/outputs.h"
#include "sw/base/config.h"
#include "sw/lines/algorithms.h"
#include "sw/lines/connectivity.h"
#include "sw/picture/png.h"

namespace rc2 {
namespace {

using lines::Algorithm;
using Voxels = std::vector<glm::ivec3>;

struct LineOptions {
  std::vector<int> from = {0, 0, 0};
  std::vector<int> to = {24, 6, 11};
  std::string out;
  bool bench = false;
};

// Voxels per second into a vector, over segments between random voxels of the largest cube.
double measure_speed(const Algorithm& algorithm) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> within(0, kMaxSide - 1);
  std::vector<std::pair<glm::ivec3, glm::ivec3>> segments(1000);
  for (auto& [from, to] : segments)
    for (glm::ivec3* end : {&from, &to}) *end = {within(random), within(random), within(random)};

  constexpr std::clock_t kLong = CLOCKS_PER_SEC / 2;
  Voxels voxels;
  std::size_t count = 0;
  const std::clock_t start = std::clock();  // of the processor: others may be at work
  std::clock_t spent = 0;
  while (spent < kLong) {
    for (const auto& [from, to] : segments) {
      voxels.clear();
      algorithm.draw(from, to, voxels);
      count += voxels.size();
    }
    spent = std::clock() - start;
  }
  return static_cast<double>(count) * CLOCKS_PER_SEC / static_cast<double>(spent);
}

// The largest distance of a voxel's centre from the segment's line.
double reach(glm::dvec3 from, glm::dvec3 to, const Voxels& voxels) {
  if (from == to) return 0;
  const glm::dvec3 along = glm::normalize(to - from);
  double largest = 0;
  for (const glm::dvec3 at : voxels)
    largest = std::max(largest, glm::length(glm::cross(along, at - from)));
  return largest;
}

ExitCode draw_segment(const LineOptions& options) {
  Outputs outputs;
  if (!options.out.empty()) outputs.add_file(options.out);
  const glm::ivec3 from(options.from[0], options.from[1], options.from[2]);
  const glm::ivec3 to(options.to[0], options.to[1], options.to[2]);
  fmt::print("segment ({},{},{}) - ({},{},{})\n\n", from.x, from.y, from.z, to.x, to.y, to.z);
  fmt::print("{:<15} {:>6} {:>8} {:>13} {:>14} {:>12}", "algorithm", "thesis", "voxels",
             "connectivity", "not bresenham", "off by");
  fmt::print(options.bench ? " {:>12}\n" : "\n", "voxels/s");

  std::vector<Voxels> drawings;
  for (const Algorithm& algorithm : lines::kAlgorithms) {
    Voxels& voxels = drawings.emplace_back();
    algorithm.draw(from, to, voxels);
    const lines::VoxelSet set(voxels.begin(), voxels.end());
    const lines::VoxelSet first(drawings.front().begin(), drawings.front().end());
    const auto others =
        std::count_if(set.begin(), set.end(), [&](const auto& at) { return first.count(at) == 0; });
    const auto connected = lines::connectivity(set);
    fmt::print("{:<15} {:>6} {:>8} {:>13} {:>14} {:>12.3f}", algorithm.name, algorithm.section,
               voxels.size(), connected ? std::to_string(static_cast<int>(*connected)) : "none",
               others, reach(from, to, voxels));
    if (options.bench) fmt::print(" {:>10.0f} M", measure_speed(algorithm) / 1e6);
    fmt::print("\n");
  }
  fmt::print("\noff by: largest distance of a voxel's centre from the segment, in voxels\n");
  if (options.bench)
    fmt::print("voxels/s: millions, over segments between random voxels of a cube of side {}\n",
               kMaxSide);
  if (!options.out.empty()) {
    picture::write_png(options.out, draw_lines(from, to, drawings));
    fmt::print("{}: the algorithms in this order; orange: not a voxel of the first\n", options.out);
  }
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_lines(Command& program) {
  auto options = std::make_shared<LineOptions>();
  Command command = program.command(
      "lines", "Draws a segment by each algorithm of thesis chapter 2 and compares their voxels");
  command.option("--from", options->from, "First voxel, x,y,z").list_of(3).within(0, kMaxSide - 1);
  command.option("--to", options->to, "Last voxel, x,y,z").list_of(3).within(0, kMaxSide - 1);
  command.flag("--bench", options->bench, "Also measure speed, a few seconds");
  command.option("--out", options->out, "A PNG of the segment drawn by each algorithm");
  command.run([options] { return draw_segment(*options); });
}

}  // namespace rc2
