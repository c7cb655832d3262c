#include "tb/systemc/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "sw/base/error.h"

namespace rc2::tb {

Fault Fault::parse(const std::string& text) {
  static const std::map<std::string, Kind> kinds{{"flip", Kind::flip},
                                                 {"drop", Kind::drop},
                                                 {"repeat", Kind::repeat},
                                                 {"withdraw", Kind::withdraw},
                                                 {"hang", Kind::hang}};
  const std::size_t first = text.find(':'), second = text.rfind(':');
  Fault fault;
  const auto kind = kinds.find(text.substr(0, first));
  const char* end = text.data() + text.size();
  const bool split = first != std::string::npos && first != second;
  if (!split || kind == kinds.end() ||
      std::from_chars(text.data() + second + 1, end, fault.beat).ptr != end || fault.beat < 0) {
    throw Error(fmt::format(
        "--fault {}: write KIND:STREAM:BEAT, KIND being flip, drop, repeat, withdraw or hang and "
        "BEAT a number from 0 on",
        text));
  }
  fault.kind = kind->second;
  fault.stream = text.substr(first + 1, second - first - 1);
  return fault;
}

FaultyUnit::FaultyUnit(Unit& unit, const Fault& fault) : unit_(unit), fault_(fault) {
  const auto& outputs = unit.names().out;
  const auto found = std::find_if(outputs.begin(), outputs.end(), [&](const StreamName& output) {
    return output.name == fault.stream;
  });
  if (found == outputs.end()) {
    std::string names;
    for (const StreamName& output : outputs) names += " " + output.name;
    throw Error(fmt::format("--fault: the unit has no output {}; it has{}", fault.stream, names));
  }
  stream_ = static_cast<std::size_t>(found - outputs.begin());
}

void FaultyUnit::settle(UnitPins& pins) {
  inner_ = pins;
  unit_.settle(inner_);
  const Pins seen = inner_.out[stream_];
  Pins shown = seen;
  Pins& own = inner_.out[stream_];  // its `ready` is what the unit meets
  if (now()) {
    switch (fault_.kind) {
      case Fault::Kind::flip:
        shown.beat.limbs[0] ^= 1;
        break;
      case Fault::Kind::drop:
        shown.valid = false;
        own.ready = true;
        break;
      case Fault::Kind::repeat:
        own.ready = seen.ready && repeated_;
        break;
      default:
        break;
    }
  }
  const bool from_now_on = passed_ >= fault_.beat;
  if (withdrawn_ || (fault_.kind == Fault::Kind::hang && from_now_on)) {
    shown.valid = own.ready = false;
  }
  if (own.ready != seen.ready) unit_.settle(inner_);
  const bool ready = pins.out[stream_].ready;
  pins = inner_;
  pins.out[stream_] = shown;
  pins.out[stream_].ready = ready;
}

void FaultyUnit::clock(const UnitPins& pins) {
  const Pins& shown = pins.out[stream_];
  const Pins& own = inner_.out[stream_];
  unit_.clock(inner_);
  const bool refused = shown.valid && !shown.ready;
  withdrawn_ = fault_.kind == Fault::Kind::withdraw && passed_ >= fault_.beat && refused && !done_;
  done_ = done_ || withdrawn_;
  if (own.valid && own.ready) {
    ++passed_;
  } else if (now() && shown.valid && shown.ready) {
    repeated_ = true;
  }
}

}  // namespace rc2::tb
