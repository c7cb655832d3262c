// rc2_ray_unit against sw/rays: starts, meeting points, mirrored and refracted directions, bit for
// bit, and the cycles that they take.
#include "sw/rays/launch.h"
#include "tb/rtl/ray_ports.h"

namespace {

using namespace rc2;
using namespace rc2::tb;

enum Op : CData { kLaunch, kMeet, kReflect, kRefract };

class RayUnit : public ::testing::Test {
 protected:
  // Returns the cycles.
  int run(Op op) {
    unit_.top.op_i = op;
    unit_.top.start_i = 1;
    unit_.tick();
    unit_.top.start_i = 0;
    int cycles = 1;
    for (unit_.settle(); unit_.top.done_o == 0; ++cycles) unit_.tick();
    unit_.tick();
    return cycles;
  }

  void set_face(const rays::Face& face, int ratio) {
    set_fields(unit_.top.face_i, {{face.normal.x, rays::kNormalBits},
                                  {face.normal.y, rays::kNormalBits},
                                  {face.normal.z, rays::kNormalBits},
                                  {face.height, kHeightBits},
                                  {face.approach, kApproachBits},
                                  {0, 1},
                                  {0, kFacetBits},
                                  {0, kShareBits},
                                  {0, kShareBits},
                                  {0, 1},
                                  {ratio, kIndexBits}});
  }

  // A plane that the ray comes nearer to; true if there is such a one.
  bool random_face(const rays::Ray& ray, rays::Face& face) {
    face.normal = random_facet(random_).normal;
    face.approach = 0;
    for (int axis = 0; axis < 3; ++axis)
      face.approach -= std::int64_t{face.normal[axis]} * ray.direction[axis];
    if (face.approach < 0) {
      face.normal = -face.normal;
      face.approach = -face.approach;
    }
    const std::int64_t highest = (std::int64_t{1} << (kHeightBits - 1)) - 1;
    const std::int64_t size = highest >> random_.below(kHeightBits - 1);
    face.height = static_cast<std::int64_t>(random_.between(-1, 1) * static_cast<double>(size));
    if (random_.below(20) == 0) face.height = highest;
    return face.approach > 0;
  }

  // Of any length up to that of all components one.
  rays::Ray any_ray() {
    rays::Ray ray = random_ray(random_, kSide);
    if (random_.below(4) == 0)
      for (int axis = 0; axis < 3; ++axis)
        ray.direction[axis] = (random_.below(3) - 1) * (1 << rays::direction_fraction(kSide));
    if (ray.direction == glm::ivec3(0)) ray.direction.z = -1;
    // Grazing: nearly at right angles to an axis.
    if (random_.below(4) == 0) ray.direction[random_.below(3)] = random_.below(3) - 1;
    return ray;
  }

  glm::ivec3 bent() const {
    const int width = rays::direction_bits(kSide);
    return {field_of(unit_.top.bx_o, 0, width), field_of(unit_.top.by_o, 0, width),
            field_of(unit_.top.bz_o, 0, width)};
  }

  Clocked<Vtop> unit_;
  scene::Random random_{1};
};

constexpr int kRounds = 4000;
constexpr int kBendBits = rays::direction_fraction(kSide) + 5;
constexpr int kRootBits = rays::direction_fraction(kSide) + 11;

TEST_F(RayUnit, Launches) {
  const int rise = rays::slope_bits(kSide);
  const int bits = rays::slope_fraction(kSide) + coordinate_bits(kSide) + 8;
  for (int i = 0; i < kRounds; ++i) {
    const rays::Ray ray = any_ray();
    set_ray(unit_.top, ray);
    ASSERT_EQ(run(kLaunch), 2 * (1 + bits) + 4);
    const rays::Launch want = rays::launch(ray, kSide);
    const rays::Launch have{
        field_of(unit_.top.decision_o, 0, rays::decision_bits(kSide)),
        field_of(unit_.top.exit_x_o, 0, rise), field_of(unit_.top.exit_y_o, 0, rise),
        field_of(unit_.top.slope_x_o, 0, rise), field_of(unit_.top.slope_y_o, 0, rise)};
    ASSERT_EQ(have.decision, want.decision) << i;
    ASSERT_EQ(have.exit_x, want.exit_x) << i;
    ASSERT_EQ(have.exit_y, want.exit_y) << i;
    ASSERT_EQ(have.slope_x, want.slope_x) << i;
    ASSERT_EQ(have.slope_y, want.slope_y) << i;
  }
}

TEST_F(RayUnit, FindsWhereARayMeetsAPlane) {
  const int place = rays::place_bits(kSide);
  int inside = 0;
  for (int i = 0; i < kRounds; ++i) {
    const rays::Ray ray = any_ray();
    rays::Face face{};
    if (!random_face(ray, face)) continue;
    const glm::ivec3 voxel(random_.below(kSide), random_.below(kSide), random_.below(kSide));
    set_ray(unit_.top, ray);
    set_face(face, 0);
    unit_.top.vx_i = static_cast<CData>(voxel.x);
    unit_.top.vy_i = static_cast<CData>(voxel.y);
    unit_.top.vz_i = static_cast<CData>(voxel.z);
    ASSERT_EQ(run(kMeet), 1 + rays::meeting_bits(kSide) + 3);
    const glm::ivec3 free = rays::meeting_point(ray, face, kSide);
    const glm::ivec3 want = rays::clamp_to_voxel(free, voxel, 1);
    const glm::ivec3 have(field_of(unit_.top.px_o, 0, place), field_of(unit_.top.py_o, 0, place),
                          field_of(unit_.top.pz_o, 0, place));
    ASSERT_EQ(have, want) << i;
    for (int axis = 0; axis < 3; ++axis) inside += want[axis] == free[axis] ? 1 : 0;
  }
  EXPECT_GT(inside, kRounds / 50) << "not all are moved";
}

TEST_F(RayUnit, Reflects) {
  for (int i = 0; i < kRounds; ++i) {
    const rays::Ray ray = any_ray();
    rays::Face face{};
    if (!random_face(ray, face)) continue;
    set_ray(unit_.top, ray);
    set_face(face, 0);
    ASSERT_EQ(run(kReflect), 3 + 1 + kBendBits + 3);
    ASSERT_EQ(bent(), rays::reflect(ray.direction, face, kSide)) << i;
  }
}

TEST_F(RayUnit, RefractsOrReflectsAll) {
  int none = 0;
  for (int i = 0; i < kRounds; ++i) {
    const rays::Ray ray = any_ray();
    rays::Face face{};
    if (!random_face(ray, face)) continue;
    const int ratio = random_.below(rays::kMaxIndex * rays::kIndexOne + 1);
    set_ray(unit_.top, ray);
    set_face(face, ratio);
    const int cycles = run(kRefract);
    const auto want = rays::refract(ray.direction, face, ratio, kSide);
    ASSERT_EQ(unit_.top.none_o == 0, want.has_value()) << i;
    ASSERT_EQ(cycles, want ? 3 + 1 + kBendBits + 3 + 1 + kRootBits + 7 : 6);
    if (want) {
      ASSERT_EQ(bent(), *want) << i;
    } else {
      ++none;
    }
  }
  EXPECT_GT(none, kRounds / 50);
  EXPECT_LT(none, kRounds - kRounds / 50);
}

}  // namespace
