// Compares what comes out of a unit with what an untimed reference expects, which knows the order
// on each stream but not the time, and keeps the first difference.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tb/systemc/unit.h"

namespace rc2::tb {

/// A beat that is to come, and from which cell, if from one; bits outside the mask may be anything.
struct Expectation {
  std::optional<glm::ivec2> cell;
  Beat beat;
  Beat mask = all_bits();

  static Beat all_bits() {
    Beat mask;
    mask.limbs.fill(~std::uint32_t{0});
    return mask;
  }
  bool allows(const Beat& got) const;
};

/// Says in words what a beat means.
using Describe = std::function<std::string(const Beat&)>;

struct Difference {
  std::int64_t cycle;
  std::optional<glm::ivec2> cell;
  std::string stream, expected, got;
};

/// Two lines "expected ..", "got .." under one that names cycle, cell and stream.
std::string to_text(const Difference& difference);

/// Whether the beats of a stream come in the order in which they were expected.
enum class Order : std::uint8_t { kept, free };

class Scoreboard {
 public:
  struct Stream {
    std::string name;
    Describe describe;
    Order order = Order::kept;
    std::optional<glm::ivec2> cell =
        std::nullopt;  ///< that what nobody expected comes from, if known
  };
  explicit Scoreboard(std::vector<Stream> streams);

  void expect(std::size_t stream, const Expectation& expectation);

  /// A beat has come.
  void check(std::size_t stream, std::int64_t cycle, const Beat& beat);

  /// A source has changed its mind: it offered `held` and was not heard, and now offers something
  /// else, or nothing.
  void broken_promise(std::size_t stream, std::int64_t cycle, const Beat& held, const Beat* now);

  /// Nothing has moved for too long.
  void silence(std::int64_t cycle, std::int64_t cycles);

  /// All that was expected has come.
  bool done() const;

  std::int64_t checked() const { return checked_; }
  const std::optional<Difference>& difference() const { return difference_; }

 private:
  struct Lane {
    Stream stream;
    std::deque<Expectation> to_come;
    std::optional<glm::ivec2> last_cell;
  };

  void differ(std::int64_t cycle, const Lane& lane, std::optional<glm::ivec2> cell,
              std::string expected, std::string got);
  static std::string say(const Lane& lane, const Expectation& wanted);
  static std::string say(const Lane& lane, const Beat& beat);

  std::vector<Lane> lanes_;
  std::int64_t checked_ = 0;
  std::optional<Difference> difference_;
};

}  // namespace rc2::tb
