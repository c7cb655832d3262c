#include "sw/chapter5/choices.h"

namespace rc2::chapter5 {

std::vector<NamedChoices> all_choices() {
  std::vector<NamedChoices> all{{"machine", {}}};
  const auto add = [&](const char* name, const auto& choose) {
    Choices choices;
    choose(choices);
    all.push_back({name, choices});
  };
  add("normal: mean", [](Choices& c) { c.normal = Normal::mean; });
  add("normal: side", [](Choices& c) { c.normal = Normal::side; });
  add("point: centre", [](Choices& c) { c.point = Point::centre; });
  add("point: side", [](Choices& c) { c.point = Point::side; });
  add("leave: facing", [](Choices& c) { c.leave = Leave::facing; });
  add("leave: gap", [](Choices& c) { c.leave = Leave::gap; });
  add("leave: own facet", [](Choices& c) { c.leave = Leave::own_facet; });
  add("leave: nothing", [](Choices& c) { c.leave = Leave::nothing; });
  add("owner: nearest", [](Choices& c) { c.owner = Owner::nearest; });
  add("owner: first", [](Choices& c) { c.owner = Owner::first; });
  add("steps: 26", [](Choices& c) { c.steps = Steps::twenty_six; });
  // 5.2.1 with 5.3.2, the rays of 4.3.1, and what 5.5.2 asks for at the least.
  add("facet, centre, own, nearest, 26", [](Choices& c) {
    c = {Normal::facet, Point::centre, Leave::own_facet, Owner::nearest, Steps::twenty_six};
  });
  // 5.2.2 with 5.3.1: nothing is known of a surface but its voxels.
  add("side, side, nothing", [](Choices& c) {
    c = {Normal::side, Point::side, Leave::nothing, Owner::core, Steps::six};
  });
  return all;
}

}  // namespace rc2::chapter5
