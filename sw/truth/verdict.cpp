#include "sw/truth/verdict.h"

#include <glm/geometric.hpp>

namespace rc2::truth {
namespace {

class Votes {
 public:
  Votes(const Surface& surface, const glm::dvec3& light)
      : surface_(surface), light_(light), winding_(surface.winding(light)) {}

  void add(const Sample& sample) {
    if (sample.winding > winding_) return;
    ++exposed_;
    if (sample.seen) ++seen_;
    const Triangles& triangles = surface_.triangles();
    const glm::dvec3& corner = triangles.vertices[triangles.corners[sample.triangle].x];
    if (glm::dot(triangles.doubled_area(sample.triangle), light_ - corner) <= 0) return;
    ++facing_;
    if (surface_.sees(sample.at, light_)) ++lit_;
  }

  Verdict count() const {
    return {exposed_ > 0, exposed_ > 0 && 2 * facing_ >= exposed_,
            facing_ > 0 && 2 * lit_ >= facing_, exposed_ > 0 && 2 * lit_ >= exposed_, seen_ > 0};
  }

  void clear() { exposed_ = facing_ = lit_ = seen_ = 0; }

 private:
  const Surface& surface_;
  glm::dvec3 light_;
  int winding_;
  int exposed_ = 0, facing_ = 0, lit_ = 0, seen_ = 0;
};

}  // namespace

std::vector<Verdict> judge(const Surface& surface, const Samples& samples,
                           const std::vector<glm::ivec3>& voxels, const glm::dvec3& light) {
  std::vector<Verdict> verdicts;
  verdicts.reserve(voxels.size());
  Votes votes(surface, light);
  for (const glm::ivec3& voxel : voxels) {
    votes.clear();
    const Samples::Range in_voxel = samples.of(voxel);
    if (in_voxel.last - in_voxel.first >= kFewest) {
      for (const Sample& sample : in_voxel) votes.add(sample);
    } else {
      const Surface::Foot foot = surface.nearest(voxel);
      votes.add(make_sample(surface, foot.at, foot.triangle));
    }
    verdicts.push_back(votes.count());
  }
  return verdicts;
}

}  // namespace rc2::truth
