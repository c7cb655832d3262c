#include <fmt/format.h>

#include "sw/machine/machine.h"

namespace rc2 {

LightRule parse_light_rule(const std::string& word) {
  for (const LightRule rule : {LightRule::thesis, LightRule::accurate})
    if (word == to_string(rule)) return rule;
  throw Error(
      fmt::format("--light-rule {}: there is no such rule; choose thesis or accurate", word));
}

const char* to_string(LightRule rule) { return rule == LightRule::thesis ? "thesis" : "accurate"; }

}  // namespace rc2
