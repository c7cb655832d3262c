#include "sw/thesis/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rc2::thesis {
namespace {

std::size_t area(int n) { return static_cast<std::size_t>(n) * static_cast<std::size_t>(n); }

}  // namespace

Engine::Engine(Experiment experiment)
    : experiment_(std::move(experiment)),
      partition_(experiment_.n, experiment_.distance),
      queues_(area(experiment_.n)),
      busy_(area(experiment_.n)),
      reached_(area(experiment_.n) * static_cast<std::size_t>(experiment_.n)) {
  for (const Beam& cone : experiment_.cones) {
    push(cell_at(experiment_.source), {experiment_.source, cone});
    targets_ += cone.targets();
  }
}

// Cells are numbered, and so served, from the far corner to the origin: this gives beams that
// arrive in the same cycle their order in a queue, and the thesis's table depends on it.
std::size_t Engine::cell_at(glm::ivec3 voxel) const {
  return static_cast<std::size_t>((experiment_.n - 1 - voxel.y) * experiment_.n + experiment_.n -
                                  1 - voxel.x);
}

std::size_t Engine::voxel_at(glm::ivec3 voxel) const {
  const auto n = static_cast<std::size_t>(experiment_.n);
  return (static_cast<std::size_t>(voxel.z) * n + static_cast<std::size_t>(voxel.y)) * n +
         static_cast<std::size_t>(voxel.x);
}

bool Engine::inside(glm::ivec3 voxel) const {
  const auto fits = [this](int i) { return i >= 0 && i < experiment_.n; };
  return fits(voxel.x) && fits(voxel.y) && fits(voxel.z);
}

// A beam that arrives in this cycle is served in the next one at the earliest, whichever way it
// goes: who is to be served is settled before anyone is.
void Engine::step() {
  const std::int64_t before = visits_;
  ++cycles_;
  serving_ = busy_;
  for (auto cell = serving_.find_first(); cell != boost::dynamic_bitset<>::npos;
       cell = serving_.find_next(cell)) {
    serve(cell);
  }
  if (visits_ == before) {
    throw std::logic_error(fmt::format("thesis engine, n = {}: deadlock in cycle {} of {} cells",
                                       experiment_.n, cycles_, serving_.count()));
  }
}

Engine::Service Engine::service(const Place& place) const {
  Service service;
  if (const int axis = place.beam.axis, ahead = place.voxel[axis] + place.beam.side;
      ahead < 0 || ahead >= experiment_.n) {
    service.home = place.beam.targets();
    return service;
  }
  for (const Child& child : partition_.split(place.beam, place.voxel - experiment_.source)) {
    const glm::ivec3 voxel = place.voxel + child.step;
    if (inside(voxel)) {
      service.deliveries.push_back({cell_at(voxel), {voxel, child.beam}});
    } else {
      service.home += child.beam.targets();
    }
  }
  return service;
}

// Only cells that do receive something are asked, and not the cell itself, where the beam has just
// made room. Waiting therefore points away from the source, the busy cells farthest from it never
// wait, and there is no deadlock. Two children for the same cell need one free place: a queue may
// grow beyond FA, because a cell could never hand on both otherwise when FA = 1.
bool Engine::must_wait(std::size_t cell, const Service& service) const {
  if (!experiment_.fa) return false;
  const auto full = static_cast<std::size_t>(*experiment_.fa);
  return std::any_of(service.deliveries.begin(), service.deliveries.end(),
                     [&](const Delivery& delivery) {
                       return delivery.cell != cell && queues_.size(delivery.cell) >= full;
                     });
}

void Engine::serve(std::size_t cell) {
  const Place place = queues_.front(cell);
  const Service todo = service(place);
  if (must_wait(cell, todo)) {
    if (experiment_.conflict == Conflict::kBackToTail) queues_.rotate(cell);
    return;
  }

  queues_.pop(cell);
  ++visits_;
  longest_queue_ = std::max(longest_queue_, static_cast<std::int64_t>(queues_.size(cell)));
  home_ += todo.home;
  for (const Delivery& delivery : todo.deliveries) push(delivery.cell, delivery.place);
  if (queues_.size(cell) == 0) busy_.reset(cell);
}

void Engine::push(std::size_t cell, const Place& place) {
  queues_.push(cell, place);
  busy_.set(cell);
  reached_.set(voxel_at(place.voxel));
}

Cost run(const Experiment& experiment) {
  Engine engine(experiment);
  while (!engine.done()) engine.step();
  if (engine.home() != engine.targets()) {
    throw std::logic_error(fmt::format("thesis engine, n = {}: {} targets left, {} came home",
                                       experiment.n, engine.targets(), engine.home()));
  }
  return {engine.cycles(), engine.longest_queue(), engine.visits()};
}

}  // namespace rc2::thesis
