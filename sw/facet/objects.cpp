#include "sw/facet/objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "sw/facet/above.h"
#include "sw/facet/box_tree.h"

namespace rc2::facet {
namespace {

struct Shell {
  const Pieces* pieces;
  Vertex least;
  Box box;
  double volume;  // sixfold, negative if it faces inwards; rounded, for comparison only
};

Shell measure(const Traced& traced, const Pieces& pieces) {
  const Vertex& any = traced.pieces[pieces.front()].border.front();
  Shell shell{&pieces, any, {any, any}, 0};
  __extension__ __int128 volume = 0;
  for (const std::uint32_t piece : pieces) {
    const Border& border = traced.pieces[piece].border;
    volume += dot(border.front() - any, doubled_area(border));
    for (const Vertex& v : border) {
      shell.box = {glm::min(shell.box.first, v), glm::max(shell.box.second, v)};
      if (std::array{v.x, v.y, v.z} < std::array{shell.least.x, shell.least.y, shell.least.z})
        shell.least = v;
    }
  }
  shell.volume = static_cast<double>(volume);
  return shell;
}

bool holds(const Box& outer, const Box& inner) {
  return glm::min(outer.first, inner.first) == outer.first &&
         glm::max(outer.second, inner.second) == outer.second;
}

bool encloses(const Traced& traced, const Pieces& shell, const Vertex& point) {
  bool odd = false;
  for (const std::uint32_t i : shell)
    odd ^= is_over(traced.pieces[i].border, traced.pieces[i].normal, point);
  return odd;
}

// Goes through the shells from the largest to the smallest, so that each comes after what it is
// in, and pairs them like brackets.
class Nesting {
 public:
  Nesting(const Traced& traced, const std::vector<Pieces>& shells)
      : traced_(traced),
        shells_(measure_all(traced, shells)),
        boxes_(boxes_of(shells_)),
        opener_(shells_.size()),
        is_outermost_(shells_.size()),
        is_room_(shells_.size()) {
    for (std::uint32_t i = 0; i < shells_.size(); ++i) place(i);
  }

  Objects objects() const {
    Objects objects;
    std::vector<std::uint32_t> solid(shells_.size());
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      if (is_room_[i]) {
        ++objects.rooms;
        continue;
      }
      if (opener_[i] == i) {
        solid[i] = static_cast<std::uint32_t>(objects.solids.size());
        objects.solids.emplace_back();
      }
      Pieces& pieces = objects.solids[solid[opener_[i]]];
      pieces.insert(pieces.end(), shells_[i].pieces->begin(), shells_[i].pieces->end());
    }
    return objects;
  }

 private:
  static std::vector<Shell> measure_all(const Traced& traced, const std::vector<Pieces>& shells) {
    std::vector<Shell> result;
    result.reserve(shells.size());
    for (const Pieces& pieces : shells) result.push_back(measure(traced, pieces));
    std::stable_sort(result.begin(), result.end(), [](const Shell& a, const Shell& b) {
      return std::abs(a.volume) > std::abs(b.volume);
    });
    return result;
  }

  static std::vector<Box> boxes_of(const std::vector<Shell>& shells) {
    std::vector<Box> boxes;
    boxes.reserve(shells.size());
    for (const Shell& shell : shells) boxes.push_back(shell.box);
    return boxes;
  }

  void place(std::uint32_t i) {
    const std::vector<std::uint32_t> outers = around(i);
    std::vector<std::uint32_t> unpaired;
    for (const std::uint32_t outer : outers) {
      const auto pair = std::find(unpaired.begin(), unpaired.end(), opener_[outer]);
      if (opener_[outer] == outer)
        unpaired.push_back(outer);
      else if (pair != unpaired.end())
        unpaired.erase(pair);
    }
    is_outermost_[i] = outers.empty();
    opener_[i] = i;
    if (unpaired.empty() || shells_[unpaired.back()].volume * shells_[i].volume >= 0) return;
    if (is_outermost_[unpaired.back()] && shells_[i].volume > 0)
      is_room_[unpaired.back()] = true;
    else
      opener_[i] = unpaired.back();
  }

  // Larger shells that have this one in them, from the outermost to the innermost.
  std::vector<std::uint32_t> around(std::uint32_t i) const {
    const Shell& shell = shells_[i];
    std::vector<std::uint32_t> result;
    boxes_.query({shell.least, shell.least}, [&](std::uint32_t outer) {
      if (outer < i && holds(shells_[outer].box, shell.box) &&
          encloses(traced_, *shells_[outer].pieces, shell.least))
        result.push_back(outer);
    });
    std::sort(result.begin(), result.end());
    return result;
  }

  const Traced& traced_;
  std::vector<Shell> shells_;
  BoxTree boxes_;
  std::vector<std::uint32_t> opener_;  // the shell whose cavity this one is, or this one
  std::vector<bool> is_outermost_, is_room_;
};

}  // namespace

Objects find_objects(const Traced& traced, const std::vector<Pieces>& closed) {
  return Nesting(traced, closed).objects();
}

}  // namespace rc2::facet
