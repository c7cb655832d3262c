#include "fmt/format.h"
#include "sw/base/error.h"
#include "sw/facet/facet.h"

namespace rc2::facet {

Rule parse_rule(const std::string& word) {
  for (const Rule rule : {Rule::armoured, Rule::naive, Rule::supercover, Rule::half, Rule::blindee})
    if (word == to_string(rule)) return rule;
  throw Error(
      fmt::format("--rule {}: there is no such rule; choose armoured, naive, supercover, "
                  "half or blindee",
                  word));
}

const char* to_string(Rule rule) {
  switch (rule) {
    case Rule::armoured:
      return "armoured";
    case Rule::naive:
      return "naive";
    case Rule::supercover:
      return "supercover";
    case Rule::half:
      return "half";
    case Rule::blindee:
      return "blindee";
  }
  return "unknown";
}

}  // namespace rc2::facet
