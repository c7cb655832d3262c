#include "tb/systemc/machine_unit.h"

namespace rc2::tb {

StreamNames machine_streams() {
  const int packet_bits = WordFormat(kMachine).packet_bits();
  StreamNames names{{{"aw", 7}, {"w", 32}, {"ar", 7}}, {{"b", 2}, {"r", 34}, {"readback", 64}}};
  for (int k = 0; k < kMachine.feeders; ++k) {
    names.in.push_back({"packets" + std::to_string(k), packet_bits});
  }
  return names;
}

}  // namespace rc2::tb
