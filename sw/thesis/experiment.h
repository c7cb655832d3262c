// The experiments of thesis 4.4.3, as data for the engine. The thesis does not state its set-ups in
// full: these are the ones that give its figures, or come nearest (docs/thesis-tables.md).
#pragma once

#include <optional>
#include <vector>

#include "sw/thesis/split.h"

namespace rc2::thesis {

constexpr int kMaxSide = 512;    ///< a larger diffusion takes many minutes
constexpr int kMaxFa = 1 << 20;  ///< no queue ever holds as many beams

/// What becomes of the beam at the head of a queue when a receiving cell is full (thesis 4.4.2).
enum class Conflict {
  kHeadWaits,   ///< it keeps its place
  kBackToTail,  ///< it goes to the end of its queue ("remettre le faisceau dans FA", 4.4.1)
};

/// An empty cube of n^3 voxels and the beams that its source sends.
struct Experiment {
  int n;
  int distance;             ///< L of the virtual faces, in voxels
  glm::ivec3 source;        ///< a voxel
  std::vector<Beam> cones;  ///< in the order in which they enter the source's queue
  std::optional<int> fa;    ///< beams in a queue that is full; nothing: no queue is ever full
  Conflict conflict = Conflict::kHeadWaits;
};

/// One cone towards the upper face of `axis`, from the corner (0, 0, 0), queues without end. Along
/// z it is the table of longest queues.
Experiment one_cone(int n, int axis);

/// The tables of queues of a given length: the cones +x, +y, +z from the corner.
Experiment corner(int n, std::optional<int> fa, Conflict conflict = Conflict::kHeadWaits);

/// The pages of snapshots: the cones +x, -x, +y, -y, +z, -z from voxel (n-1)/2 on each axis.
Experiment centre(int n, std::optional<int> fa, Conflict conflict = Conflict::kHeadWaits);

/// One octant of a plane (thesis 4.3.1): a fan of rays along x, in the plane z = 0.
Experiment plane(int n);

/// The same rays sent one after another (thesis 4.2.4): a queue of beams of one target each.
Experiment one_by_one(Experiment experiment);

}  // namespace rc2::thesis
