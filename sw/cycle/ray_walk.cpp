#include "sw/cycle/ray_walk.h"

#include <algorithm>

#include "sw/cycle/cell.h"
#include "sw/cycle/ray_timing.h"

namespace rc2::cycle {

RayWalk::RayWalk(const rays::Ray& ray, int n)
    : ray_(ray), n_(n), state_(rays::launch(ray, n)), at_(rays::voxel_of(ray.origin)) {}

void RayWalk::probe(const Columns& columns, const RayJob& job, RayCounts& counts) {
  const std::size_t column = cell_number(at_.x, at_.y, n_);
  const int fraction = rays::slope_fraction(n_), up = ray_.direction.z < 0 ? -1 : 1;
  axis_ = state_.decision < 0 ? 0 : 1;
  const std::int64_t exit = axis_ == 0 ? state_.exit_x : state_.exit_y;
  const auto exit_z = static_cast<int>((exit + (std::int64_t{1} << (fraction - 1))) >> fraction);
  const int last = up > 0 ? std::max(at_.z, exit_z) : std::min(at_.z, exit_z);
  is_probed_ = true;
  ++counts.probes;

  for (;; at_.z += up) {
    if (at_.z < 0 || at_.z >= n_) {
      leave_cube(job);
      break;
    }
    if (is_worth_a_look(columns, column, at_.z)) {
      ++reads_;
      if (!columns.occupied(column, at_.z)) {
        if (touched_) hit(job, at_, true);
      } else {
        visit_armour(columns, job, at_.z == last ? axis_ : 2, counts);
      }
      if (end_) break;
    }
    if (at_.z == last) break;
  }
  for (int z = at_.z; z != last && z + up >= 0 && z + up < n_; z += up)
    has_more_ = has_more_ || is_worth_a_look(columns, column, z + up);
  if (!end_) {
    const int next = at_[axis_] + step();
    if (next < 0 || next >= n_) leave_cube(job);
  }
}

bool RayWalk::is_worth_a_look(const Columns& columns, std::size_t column, int z) const {
  return columns.occupied(column, z) || columns.layers(column).inside.has(z) != ray_.inside;
}

void RayWalk::visit_armour(const Columns& columns, const RayJob& job, int axis, RayCounts& counts) {
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
}

void RayWalk::hit(const RayJob& job, const glm::ivec3& here, bool is_rescued) {
  const auto& [voxel, facet, face] = *touched_;
  const glm::ivec3 point = rays::clamp_to_voxel(rays::meeting_point(ray_, face, n_), voxel, 1);
  end_ = {{ray_, facet, face.is_back, voxel, point},
          rays::split(ray_, (*job.facets)[facet], face, rays::clamp_to_voxel(point, here),
                      job.limits, n_),
          is_rescued};
  const rays::Facet& what = (*job.facets)[facet];
  const int ratio = face.is_back ? what.leave : what.enter;
  const bool is_refracted =
      what.is_glass() && rays::refract(ray_.direction, face, ratio, n_).has_value();
  const bool bends = end_->split.reflected || (what.is_glass() && end_->split.refracted);
  end_->meet_cycles = ray_timing::meet(n_, is_refracted);
  end_->bend_cycles = bends ? ray_timing::bend(n_) : ray_timing::kNothing;
}

void RayWalk::leave_cube(const RayJob& job) {
  if (in_room_)
    hit(job, touched_->voxel, true);
  else
    end_ = {{ray_, RayHit::kNoFacet, false, {}, {}},
            {},
            false,
            ray_timing::kNothing,
            ray_timing::kNothing};
}

void RayWalk::advance() {
  is_probed_ = false;
  reads_ = 0;
  ready_at_ = kNever;
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
