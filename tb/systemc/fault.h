// A unit that is wrong on purpose: a right one cannot show that the scoreboard notices.
#pragma once

#include <string>

#include "tb/systemc/unit.h"

namespace rc2::tb {

/// What goes wrong with one beat of an output.
struct Fault {
  enum class Kind : std::uint8_t { none, flip, drop, repeat, withdraw, hang };

  Kind kind = Kind::none;
  std::string stream;
  std::int64_t beat = 0;  ///< the first is 0

  /// From "KIND:STREAM:BEAT", KIND being flip (one bit), drop, repeat, withdraw (the first
  /// from this one on that has to wait is taken back) or hang (nothing any more). Throws Error.
  static Fault parse(const std::string& text);
};

class FaultyUnit final : public Unit {
 public:
  /// Throws Error if the unit has no such output.
  FaultyUnit(Unit& unit, const Fault& fault);

  const StreamNames& names() const override { return unit_.names(); }
  void settle(UnitPins& pins) override;
  void clock(const UnitPins& pins) override;

 private:
  bool now() const { return passed_ == fault_.beat; }

  Unit& unit_;
  Fault fault_;
  std::size_t stream_ = 0;
  UnitPins inner_;           // what the unit itself sees and shows
  std::int64_t passed_ = 0;  // beats that have left the unit
  bool repeated_ = false;    // the beat was given twice
  bool withdrawn_ = false;   // an offer of the cycle before is hidden
  bool done_ = false;        // that has happened
};

}  // namespace rc2::tb
