#include "tb/systemc/scoreboard.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>

namespace rc2::tb {

bool Expectation::allows(const Beat& got) const {
  for (std::size_t i = 0; i < got.limbs.size(); ++i) {
    if (((got.limbs[i] ^ beat.limbs[i]) & mask.limbs[i]) != 0) return false;
  }
  return true;
}

std::string to_text(const Difference& difference) {
  const std::string cell = difference.cell
                               ? fmt::format("cell ({},{})", difference.cell->x, difference.cell->y)
                               : std::string("no cell");
  return fmt::format("first difference: cycle {}, {}, stream {}\n  expected {}\n  got      {}\n",
                     difference.cycle, cell, difference.stream, difference.expected,
                     difference.got);
}

Scoreboard::Scoreboard(std::vector<Stream> streams) {
  for (Stream& stream : streams) {
    const auto cell = stream.cell;
    lanes_.push_back({std::move(stream), {}, cell});
  }
}

void Scoreboard::expect(std::size_t stream, const Expectation& expectation) {
  lanes_[stream].to_come.push_back(expectation);
}

void Scoreboard::check(std::size_t stream, std::int64_t cycle, const Beat& beat) {
  Lane& lane = lanes_[stream];
  ++checked_;
  if (lane.to_come.empty()) {
    differ(cycle, lane, lane.last_cell, "nothing more", say(lane, beat));
    return;
  }
  auto match = lane.to_come.begin();
  if (lane.stream.order == Order::free) {
    match = std::find_if(lane.to_come.begin(), lane.to_come.end(),
                         [&](const Expectation& wanted) { return wanted.allows(beat); });
  }
  if (match == lane.to_come.end() || !match->allows(beat)) {
    const Expectation& wanted = lane.to_come.front();
    differ(cycle, lane, wanted.cell, say(lane, wanted), say(lane, beat));
    return;
  }
  lane.last_cell = match->cell;
  lane.to_come.erase(match);
}

void Scoreboard::broken_promise(std::size_t stream, std::int64_t cycle, const Beat& held,
                                const Beat* now) {
  const Lane& lane = lanes_[stream];
  const auto cell = lane.to_come.empty() ? lane.last_cell : lane.to_come.front().cell;
  differ(cycle, lane, cell, say(lane, held) + ", offered until it is taken",
         now == nullptr ? "the offer withdrawn" : say(lane, *now));
}

void Scoreboard::silence(std::int64_t cycle, std::int64_t cycles) {
  const auto waiting = std::find_if(lanes_.begin(), lanes_.end(),
                                    [](const Lane& lane) { return !lane.to_come.empty(); });
  const std::string got = fmt::format("nothing for {} cycles", cycles);
  if (waiting == lanes_.end()) {
    difference_ = {cycle, {}, "of an input", "the unit to take a beat", got};
    return;
  }
  const Expectation& wanted = waiting->to_come.front();
  differ(cycle, *waiting, wanted.cell, say(*waiting, wanted), got);
}

bool Scoreboard::done() const {
  return std::all_of(lanes_.begin(), lanes_.end(),
                     [](const Lane& lane) { return lane.to_come.empty(); });
}

void Scoreboard::differ(std::int64_t cycle, const Lane& lane, std::optional<glm::ivec2> cell,
                        std::string expected, std::string got) {
  if (difference_) return;
  difference_ = {cycle, cell, lane.stream.name, std::move(expected), std::move(got)};
}

std::string Scoreboard::say(const Lane& lane, const Expectation& wanted) {
  std::string text = say(lane, wanted.beat);
  if (wanted.mask != Expectation::all_bits()) {
    text += fmt::format(" in the bits {}", fmt::streamed(wanted.mask));
  }
  if (lane.stream.order == Order::free && lane.to_come.size() > 1) {
    text += fmt::format(", or one of {} others", lane.to_come.size() - 1);
  }
  return text;
}

std::string Scoreboard::say(const Lane& lane, const Beat& beat) {
  return fmt::format("{} (bits {})", lane.stream.describe(beat), fmt::streamed(beat));
}

}  // namespace rc2::tb
