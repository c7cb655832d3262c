// The thesis's own coarse simulator (4.4.3): cells with a queue, without the buffers and links of
// the machine. A cell serves one beam per cycle and takes any number of arrivals.
#pragma once

#include <boost/dynamic_bitset.hpp>
#include <cstdint>

#include "sw/thesis/experiment.h"
#include "sw/thesis/queues.h"

namespace rc2::thesis {

class Engine {
 public:
  /// The cones are in the source's queue, no cycle has passed. Throws std::bad_alloc.
  explicit Engine(Experiment experiment);

  bool done() const { return busy_.none(); }

  /// One cycle: every cell that has a beam serves the oldest one, or lets it wait. Not to be called
  /// when done. Throws std::logic_error on a deadlock.
  void step();

  std::int64_t cycles() const { return cycles_; }
  std::int64_t visits() const { return visits_; }  ///< beams served

  /// The thesis's FA of a queue without end: the most beams left when one was taken out.
  std::int64_t longest_queue() const { return longest_queue_; }

  /// Targets of all cones, and of the beams that have left the cube. The rest is on its way.
  std::int64_t targets() const { return targets_; }
  std::int64_t home() const { return home_; }

  /// Whether cell (x, y) has a beam, and whether voxel (x, y, z) has had one.
  bool busy(int x, int y) const { return busy_[cell_at({x, y, 0})]; }
  bool reached(glm::ivec3 voxel) const { return reached_[voxel_at(voxel)]; }

 private:
  struct Place {
    glm::ivec3 voxel;
    Beam beam;
  };
  struct Delivery {
    std::size_t cell;
    Place place;
  };
  // What serving a beam does: sub-beams for cells, and targets whose way ends here.
  struct Service {
    boost::container::static_vector<Delivery, 9> deliveries;
    std::int64_t home = 0;
  };

  std::size_t cell_at(glm::ivec3 voxel) const;
  std::size_t voxel_at(glm::ivec3 voxel) const;
  bool inside(glm::ivec3 voxel) const;

  Service service(const Place& place) const;
  bool must_wait(std::size_t cell, const Service& service) const;
  void serve(std::size_t cell);
  void push(std::size_t cell, const Place& place);

  Experiment experiment_;
  Partition partition_;
  Queues<Place> queues_;
  boost::dynamic_bitset<> busy_, serving_, reached_;
  std::int64_t cycles_ = 0, visits_ = 0, longest_queue_ = 0, targets_ = 0, home_ = 0;
};

/// What one diffusion costs.
struct Cost {
  std::int64_t cycles, longest_queue, visits;
};

/// Runs an experiment to its end. Throws std::logic_error on a deadlock, and if a target is lost or
/// doubled.
Cost run(const Experiment& experiment);

}  // namespace rc2::thesis
