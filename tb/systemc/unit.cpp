#include "tb/systemc/unit.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace rc2::tb {

std::ostream& operator<<(std::ostream& out, const Beat& beat) {
  std::ostringstream digits;  // leaves the flags of `out` alone
  digits << std::hex << std::setfill('0');
  for (auto limb = beat.limbs.rbegin(); limb != beat.limbs.rend(); ++limb) {
    digits << std::setw(8) << *limb;
  }
  const std::string text = digits.str();
  return out << text.substr(std::min(text.find_first_not_of('0'), text.size() - 1));
}

}  // namespace rc2::tb
