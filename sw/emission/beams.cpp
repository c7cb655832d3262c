#include "sw/emission/beams.h"

#include <array>
#include <vector>

#include "sw/thesis/split.h"

namespace rc2::emission {
namespace {

using thesis::Beam;
using thesis::Interval;

// The beam comes to the voxel `at`; split(beam, at) gives its children and where they go.
template <typename AnyBeam, typename Split>
void spread(Ledger& ledger, const glm::ivec3& at, const AnyBeam& beam, const Split& split) {
  for (const auto& child : split(beam, at)) {
    const glm::ivec3 next = at + child.step;
    if (!ledger.contains(next)) continue;
    ledger.move(at, next);
    if (ledger.is_free(next))
      spread(ledger, next, child.beam, split);
    else
      ledger.light(next);
  }
}

// Each target on an edge of two faces belongs to one of them only.
std::vector<Beam> six_cones(int distance) {
  const Interval all{-distance, distance}, inner{1 - distance, distance - 1};
  std::vector<Beam> cones;
  for (const int side : {-1, 1}) {
    cones.push_back({0, side, all, all});
    cones.push_back({1, side, inner, all});
    cones.push_back({2, side, inner, inner});
  }
  return cones;
}

// What a beam of 4.3.2 carries.
struct PathBeam {
  int axis, side;
  std::array<const PathTable*, 2> tables;  // of u, v: which targets the face has
  std::array<Path, 2> paths;
};

struct PathChild {
  glm::ivec3 step;
  PathBeam beam;
};

class TableSplitter {
 public:
  explicit TableSplitter(std::int64_t& looks) : looks_(looks) {}

  std::vector<PathChild> operator()(const PathBeam& beam, const glm::ivec3& /*at*/) const {
    const auto axes = thesis::target_axes(beam.axis);
    const std::vector<int> v_steps = steps(*beam.tables[1], beam.paths[1]);
    std::vector<PathChild> children;
    for (const int u : steps(*beam.tables[0], beam.paths[0])) {
      for (const int v : v_steps) {
        PathChild child{glm::ivec3(0), beam};
        child.step[beam.axis] = beam.side;
        child.step[axes[0]] = u;
        child.step[axes[1]] = v;
        child.beam.paths[0] += letter_of(u);
        child.beam.paths[1] += letter_of(v);
        children.push_back(child);
      }
    }
    return children;
  }

 private:
  std::vector<int> steps(const PathTable& table, const Path& path) const {
    std::vector<int> found;
    for (const int step : {-1, 0, 1})
      if (table.has(path + letter_of(step), looks_)) found.push_back(step);
    return found;
  }

  std::int64_t& looks_;
};

}  // namespace

void send_beams(Ledger& ledger, const glm::ivec3& source) {
  const int distance = ledger.n() - 1;
  const thesis::Partition partition(ledger.n(), distance);
  for (const Beam& cone : six_cones(distance)) {
    ledger.send(1);
    spread(ledger, source, cone, [&](const Beam& beam, const glm::ivec3& at) {
      return partition.split(beam, at - source);
    });
  }
}

std::int64_t send_beams_by_table(Ledger& ledger, const glm::ivec3& source) {
  const int distance = ledger.n() - 1;
  const PathTable all(-distance, distance, distance), inner(1 - distance, distance - 1, distance);
  const auto table = [&](const Interval& targets) {
    return targets.last == distance ? &all : &inner;
  };
  std::int64_t looks = 0;
  const TableSplitter splitter(looks);
  for (const Beam& cone : six_cones(distance)) {
    ledger.send(1);
    spread(ledger, source, PathBeam{cone.axis, cone.side, {table(cone.u), table(cone.v)}, {}},
           splitter);
  }
  return looks;
}

}  // namespace rc2::emission
