// Scenes that look for trouble, several facets at a time and on top of each other.
#pragma once

#include <vector>

#include "tb/load/dice.h"
#include "tb/load/facet_generator.h"

namespace rc2::stress {

using facet::Border;
using facet::Cube;
using facet::Dice;

using Body = std::vector<Border>;

struct Attack {
  const char* name;
  const char* tries;  ///< what it is made of, in a few words
  bool is_closed;  ///< each body is closed, convex and has its outside in front; else there is one
  /// Planar convex facets within the cube; some may have no area.
  std::vector<Body> (*draw)(const Cube&, Dice&);
};

const std::vector<Attack>& attacks();

}  // namespace rc2::stress
