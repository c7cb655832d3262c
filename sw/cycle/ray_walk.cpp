#include "sw/cycle/ray_walk.h"

#include <algorithm>

#include "sw/cycle/cell.h"
#include "sw/cycle/ray_timing.h"

namespace rc2::cycle {

RayWalk::RayWalk(const rays::Ray& ray, int n)
    : ray_(ray), n_(n), state_(rays::launch(ray, n)), at_(rays::voxel_of(ray.origin)) {}

int RayWalk::probe(const Columns& columns, const RayJob& job, RayCounts& counts) {
  const std::size_t column = cell_number(at_.x, at_.y, n_);
  const ColumnLayers& layers = columns.layers(column);
  const int fraction = rays::slope_fraction(n_), up = ray_.direction.z < 0 ? -1 : 1;
  axis_ = state_.decision < 0 ? 0 : 1;
  const std::int64_t exit = axis_ == 0 ? state_.exit_x : state_.exit_y;
  const auto exit_z = static_cast<int>((exit + (std::int64_t{1} << (fraction - 1))) >> fraction);
  const int last = up > 0 ? std::max(at_.z, exit_z) : std::min(at_.z, exit_z);
  is_probed_ = true;
  ++counts.probes;

  int reads = 0;
  for (;; at_.z += up) {
    if (at_.z < 0 || at_.z >= n_) {
      leave_cube(job);
      break;
    }
    if (columns.occupied(column, at_.z)) {
      ++reads;
      if (visit_armour(columns, job, at_.z == last ? axis_ : 2, counts)) break;
    } else if (layers.inside.has(at_.z) != ray_.inside) {
      ++reads;
      if (touched_) {
        hit(job, at_, true);
        break;
      }
    }
    if (at_.z == last) break;
  }
  if (!end_) {
    const int next = at_[axis_] + step();
    if (next < 0 || next >= n_) leave_cube(job);
  }
  return reads;
}

bool RayWalk::visit_armour(const Columns& columns, const RayJob& job, int axis, RayCounts& counts) {
  const Claim owner = columns.owner(cell_number(at_.x, at_.y, n_), at_.z).claim;
  const rays::Owned owned{at_, (*job.facets)[owner.facet], owner.core, owner.gap};
  const std::int64_t way = rays::exit_distance(ray_, axis, at_[axis]);
  const auto face = rays::face(ray_, owned);
  in_room_ = owned.facet.body == rays::Body::room && rays::is_in_front(ray_, owned, axis, way);
  if (face) {
    ++counts.planes;
    touched_ = {at_, owner.facet, *face};
    if (rays::is_reached(ray_, *face, axis, way)) hit(job, at_, false);
  } else if (in_room_) {
    touched_ = {at_, owner.facet, rays::side_face(ray_, axis, way)};
  }
  return end_.has_value();
}

void RayWalk::hit(const RayJob& job, const glm::ivec3& here, bool is_rescued) {
  const auto& [voxel, facet, face] = *touched_;
  const glm::ivec3 point = rays::clamp_to_voxel(rays::meeting_point(ray_, face, n_), voxel, 1);
  end_ = {{ray_, facet, face.is_back, voxel, point},
          rays::split(ray_, (*job.facets)[facet], face, rays::clamp_to_voxel(point, here),
                      job.limits, n_),
          is_rescued};
  end_->cycles = arithmetic_cycles((*job.facets)[facet], face, end_->split.reflected.has_value());
}

int RayWalk::arithmetic_cycles(const rays::Facet& facet, const rays::Face& face,
                               bool is_mirrored) const {
  int cycles = ray_timing::meet(n_);
  if (facet.is_glass()) {
    const int ratio = face.is_back ? facet.leave : facet.enter;
    const bool all = !rays::refract(ray_.direction, face, ratio, n_);
    cycles += ray_timing::refract(n_, all);
  }
  if (is_mirrored) cycles += ray_timing::reflect(n_);
  return cycles + ray_timing::kShare + 2 * ray_timing::kChild;
}

void RayWalk::leave_cube(const RayJob& job) {
  is_beyond_ = true;
  if (in_room_)
    hit(job, touched_->voxel, true);
  else
    end_ = {{ray_, RayHit::kNoFacet, false, {}, {}}, {}};
}

void RayWalk::advance() {
  is_probed_ = false;
  at_[axis_] += step();
  if (axis_ == 0) {
    state_.decision += std::int64_t{std::abs(ray_.direction.y)} * rays::kPlaceOne;
    state_.exit_x += state_.slope_x;
  } else {
    state_.decision -= std::int64_t{std::abs(ray_.direction.x)} * rays::kPlaceOne;
    state_.exit_y += state_.slope_y;
  }
}

}  // namespace rc2::cycle
