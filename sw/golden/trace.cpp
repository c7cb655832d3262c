#include "sw/golden/trace.h"

#include "sw/golden/walk.h"
#include "sw/rays/face.h"

namespace rc2::golden {
namespace {

// What the safety net remembers of armour that was passed.
struct Touched {
  glm::ivec3 voxel;
  rays::Face face;
};

struct Net {
  std::optional<Touched> touched;  // the newest plane that the ray could have stopped at
  bool in_room = false;            // the newest armour was a room's, and was left on its inner side
};

class Tracer {
 public:
  Tracer(const Grid& grid, const VoxelMemory& voxels, const Layers& layers, const RayJob& job)
      : grid_(grid), voxels_(voxels), layers_(layers), job_(job) {}

  void follow_tree(const rays::Ray& first) {
    std::vector<rays::Ray> waiting{first};
    while (!waiting.empty()) {
      const rays::Ray ray = waiting.back();
      waiting.pop_back();
      ++result_.counts.issued[static_cast<std::size_t>(rays::depth_of(ray.node))];
      const rays::Split split = follow(ray);
      for (const auto& child : {split.reflected, split.refracted})
        if (child) waiting.push_back(*child);
      result_.counts.too_light += split.too_light;
      result_.counts.too_deep += split.too_deep;
    }
  }

  RayResult take() {
    sort_hits(result_.hits);
    return std::move(result_);
  }

 private:
  rays::Split follow(const rays::Ray& ray) {
    Net net;
    std::optional<rays::Split> end;
    glm::ivec2 column(-1);
    walk(ray, grid_.n(), [&](const glm::ivec3& voxel, int axis) {
      if (glm::ivec2(voxel) != column) ++result_.counts.probes;
      column = voxel;
      end = visit(ray, voxel, axis, net);
      return end.has_value();
    });
    return end ? *end : leave(ray, net);
  }

  // What the ray becomes if it ends here.
  std::optional<rays::Split> visit(const rays::Ray& ray, const glm::ivec3& voxel, int axis,
                                   Net& net) {
    const std::uint32_t number = grid_[grid_.index(voxel)];
    if (number == Grid::kFree) {
      // Armour lies between the two sides of a solid's surface: the ray has slipped through.
      if (!net.touched || layers_.is_inside(voxel) == ray.inside) return std::nullopt;
      return rescue(ray, *net.touched, voxel);
    }
    const Claim& owner = voxels_[number].owner;
    const rays::Owned owned{voxel, (*job_.facets)[owner.facet], owner.core, owner.gap};
    const std::int64_t way = rays::exit_distance(ray, axis, voxel[axis]);
    const auto face = rays::face(ray, owned);
    net.in_room = owned.facet.body == rays::Body::room && rays::is_in_front(ray, owned, axis, way);
    if (face) {
      ++result_.counts.planes;
      net.touched = {voxel, *face};
      if (rays::is_reached(ray, *face, axis, way)) return hit(ray, *net.touched, voxel);
    } else if (net.in_room) {
      net.touched = {voxel, rays::side_face(ray, axis, way)};
    }
    return std::nullopt;
  }

  // The ray stops in the voxel `here`. It may have crossed the plane, far from the facet, long ago.
  rays::Split hit(const rays::Ray& ray, const Touched& touched, const glm::ivec3& here) {
    const std::uint32_t facet = voxels_[grid_[grid_.index(touched.voxel)]].owner.facet;
    const glm::ivec3 point =
        rays::clamp_to_voxel(rays::meeting_point(ray, touched.face, grid_.n()), touched.voxel, 1);
    ++result_.counts.hits;
    result_.hits.push_back({ray, facet, touched.face.is_back, touched.voxel, point});
    return rays::split(ray, (*job_.facets)[facet], touched.face, rays::clamp_to_voxel(point, here),
                       job_.limits, grid_.n());
  }

  // The ray has slipped through.
  rays::Split rescue(const rays::Ray& ray, const Touched& touched, const glm::ivec3& here) {
    ++result_.counts.rescued;
    return hit(ray, touched, here);
  }

  // The ray leaves the cube, which nothing can that is in a room.
  rays::Split leave(const rays::Ray& ray, const Net& net) {
    if (net.in_room) return rescue(ray, *net.touched, net.touched->voxel);
    ++result_.counts.escaped;
    result_.hits.push_back({ray, RayHit::kNoFacet, false, {}, {}});
    return {};
  }

  const Grid& grid_;
  const VoxelMemory& voxels_;
  const Layers& layers_;
  const RayJob& job_;
  RayResult result_;
};

}  // namespace

RayResult trace(const Grid& grid, const VoxelMemory& voxels, const Layers& layers,
                const RayJob& job, const Progress& progress) {
  Tracer tracer(grid, voxels, layers, job);
  const int n = grid.n();
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const rays::Ray first = first_ray(job, {x, y}, n);
      if (first.direction != glm::ivec3(0)) tracer.follow_tree(first);
    }
    if (progress) progress("rays", 0, static_cast<double>(y + 1) / n);
  }
  return tracer.take();
}

}  // namespace rc2::golden
