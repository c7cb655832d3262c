#include "sw/chapter5/tracer.h"

#include <cmath>

#include "sw/golden/walk.h"
#include "sw/rays/face.h"

namespace rc2::chapter5 {
namespace {

std::int64_t dot(const glm::ivec3& a, const glm::ivec3& b) {
  return std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y + std::int64_t{a.z} * b.z;
}

// A normal of a surface, turned towards the ray; `height` of the ray's origin over the plane.
rays::Face facing(const rays::Ray& ray, const glm::ivec3& normal, std::int64_t height,
                  bool is_back) {
  const std::int64_t leaving = dot(normal, ray.direction);
  return leaving > 0 ? rays::Face{-normal, -height, leaving, is_back}
                     : rays::Face{normal, height, -leaving, is_back};
}

// The voxels nearest to the ray where it passes the middles of the voxels along its longest axis.
template <typename Visit>
void walk_26(const rays::Ray& ray, int n, Visit visit) {
  const glm::ivec3 size = glm::abs(ray.direction);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int step = ray.direction[axis] < 0 ? -1 : 1;
  const glm::dvec3 slope = glm::dvec3(ray.direction) / double(ray.direction[axis]);
  for (int along = rays::voxel_of(ray.origin)[axis];; along += step) {
    const double way = double{rays::kPlaceOne} * along - ray.origin[axis];
    const glm::ivec3 at = along == rays::voxel_of(ray.origin[axis])
                              ? rays::voxel_of(ray.origin)
                              : glm::ivec3(glm::round((glm::dvec3(ray.origin) + slope * way) /
                                                      double{rays::kPlaceOne}));
    if (glm::clamp(at, 0, n - 1) != at || visit(at, axis)) return;
  }
}

// The side through which the ray comes into a voxel: its axis, and the way to it over direction.
struct Entry {
  int axis = 0;
  double way = -1e9;
};

Entry entry(const rays::Ray& ray, const glm::ivec3& voxel) {
  Entry last;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) continue;
    const double way =
        static_cast<double>(rays::exit_distance(ray, axis, voxel[axis]) - rays::kPlaceOne) /
        std::abs(ray.direction[axis]);
    if (way > last.way) last = {axis, way};
  }
  return last;
}

class Tracer {
 public:
  Tracer(const Voxels& voxels, const RayJob& job, const Choices& choices, bool from_viewer)
      : voxels_(voxels), job_(job), choices_(choices), from_viewer_(from_viewer) {}

  void follow_tree(const rays::Ray& first) {
    std::vector<rays::Ray> waiting{first};
    while (!waiting.empty()) {
      const rays::Ray ray = waiting.back();
      waiting.pop_back();
      ++result_.counts.issued[static_cast<std::size_t>(rays::depth_of(ray.node))];
      const rays::Split split = follow(ray);
      for (const auto& child : {split.reflected, split.refracted})
        if (child) waiting.push_back(*child);
    }
  }

  RayResult take() {
    sort_hits(result_.hits);
    return std::move(result_);
  }

 private:
  rays::Split follow(const rays::Ray& ray) {
    const bool is_viewers = from_viewer_ && ray.node == 1;
    const Leave leave = is_viewers ? Leave::facing_exit : choices_.leave;
    const glm::ivec3 start = rays::voxel_of(ray.origin);
    const VoxelRecord* const own = voxels_.find(start);
    bool has_left = false;
    std::optional<rays::Split> end;
    const auto visit = [&](const glm::ivec3& at, int axis) {
      const VoxelRecord* const voxel = voxels_.find(at);
      if (voxel == nullptr) {
        has_left = true;
        return false;
      }
      const bool is_own = own != nullptr && own->owner.facet == voxel->owner.facet;
      switch (leave) {
        case Leave::nothing:
          if (at != start) end = hit(ray, *voxel, is_seen_from_back(ray, *voxel));
          break;
        case Leave::own_facet:
          if (!is_own) end = hit(ray, *voxel, is_seen_from_back(ray, *voxel));
          break;
        case Leave::gap:
          if (has_left) end = hit(ray, *voxel, is_seen_from_back(ray, *voxel));
          break;
        case Leave::facing:
          if (is_facing(ray, *voxel, is_own)) end = hit(ray, *voxel, is_behind(ray, *voxel));
          break;
        case Leave::facing_exit: {
          const auto face = rays::face(ray, owned(*voxel));
          const std::int64_t way = rays::exit_distance(ray, axis, at[axis]);
          if (face && rays::is_reached(ray, *face, axis, way))
            end = hit(ray, *voxel, face->is_back);
          break;
        }
      }
      return end.has_value();
    };
    if (choices_.steps == Steps::six || is_viewers)
      golden::walk(ray, voxels_.n(), visit);
    else
      walk_26(ray, voxels_.n(), visit);
    if (end) return *end;
    ++result_.counts.escaped;
    result_.hits.push_back({ray, RayHit::kNoFacet, false, {}, {}});
    return {};
  }

  const rays::Facet& facet(const VoxelRecord& voxel) const {
    return (*job_.facets)[voxel.owner.facet];
  }
  rays::Owned owned(const VoxelRecord& voxel) const {
    return {voxel.at, facet(voxel), voxel.owner.core, voxel.owner.gap};
  }

  // Beyond the owner's plane, by its normal.
  bool is_behind(const rays::Ray& ray, const VoxelRecord& voxel) const {
    return dot(facet(voxel).normal, ray.direction) > 0;
  }

  // A rule that does not ask how the owner is turned takes a ray in glass to meet glass.
  bool is_seen_from_back(const rays::Ray& ray, const VoxelRecord& voxel) const {
    if (facet(voxel).body == rays::Body::sheet) return is_behind(ray, voxel);
    return ray.inside && facet(voxel).is_glass();
  }

  bool is_facing(const rays::Ray& ray, const VoxelRecord& voxel, bool is_own) const {
    if (facet(voxel).body == rays::Body::sheet) return !is_own;
    return is_behind(ray, voxel) == (ray.inside && facet(voxel).is_glass());
  }

  rays::Split hit(const rays::Ray& ray, const VoxelRecord& voxel, bool is_back) {
    const Entry in = entry(ray, voxel.at);
    const rays::Facet& of = facet(voxel);
    // As sw/rays has it: from the middle of the sixteenth that a gap was rounded down to.
    constexpr int kSixteenth = rays::kPlaceOne >> kGapFractionBits;
    const std::int64_t height =
        std::int64_t{voxel.owner.gap * kSixteenth + kSixteenth / 2} * rays::kNormalOne +
        dot(of.normal, ray.origin - rays::kPlaceOne * voxel.at);
    const rays::Face plane = facing(ray, of.normal, height, is_back);
    const glm::ivec3 point =
        rays::clamp_to_voxel(meeting_point(ray, plane, in, voxel.at), voxel.at, 1);
    ++result_.counts.hits;
    result_.hits.push_back({ray, voxel.owner.facet, is_back, voxel.at, point});
    const rays::Face face =
        choices_.normal == Normal::facet ? plane : facing(ray, normal(in, voxel), height, is_back);
    return rays::split(ray, of, face, rays::clamp_to_voxel(point, voxel.at), job_.limits,
                       voxels_.n());
  }

  glm::ivec3 normal(const Entry& in, const VoxelRecord& voxel) const {
    if (choices_.normal == Normal::mean) return voxels_.mean_normal(voxel);
    glm::ivec3 side(0);
    side[in.axis] = rays::kNormalOne;
    return side;
  }

  glm::ivec3 meeting_point(const rays::Ray& ray, const rays::Face& plane, const Entry& in,
                           const glm::ivec3& voxel) const {
    const bool has_plane = plane.approach > 0;
    if (choices_.point == Point::plane && has_plane)
      return rays::meeting_point(ray, plane, voxels_.n());
    if (choices_.point == Point::side)
      return ray.origin + glm::ivec3(glm::round(std::max(0.0, in.way) * glm::dvec3(ray.direction)));
    return rays::kPlaceOne * voxel;
  }

  const Voxels& voxels_;
  const RayJob& job_;
  const Choices choices_;
  const bool from_viewer_;
  RayResult result_;
};

}  // namespace

RayResult trace(const Voxels& voxels, const RayJob& job, const Choices& choices, bool from_viewer) {
  Tracer tracer(voxels, job, choices, from_viewer);
  for (glm::ivec2 pixel(0); pixel.y < voxels.n(); ++pixel.y) {
    for (pixel.x = 0; pixel.x < voxels.n(); ++pixel.x) {
      const rays::Ray first = first_ray(job, pixel, voxels.n());
      if (first.direction != glm::ivec3(0)) tracer.follow_tree(first);
    }
  }
  return tracer.take();
}

}  // namespace rc2::chapter5
