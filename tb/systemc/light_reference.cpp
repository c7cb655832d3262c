#include "tb/systemc/light_reference.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <utility>

#include "sw/lines/digital_line.h"

namespace rc2::tb {
namespace {

int axis_of(int dir) { return dir / 2; }
int sign_of(int dir) { return dir % 2 == 0 ? 1 : -1; }
int u_axis(int dir) { return axis_of(dir) == 0 ? 1 : 0; }
int v_axis(int dir) { return axis_of(dir) == 2 ? 1 : 2; }

std::size_t link_towards(glm::ivec2 step) {
  constexpr std::array<std::array<int, 2>, kLinks> kSteps{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  for (std::size_t link = 0; link < kLinks; ++link) {
    if (kSteps[link][0] == step.x && kSteps[link][1] == step.y) return link;
  }
  throw std::logic_error("a beam goes to a cell that is no neighbour");
}

// The targets of a beam that go the same way.
struct Group {
  LinkBeam beam;
  std::int64_t count;
};

void add(Group& group, int u, int v) {
  group.beam.u_min = std::min(group.beam.u_min, u);
  group.beam.u_max = std::max(group.beam.u_max, u);
  group.beam.v_min = std::min(group.beam.v_min, v);
  group.beam.v_max = std::max(group.beam.v_max, v);
  ++group.count;
}

}  // namespace

LightReference::LightReference(glm::ivec2 cell, std::vector<bool> occupied, const LightJob& light)
    : cell_(cell), occupied_(std::move(occupied)), light_(light) {}

LightReference::Place LightReference::place(int dir, int z) const {
  const glm::ivec3 away = glm::ivec3(cell_, z) - light_.source;
  return {std::abs(away[axis_of(dir)]), away[u_axis(dir)], away[v_axis(dir)]};
}

int LightReference::offset(int target, int step) const {
  lines::DigitalLine line(target, light_.target_distance);
  int at = 0;
  for (int k = 0; k < step; ++k) at += line.advance();
  return at;
}

// A target on an edge shared by two faces belongs to one of them: x faces keep all their edges, y
// faces those with z, z faces none (thesis 4.1.4).
LinkBeam LightReference::face(int dir) const {
  const int full = light_.target_distance;
  const int u = axis_of(dir) == 0 ? full : full - 1, v = axis_of(dir) == 2 ? full - 1 : full;
  return {dir, light_.source.z, -u, u, -v, v};
}

LinkBeam LightReference::passing(int dir, int z) const {
  const Place at = place(dir, z);
  const LinkBeam whole = face(dir);
  LinkBeam beam{dir, z, 1, 0, 1, 0};
  const glm::ivec3 away = glm::ivec3(cell_, z) - light_.source;
  if (away[axis_of(dir)] * sign_of(dir) < 0) return beam;
  const auto narrow = [&](int wanted, int first, int last, int& min, int& max) {
    min = last + 1;
    max = first - 1;
    for (int target = first; target <= last; ++target) {
      if (offset(target, at.step) != wanted) continue;
      min = std::min(min, target);
      max = std::max(max, target);
    }
  };
  narrow(at.u, whole.u_min, whole.u_max, beam.u_min, beam.u_max);
  narrow(at.v, whole.v_min, whole.v_max, beam.v_min, beam.v_max);
  return beam;
}

void LightReference::start(CellLight& result) const {
  if (cell_ != glm::ivec2(light_.source)) return;
  for (int dir = 0; dir < 6; ++dir) serve(face(dir), result);
}

void LightReference::serve(const LinkBeam& beam, CellLight& result) const {
  ++result.visits;
  if (occupied_[static_cast<std::size_t>(beam.z)]) {
    result.absorbed[beam.z] += beam.targets();
    result.home.push_back(beam.targets());
    return;
  }
  // Where each target's ray goes next: groups by the step along V, then along U.
  const Place at = place(beam.dir, beam.z);
  std::map<std::pair<int, int>, Group> groups;
  for (int v = beam.v_min; v <= beam.v_max; ++v) {
    const int v_step = offset(v, at.step + 1) - at.v;
    for (int u = beam.u_min; u <= beam.u_max; ++u) {
      const int u_step = offset(u, at.step + 1) - at.u;
      const auto group = groups.try_emplace({v_step, u_step}, Group{{beam.dir, 0, u, u, v, v}, 0});
      add(group.first->second, u, v);
    }
  }
  // A side beam serves one step along V after the other, a z beam all at once.
  std::map<int, std::int64_t> escaped;
  std::optional<LinkBeam> own;
  const int n = static_cast<int>(occupied_.size());
  for (const auto& [steps, group] : groups) {
    glm::ivec3 next(cell_, beam.z);
    next[axis_of(beam.dir)] += sign_of(beam.dir);
    next[v_axis(beam.dir)] += steps.first;
    next[u_axis(beam.dir)] += steps.second;
    LinkBeam child = group.beam;
    child.z = next.z;
    if (child.targets() != group.count) throw std::logic_error("a child is no rectangle");
    const int part = axis_of(beam.dir) == 2 ? 0 : steps.first;
    if (next.x < 0 || next.y < 0 || next.z < 0 || next.x >= n || next.y >= n || next.z >= n) {
      escaped[part] += group.count;
    } else if (glm::ivec2(next) == cell_) {
      own = child;
    } else {
      result.sent.push_back({link_towards(glm::ivec2(next) - cell_), child});
    }
  }
  for (const auto& [part, targets] : escaped) result.home.push_back(targets);
  if (own) serve(*own, result);
}

}  // namespace rc2::tb
