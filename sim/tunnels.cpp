// Chapter 2: the tables of figures 2.9 and 2.11, printed and found.
#include <fmt/format.h>

#include <algorithm>

#include "sim/commands.h"
#include "sw/lines/planes.h"
#include "sw/lines/separation.h"
#include "sw/lines/windows.h"

namespace rc2 {
namespace {

using lines::Adjacency;
using lines::DigitalPlane;
using lines::Encounter;
using lines::TunnelTable;
using lines::WindowSet;

constexpr int kLargestComponent = 12;

// What the thesis answers to "can such a ray pass such a surface?"; rows are rays.
using Answers = std::vector<std::vector<bool>>;
const Answers kFigure29 = {{false, false}, {false, true}};
const Answers kFigure211 = {{false, false, false}, {false, true, true}, {false, true, true}};

const char* word(bool passes) { return passes ? "yes" : "no"; }

template <class Surface>
std::string answer(const Encounter<Surface>& met) {
  if (met.surfaces == 0) return "none exist";
  return fmt::format("{} ({} of {})", word(met.leaking > 0), met.leaking, met.surfaces);
}

// One line per kind of ray; each entry is the printed answer, if there is one, and what was found.
template <class Surface>
void print_table(const TunnelTable<Surface>& table, const std::vector<std::string>& rays,
                 const std::vector<std::string>& kinds, const Answers& printed) {
  fmt::print("{:>4}", "rays");
  for (const std::string& kind : kinds) fmt::print("{:>26}", kind);
  fmt::print("\n");
  for (std::size_t row = 0; row < rays.size(); ++row) {
    fmt::print("{:>4}", rays[row]);
    for (std::size_t column = 0; column < kinds.size(); ++column) {
      const auto& met = table[row][column];
      std::string entry = answer(met);
      if (!printed.empty()) {
        const bool wrong = met.surfaces > 0 && printed[row][column] != (met.leaking > 0);
        entry = fmt::format("{}{} {}", word(printed[row][column]), wrong ? " <>" : ",", entry);
      }
      fmt::print("{:>26}", entry);
    }
    fmt::print("\n");
  }
  fmt::print("\n");
}

// The layers of a window from its top down, with a ray that passes.
void print_window(const WindowSet& set, Adjacency rays) {
  const auto ray = lines::find_ray(set.size, rays, [&](glm::ivec3 at) { return !set.has(at); });
  for (int y = set.size.y - 1; y >= 0; --y) {
    for (int z = set.size.z - 1; z >= 0; --z) {
      fmt::print("    ");
      for (int x = 0; x < set.size.x; ++x) {
        const bool on_ray = std::find(ray.begin(), ray.end(), glm::ivec3(x, y, z)) != ray.end();
        fmt::print("{}", set.has({x, y, z}) ? '#' : (on_ray ? 'o' : '.'));
      }
    }
    fmt::print("\n");
  }
  fmt::print("\n");
}

std::string equation(const DigitalPlane& plane) {
  std::string sum;
  for (int axis = 0; axis < 3; ++axis) {
    const int factor = plane.normal[axis];
    if (factor == 0) continue;
    if (!sum.empty()) sum += " + ";
    if (factor > 1) sum += std::to_string(factor);
    sum += "xyz"[axis];
  }
  return fmt::format("0 <= {} < {}", sum, plane.thickness);
}

void print_planes() {
  const lines::PlaneSearch search = lines::search_planes(kLargestComponent);
  fmt::print(
      "Figure 2.11 on infinite planes 0 <= ax + by + cz < w, {} >= a >= b >= c >= 0, that stop\n"
      "6-connected rays (columns: the plane's connectivity)\n",
      kLargestComponent);
  print_table(search.by_connectivity, {"6", "18", "26"}, {"6", "18", "26"}, kFigure211);
  const auto& met = search.by_connectivity;
  fmt::print(
      "Smallest 6-connected planes that let a ray pass:\n"
      "    {}, an 18-connected ray\n    {}, a 26-connected ray\n\n",
      equation(*met[1][0].smallest), equation(*met[2][0].smallest));
  fmt::print(
      "Corrected: the same planes by separation, which their thickness promises (columns: from\n"
      "a on, from a+b on, from a+b+c on)\n");
  print_table(search.by_separation, {"6", "18", "26"},
              {"6-separating", "18-separating", "26-separating"}, {});
}

ExitCode print_tunnels() {
  fmt::print(
      "Can a ray pass a surface? Each entry: printed in the thesis, found, and how many surfaces\n"
      "leak; <> where the thesis is wrong. A surface is a set that stops 4- or 6-connected "
      "rays.\n\n"
      "Figure 2.9: every such set of 4 x 4 pixels (columns: its connectivity)\n");
  print_table(lines::search_window({4, 1, 4}), {"4", "8"}, {"4", "8"}, kFigure29);

  fmt::print("Figure 2.11: every such set of 2 x 2 x 3 voxels (columns: its connectivity)\n");
  print_table(lines::search_window({2, 2, 3}), {"6", "18", "26"}, {"6", "18", "26"}, kFigure211);

  const auto small = lines::search_window({2, 2, 2});
  const WindowSet& smallest = *small[1][0].smallest;
  fmt::print(
      "Smallest counter-example: {} voxels (#), 6-connected, stop 6-connected rays; an "
      "18-connected\n"
      "ray (o) passes. Layers from the top down:\n",
      smallest.count());
  print_window(smallest, Adjacency::edge);
  print_planes();
  return kDone;
}

}  // namespace

void declare_tunnels(Command& program) {
  Command command = program.command(
      "tunnels", "Searches which discrete rays pass which surfaces: thesis figures 2.9 and 2.11");
  command.run([] { return print_tunnels(); });
}

}  // namespace rc2
