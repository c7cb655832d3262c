// A unit whose pins are written down, cycle by cycle, to be replayed on another simulator.
#pragma once

#include <fstream>
#include <string>

#include "tb/systemc/unit.h"

namespace rc2::tb {

class RecordingUnit final : public Unit {
 public:
  /// Writes to `path` a line for every rising edge of the clock, with the pins as they were just
  /// before it: of every input stream `valid beat ready`, of every output stream `ready valid
  /// beat`, hexadecimal; what the unit drives stands last or, of outputs, second and third. Throws
  /// Error if the file cannot be written.
  RecordingUnit(Unit& unit, const std::string& path);

  const StreamNames& names() const override { return unit_.names(); }
  void settle(UnitPins& pins) override {
    unit_.settle(pins);
    settled_ = true;
  }
  void clock(const UnitPins& pins) override;

 private:
  Unit& unit_;
  std::ofstream file_;
  bool settled_ = false;
};

}  // namespace rc2::tb
