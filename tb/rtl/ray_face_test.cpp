// rc2_ray_face against sw/rays: facing and exit, the inner side of a room, the side of a voxel.
#include "sw/machine/claim.h"
#include "tb/rtl/ray_ports.h"

namespace {

using namespace rc2;
using namespace rc2::tb;

struct Seen {
  glm::ivec3 normal;
  std::int64_t height, approach;
  bool is_back;
};

template <class Port>
Seen unpacked(const Port& face) {
  const int low = 1 + kFacetBits + 2 * kShareBits + 1 + kIndexBits;  // bits below the approach
  const int normal = low + kApproachBits + kHeightBits;
  return {{field_of(face, normal + 2 * rays::kNormalBits, rays::kNormalBits),
           field_of(face, normal + rays::kNormalBits, rays::kNormalBits),
           field_of(face, normal, rays::kNormalBits)},
          field_of(face, low + kApproachBits, kHeightBits),
          field_of(face, low, kApproachBits, false),
          field_of(face, low - 1, 1, false) != 0};
}

TEST(RayFace, SeesAndReachesWhatTheModelDoes) {
  Module<Vtop> unit;
  scene::Random random(2);
  int seen = 0, reached = 0, sides = 0;
  for (int i = 0; i < 60000; ++i) {
    rays::Ray ray = random_ray(random, kSide);
    ray.inside = random.below(3) == 0;
    const rays::Facet facet = random_facet(random);
    // A voxel ahead, mostly near; a side that the ray can leave it by.
    glm::ivec3 voxel = rays::voxel_of(ray.origin);
    for (int axis = 0; axis < 3; ++axis) {
      const int steps = random.below(random.below(8) == 0 ? kSide : 3);
      const int sign = (ray.direction[axis] > 0 ? 1 : 0) - (ray.direction[axis] < 0 ? 1 : 0);
      voxel[axis] = std::clamp(voxel[axis] + sign * steps, 0, kSide - 1);
    }
    const int axis = random.below(3);
    if (ray.direction[axis] == 0) continue;
    const rays::Owned owned{voxel, facet, random.below(4) > 0, random.below(128) - 64};
    const Claim claim{static_cast<std::uint32_t>(random.below(kMaxFacets)), owned.core, owned.gap};

    set_ray(unit, ray);
    unit.inside_i = ray.inside ? 1 : 0;
    unit.x_i = static_cast<CData>(voxel.x);
    unit.y_i = static_cast<CData>(voxel.y);
    unit.z_i = static_cast<CData>(voxel.z);
    unit.axis_i = static_cast<CData>(1 << axis);
    unit.owner_i = claim.packed();
    set_fields(unit.optics_i, {{static_cast<int>(facet.body), 2},
                               {facet.normal.x, rays::kNormalBits},
                               {facet.normal.y, rays::kNormalBits},
                               {facet.normal.z, rays::kNormalBits},
                               {facet.mirror, kShareBits},
                               {facet.clear, kShareBits},
                               {facet.enter, kIndexBits},
                               {facet.leave, kIndexBits}});
    unit.clk_i = 0;
    unit.eval();
    unit.clk_i = 1;
    unit.eval();

    const std::int64_t way = rays::exit_distance(ray, axis, voxel[axis]);
    ASSERT_GE(way, 0);
    const auto face = rays::face(ray, owned);
    const bool in_room = facet.body == rays::Body::room && rays::is_in_front(ray, owned, axis, way);
    ASSERT_EQ(unit.seen_o != 0, face.has_value()) << i;
    ASSERT_EQ(unit.in_room_o != 0, in_room) << i;
    ASSERT_EQ(unit.reached_o != 0, face && rays::is_reached(ray, *face, axis, way)) << i;
    ASSERT_EQ(unit.touches_o != 0, face.has_value() || in_room) << i;
    seen += face ? 1 : 0;
    reached += unit.reached_o;
    if (!face && !in_room) continue;
    sides += face ? 0 : 1;
    const rays::Face want = face ? *face : rays::side_face(ray, axis, way);
    const Seen have = unpacked(unit.face_o);
    ASSERT_EQ(have.normal, want.normal) << i;
    ASSERT_EQ(have.height, want.height) << i;
    ASSERT_EQ(have.approach, want.approach) << i;
    ASSERT_EQ(have.is_back, want.is_back) << i;
    ASSERT_EQ(field_of(unit.face_o, 0, kIndexBits, false),
              want.is_back ? facet.leave : facet.enter);
    ASSERT_EQ(field_of(unit.face_o, kIndexBits, 1, false), facet.is_glass() ? 1 : 0);
    ASSERT_EQ(field_of(unit.face_o, kIndexBits + 1, kShareBits, false), facet.clear);
    ASSERT_EQ(field_of(unit.face_o, kIndexBits + 1 + kShareBits, kShareBits, false), facet.mirror);
    ASSERT_EQ(field_of(unit.face_o, kIndexBits + 1 + 2 * kShareBits, kFacetBits, false),
              claim.facet);
  }
  EXPECT_GT(reached, 1000);
  EXPECT_GT(seen, reached);
  EXPECT_GT(sides, 1000);
}

}  // namespace
