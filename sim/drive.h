// One machine through one job: load, then one light after another, every law checked.
#pragma once

#include <string>
#include <vector>

#include "sim/job.h"
#include "sim/lights.h"
#include "sim/progress_bar.h"
#include "sw/machine/machine.h"
#include "sw/report/dump.h"

namespace rc2 {

class Drive {
 public:
  /// `name` is what the progress bar calls the machine. Everything must outlive the drive.
  Drive(Machine& machine, std::string name, ProgressBar& bar)
      : machine_(machine), name_(std::move(name)), bar_(bar) {}

  /// The facets must outlive the drive. Throws std::logic_error if the voxels break a law of
  /// sw/report/laws.h.
  void load(const facet::FacetSet& facets);

  /// One result per lamp. Throws std::logic_error if conservation is broken.
  std::vector<LightResult> light(const std::vector<Lamp>& lamps, int target_distance, int fa,
                                 LightRule rule);

  /// Throws std::logic_error if a ray is lost.
  RayResult trace(const RayJob& job);

  std::int64_t load_cycles() const { return load_.cycles; }

  /// What the machine has held after load() and after each light.
  const report::Memories& memories() const { return memories_; }

 private:
  Machine& machine_;
  std::string name_;
  ProgressBar& bar_;
  LoadResult load_;
  report::Memories memories_;
};

}  // namespace rc2
