#include "sw/cycle/classes.h"

#include <algorithm>
#include <cstdlib>

namespace rc2::cycle {

Classes::Classes(int target_distance, int steps) : distance_(target_distance) {
  const auto rows = static_cast<std::size_t>(steps) + 1;
  lists_.resize(rows * rows);
  const auto widest = static_cast<std::uint16_t>(distance_ - 1);
  outer_.push_back(widest);
  lists_[0] = {0, widest, {1, 0, 0, 0, false, false}};
  for (int step = 0; step < steps; ++step) {
    for (int offset = -step; offset <= step; ++offset) find_cut(step, offset);
    for (int offset = -step - 1; offset <= step + 1; ++offset) make_list(step + 1, offset);
  }
  for (int offset = -steps; offset <= steps; ++offset) find_cut(steps, offset);
}

// The distance from 0 of the outermost target that stays: Y_med of thesis 4.3.1, ties downwards.
int Classes::limit(int step, int offset, bool negative) const {
  const int top = (2 * std::abs(offset) + 1) * distance_, bottom = 2 * (step + 1);
  return negative ? (top + bottom - 1) / bottom - 1 : top / bottom;
}

void Classes::find_cut(int step, int offset) {
  List& list = lists_[place(step, offset)];
  Cut& cut = list.cut;
  if (offset == 0) {
    cut.down = list.inner > limit(step, 0, true);
    cut.up = outer_[list.first] > limit(step, 0, false);
    cut.stay = 1;
    cut.leave = cut.down || cut.up ? 0 : 1;
    return;
  }
  const int last = limit(step, offset, offset < 0);
  cut.down = offset < 0;
  cut.up = offset > 0;
  const std::uint16_t* const outer = outer_.data() + list.first;
  const auto count_up_to = [&](int target) {
    return static_cast<std::uint8_t>(std::upper_bound(outer, outer + cut.count, target) - outer);
  };
  cut.leave = count_up_to(last);
  const int next_inner = cut.leave == 0 ? list.inner : outer[cut.leave - 1] + 1;
  cut.stay =
      static_cast<std::uint8_t>(cut.leave + (cut.leave < cut.count && next_inner <= last ? 1 : 0));
}

void Classes::make_list(int step, int offset) {
  List& list = lists_[place(step, offset)];
  list.first = outer_.size();
  const int before = step - 1;
  if (offset == 0) {
    const List& old = lists_[place(before, 0)];
    list.inner = static_cast<std::uint16_t>(std::min<int>(old.inner, limit(before, 0, true)));
    list.cut.count = 1;
    outer_.push_back(
        static_cast<std::uint16_t>(std::min<int>(outer_[old.first], limit(before, 0, false))));
    return;
  }
  const bool negative = offset < 0;
  const int inward = negative ? offset + 1 : offset - 1;
  const List& inner = lists_[place(before, inward)];
  const int first = limit(before, inward, negative) + 1;
  list.inner = static_cast<std::uint16_t>(first);
  if (inward == 0) {
    const std::uint16_t outermost = negative ? inner.inner : outer_[inner.first];
    if (outermost >= first) outer_.push_back(outermost);
  } else {
    for (std::size_t i = inner.cut.leave; i < inner.cut.count; ++i) {
      outer_.push_back(outer_[inner.first + i]);
    }
    if (inner.cut.leave == inner.cut.stay && inner.cut.leave < inner.cut.count) {
      list.inner = static_cast<std::uint16_t>(
          inner.cut.leave == 0 ? inner.inner : outer_[inner.first + inner.cut.leave - 1U] + 1);
    }
  }
  list.cut.come = static_cast<std::uint8_t>(outer_.size() - list.first);
  if (std::abs(offset) <= before) {
    const List& old = lists_[place(before, offset)];
    if (list.cut.come == 0) list.inner = old.inner;
    const int last = limit(before, offset, negative);
    for (std::size_t i = 0; i < old.cut.stay; ++i) {
      outer_.push_back(static_cast<std::uint16_t>(std::min<int>(outer_[old.first + i], last)));
    }
  }
  list.cut.count = static_cast<std::uint8_t>(outer_.size() - list.first);
  most_ = std::max<int>(most_, list.cut.count);
}

std::int64_t Classes::targets(int step, int offset, ClassSet set) const {
  const List& list = lists_[place(step, offset)];
  if (offset == 0) return set == 0 ? 0 : list.inner + outer_[list.first] + 1;
  std::int64_t sum = 0;
  for (; set != 0; set &= set - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(set));
    const int inner = i == 0 ? list.inner : outer_[list.first + i - 1] + 1;
    sum += outer_[list.first + i] - inner + 1;
  }
  return sum;
}

}  // namespace rc2::cycle
