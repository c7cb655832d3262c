// One scene on all machines, against the oracles and each other.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sw/machine/machine.h"
#include "tb/stress/attacks.h"

namespace rc2::stress {

/// What was compared.
struct Tally {
  std::int64_t trials = 0, facets = 0, without_area = 0;
  std::int64_t voxels = 0;   ///< of all machines
  std::int64_t lights = 0;   ///< of all machines and rules
  std::int64_t targets = 0;  ///< of all lights
  std::int64_t refused = 0;  ///< lights that a machine says it cannot do
  std::int64_t differences = 0;
};

/// Tallies by a heading ("attack", "light from", "L", ...) and an entry below it.
class Findings {
 public:
  Tally& at(const std::string& heading, const std::string& entry) {
    return tallies_[heading][entry];
  }
  const std::map<std::string, std::map<std::string, Tally>>& all() const { return tallies_; }

 private:
  std::map<std::string, std::map<std::string, Tally>> tallies_;
};

/// A machine and what it is called in the tables.
struct Named {
  std::string name;
  std::shared_ptr<Machine> machine;
};

/// Draws a scene and compares, on golden, the cycle model in both modes and `more` machines, which
/// have to be of the cube's side and of its f at least:
///  - what became of its facets: loaded, or counted as without area;
///  - every voxel, by one of the five rules, with the exact oracle (tb/load/machine_check.h);
///  - every layer of all machines with each other, and of closed bodies what is inside with exact
///    geometry;
///  - lights from corners, edges and faces of the cube, beside facets and inside solids, with L
///    from 1 to 8n and the largest there is: every count of every machine that knows the rule with
///    LightOracle, and conservation.
/// Everything follows from the seed. Throws std::exception at the first difference.
void run_trial(const Attack& attack, const Cube& cube, std::uint64_t seed,
               const std::vector<Named>& more, Findings& findings);

}  // namespace rc2::stress
