// Classes of targets of one axis (rtl/lanes/rc2_axis.sv): which part of a beam goes where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rc2::cycle {

/// A set of classes, bit i for class i of a list.
using ClassSet = std::uint64_t;

/// The targets -(L-1) .. L-1 of one axis, as rays that start together. Along this axis a ray's way
/// depends on its own target only, so after k steps the targets whose rays are at one offset form
/// an interval. A *class* is a part of it, consecutive targets that have been in the same places
/// all the way: no voxel can have stopped one of them and let another pass. The classes of an
/// offset are numbered outward, away from offset 0, where one class is all there is.
///
/// In the next step the classes of an offset up to a limit stay there, those beyond go one offset
/// outward; at most one class is divided. The list of an offset is thus what came from the inner
/// neighbour, then what stayed.
class Classes {
 public:
  /// What a list's classes do in the step after it, and how the list came about.
  struct Cut {
    std::uint8_t count;  ///< classes of the list
    std::uint8_t come;   ///< of them from the inner neighbour; the others have stayed
    std::uint8_t stay;   ///< classes that have targets which stay: 0 .. stay-1
    std::uint8_t leave;  ///< first class that has targets which leave: stay or stay-1
    bool down, up;       ///< some leave to offset-1; to offset+1
  };

  /// All lists of steps 0 .. `steps` and offsets -step .. step. L >= 1.
  Classes(int target_distance, int steps);

  const Cut& cut(int step, int offset) const { return lists_[place(step, offset)].cut; }

  /// Number of targets in a set of the list's classes.
  std::int64_t targets(int step, int offset, ClassSet set) const;

  /// The longest list.
  int most() const { return most_; }

 private:
  struct List {
    std::size_t first;    // of its classes in outer_
    std::uint16_t inner;  // distance from 0 of the innermost target; at offset 0, the lowest one's
    Cut cut;
  };

  static std::size_t place(int step, int offset) {
    const auto row = static_cast<std::size_t>(step);
    return row * row + static_cast<std::size_t>(step + offset);
  }
  int limit(int step, int offset, bool negative) const;
  void find_cut(int step, int offset);
  void make_list(int step, int offset);

  int distance_, most_ = 1;
  std::vector<List> lists_;
  std::vector<std::uint16_t> outer_;  // of each class, distance from 0 of the outermost target
};

/// The classes of a list from `first` on, numbered anew.
inline ClassSet leaving(const Classes::Cut& cut, ClassSet set) { return set >> cut.leave; }

/// The classes that stay, in the same order.
inline ClassSet staying(const Classes::Cut& cut, ClassSet set) {
  return set & ((ClassSet{1} << cut.stay) - 1);
}

}  // namespace rc2::cycle
