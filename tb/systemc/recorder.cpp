#include "tb/systemc/recorder.h"

#include "sw/base/error.h"

namespace rc2::tb {

RecordingUnit::RecordingUnit(Unit& unit, const std::string& path) : unit_(unit), file_(path) {
  if (!file_) {
    throw Error("--record " + path +
                ": the file cannot be written; name one in a folder that exists");
  }
}

void RecordingUnit::clock(const UnitPins& pins) {
  // Before the first settling nobody has driven anything.
  if (!settled_) return unit_.clock(pins);
  for (const Pins& in : pins.in) file_ << in.valid << ' ' << in.beat << ' ' << in.ready << ' ';
  for (const Pins& out : pins.out) file_ << out.ready << ' ' << out.valid << ' ' << out.beat << ' ';
  file_ << '\n';
  unit_.clock(pins);
}

}  // namespace rc2::tb
