#include "sw/thesis/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rc2::thesis {

Engine::Engine(Setup setup) : setup_(std::move(setup)), partition_(setup_.n, setup_.distance) {
  const auto n = static_cast<std::size_t>(setup_.n);
  queues_.resize(n * n);
  busy_.resize(n * n);
  reached_.resize(n * n * n);
  for (const Beam& cone : setup_.cones) {
    push(cell_at(setup_.source), {setup_.source, cone});
    targets_ += cone.targets();
  }
}

// Cells are numbered, and so served, from the far corner to the origin: this gives beams that
// arrive in the same cycle their order in a queue, and the thesis's table depends on it.
std::size_t Engine::cell_at(glm::ivec3 voxel) const {
  return static_cast<std::size_t>((setup_.n - 1 - voxel.y) * setup_.n + setup_.n - 1 - voxel.x);
}

std::size_t Engine::voxel_at(glm::ivec3 voxel) const {
  const auto n = static_cast<std::size_t>(setup_.n);
  return (static_cast<std::size_t>(voxel.z) * n + static_cast<std::size_t>(voxel.y)) * n +
         static_cast<std::size_t>(voxel.x);
}

bool Engine::inside(glm::ivec3 voxel) const {
  const auto fits = [this](int i) { return i >= 0 && i < setup_.n; };
  return fits(voxel.x) && fits(voxel.y) && fits(voxel.z);
}

// A beam that arrives in this cycle is served in the next one at the earliest, whichever way it
// goes: who is to be served is settled before anyone is.
void Engine::step() {
  ++cycles_;
  serving_ = busy_;
  for (auto cell = serving_.find_first(); cell != serving_.npos; cell = serving_.find_next(cell)) {
    serve(cell);
  }
}

Engine::Deliveries Engine::deliveries(const Place& place) const {
  Deliveries found;
  if (const int axis = place.beam.axis, ahead = place.voxel[axis] + place.beam.side;
      ahead < 0 || ahead >= setup_.n) {
    return found;
  }
  for (const Child& child : partition_.split(place.beam, place.voxel - setup_.source)) {
    const glm::ivec3 voxel = place.voxel + child.step;
    if (inside(voxel)) found.push_back({cell_at(voxel), {voxel, child.beam}});
  }
  return found;
}

// Only cells that do receive something are asked, and not the cell itself, where the beam has just
// made room. Waiting therefore points away from the source, the busy cells farthest from it never
// wait, and there is no deadlock. Two children for the same cell need one free place: a queue may
// grow beyond FA, because a cell could never hand on both otherwise when FA = 1.
bool Engine::must_wait(std::size_t cell, const Deliveries& deliveries) const {
  if (!setup_.fa) return false;
  const auto full = static_cast<std::size_t>(*setup_.fa);
  return std::any_of(deliveries.begin(), deliveries.end(), [&](const Delivery& delivery) {
    return delivery.cell != cell && queues_[delivery.cell].size() >= full;
  });
}

void Engine::serve(std::size_t cell) {
  std::deque<Place>& queue = queues_[cell];
  const Place place = queue.front();
  const Deliveries out = deliveries(place);
  if (must_wait(cell, out)) {
    if (setup_.conflict == Conflict::kBackToTail) {
      queue.pop_front();
      queue.push_back(place);
    }
    return;
  }

  queue.pop_front();
  ++visits_;
  longest_queue_ = std::max(longest_queue_, static_cast<std::int64_t>(queue.size()));
  home_ += place.beam.targets();
  for (const Delivery& delivery : out) {
    home_ -= delivery.place.beam.targets();
    push(delivery.cell, delivery.place);
  }
  if (queue.empty()) busy_.reset(cell);
}

void Engine::push(std::size_t cell, const Place& place) {
  queues_[cell].push_back(place);
  busy_.set(cell);
  reached_.set(voxel_at(place.voxel));
}

Cost run(const Setup& setup) {
  Engine engine(setup);
  while (!engine.done()) engine.step();
  if (engine.home() != engine.targets()) {
    throw std::logic_error(fmt::format("thesis engine, n = {}: {} targets left, {} came home",
                                       setup.n, engine.targets(), engine.home()));
  }
  return {engine.cycles(), engine.longest_queue(), engine.visits()};
}

}  // namespace rc2::thesis
