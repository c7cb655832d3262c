#include "sw/cycle/z_lanes.h"

#include <algorithm>
#include <glm/common.hpp>

#include "sw/cycle/cell.h"

namespace rc2::cycle {
ZLanes::ZLanes(int n, Columns& columns) : n_(n), columns_(columns) {}

ClassSet* ZLanes::rows(std::vector<ClassSet>& front, int x, int y) const {
  return front.data() + cell_number(x, y, n_) * height_;
}

void ZLanes::run(const LightJob& light, const Classes& classes,
                 const std::vector<Outlook>& outlooks) {
  light_ = light;
  classes_ = &classes;
  height_ = static_cast<std::size_t>(classes.most());
  now_.assign(columns_.size() * height_, 0);
  next_.assign(columns_.size() * height_, 0);
  outlooks_ = &outlooks;
  tally_ = {};
  last_busy_ = absorbed_ = escaped_ = skipped_ = visits_ = 0;
  run_lane(false);
  run_lane(true);
}

void ZLanes::run_lane(bool down) {
  const int last = down ? light_.source.z : n_ - 1 - light_.source.z;
  Box box{light_.source.x, light_.source.x, light_.source.y, light_.source.y};
  *rows(now_, box.x0, box.y0) = 1;
  for (int step = 0; step <= last; ++step) {
    const std::int64_t cycle = 2 * step + (down ? 2 : 1);
    enter(box, step, light_.source.z + (down ? -step : step), cycle);
    leave(box, step, step == last, cycle);
    if (step == last) break;
    const Box wider{std::max(box.x0 - 1, 0), std::min(box.x1 + 1, n_ - 1), std::max(box.y0 - 1, 0),
                    std::min(box.y1 + 1, n_ - 1)};
    advance(box, wider, step);
    std::swap(now_, next_);
    box = wider;
  }
}

// Lights what is occupied in this layer; what meets a stop is absorbed, what has nothing more to
// meet is skipped.
void ZLanes::enter(const Box& box, int step, int z, std::int64_t cycle) {
  for (int y = box.y0; y <= box.y1; ++y) {
    for (int x = box.x0; x <= box.x1; ++x) {
      ClassSet* const matrix = rows(now_, x, y);
      const int dx = x - light_.source.x, dy = y - light_.source.y;
      const std::size_t count = classes_->cut(step, dx).count;
      ClassSet any = 0;
      for (std::size_t i = 0; i < count; ++i) any |= matrix[i];
      if (any == 0) continue;
      last_busy_ = std::max(last_busy_, cycle);
      const auto column = cell_number(x, y, n_);
      const Extent& beyond = (*outlooks_)[column].in(cycle - 1);
      const bool worth = beyond.min <= z && z <= beyond.max;
      if (worth && step > 0) ++visits_;
      const bool lights = worth && columns_.occupied(column, z);
      const bool stops = !worth || columns_.stops(column, z);
      if (!lights && !stops) continue;
      const std::int64_t arrived = targets(step, dx, dy, matrix);
      if (lights) columns_.light(column, z, arrived);
      if (!stops) continue;
      (worth ? absorbed_ : skipped_) += arrived;
      tally_.finish(cycle, x, y, arrived);
      std::fill_n(matrix, count, 0);
    }
  }
}

// Counts what leaves the cube in the step after this one: all of it, or what goes beyond a side.
void ZLanes::leave(const Box& box, int step, bool all, std::int64_t cycle) {
  for (int y = box.y0; y <= box.y1; ++y) {
    for (int x = box.x0; x <= box.x1; ++x) {
      const bool at_side = x == 0 || y == 0 || x == n_ - 1 || y == n_ - 1;
      if (!all && !at_side) continue;
      const ClassSet* const matrix = rows(now_, x, y);
      const int dx = x - light_.source.x, dy = y - light_.source.y;
      std::int64_t gone = targets(step, dx, dy, matrix);
      if (gone == 0) continue;
      if (!all) {
        for (std::size_t i = 0; i < classes_->cut(step, dx).count; ++i) {
          gone -= kept(step, x, dx, ClassSet{1} << i) * kept(step, y, dy, matrix[i]);
        }
      }
      escaped_ += gone;
      tally_.finish(cycle, x, y, gone);
    }
  }
}

// Targets of some classes of a list whose rays are in the cube after the next step.
std::int64_t ZLanes::kept(int step, int at, int offset, ClassSet set) const {
  const Classes::Cut& cut = classes_->cut(step, offset);
  std::int64_t sum = classes_->targets(step + 1, offset,
                                       staying(cut, set) << classes_->cut(step + 1, offset).come);
  for (const int way : {-1, 1}) {
    const bool outward = way < 0 ? cut.down : cut.up, inside = at + way >= 0 && at + way < n_;
    if (outward && inside) sum += classes_->targets(step + 1, offset + way, leaving(cut, set));
  }
  return sum;
}

void ZLanes::advance(const Box& from, const Box& to, int step) {
  for (int y = to.y0; y <= to.y1; ++y) {
    const int dy = y - light_.source.y, inner_y = y - glm::sign(dy);
    const Classes::Cut& v = classes_->cut(step + 1, dy);
    const bool own_y = from.y0 <= y && y <= from.y1;
    for (int x = to.x0; x <= to.x1; ++x) {
      const int dx = x - light_.source.x, inner_x = x - glm::sign(dx);
      const Classes::Cut& u = classes_->cut(step + 1, dx);
      ClassSet* const matrix = rows(next_, x, y);
      for (int i = 0; i < u.count; ++i) {
        const bool comes = i < u.come;
        const int at = comes ? inner_x : x;
        const int row = comes ? classes_->cut(step, dx - glm::sign(dx)).leave + i : i - u.come;
        ClassSet bits = 0;
        if (v.come != 0) {
          bits = leaving(classes_->cut(step, dy - glm::sign(dy)), rows(now_, at, inner_y)[row]);
        }
        if (own_y) bits |= staying(classes_->cut(step, dy), rows(now_, at, y)[row]) << v.come;
        matrix[i] = bits;
      }
    }
  }
}

std::int64_t ZLanes::targets(int step, int dx, int dy, const ClassSet* matrix) const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < classes_->cut(step, dx).count; ++i) {
    if (matrix[i] == 0) continue;
    sum += classes_->targets(step, dx, ClassSet{1} << i) * classes_->targets(step, dy, matrix[i]);
  }
  return sum;
}

}  // namespace rc2::cycle
