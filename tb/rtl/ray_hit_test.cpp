// rc2_ray_hit against sw/rays: where a ray meets a plane and what it sends on, mirrored and
// refracted, bit for bit, and in how many cycles, one after another and each alone.
#include <deque>

#include "sw/cycle/ray_timing.h"
#include "tb/rtl/ray_ports.h"

namespace {

using namespace rc2;
using namespace rc2::tb;

constexpr int kRounds = 6000;

// A ray that has stopped, and what is to come of it.
struct Stop {
  rays::Ray ray;
  rays::Facet facet;
  rays::Face face;
  glm::ivec3 voxel, here;
  bool escaped;

  int ratio() const { return face.is_back ? facet.leave : facet.enter; }
  rays::Limits limits() const { return {RC2_RAY_DEPTH, 16}; }
  glm::ivec3 point() const {
    return rays::clamp_to_voxel(rays::meeting_point(ray, face, kSide), voxel, 1);
  }
  rays::Split split() const {
    return rays::split(ray, facet, face, rays::clamp_to_voxel(point(), here), limits(), kSide);
  }
  bool is_refracted() const {
    return facet.is_glass() && rays::refract(ray.direction, face, ratio(), kSide).has_value();
  }
  int meet_cycles() const {
    return escaped ? cycle::ray_timing::kNothing : cycle::ray_timing::meet(kSide, is_refracted());
  }
  int bend_cycles() const {
    const rays::Split sent = split();
    const bool bends = sent.reflected || (facet.is_glass() && sent.refracted);
    return !escaped && bends ? cycle::ray_timing::bend(kSide) : cycle::ray_timing::kNothing;
  }
};

class RayHit : public ::testing::Test {
 protected:
  RayHit() {
    set_fields(unit_.top.limits_i, {{RC2_RAY_DEPTH, 3}, {16, kWeightBits}, {1, 2}});
    unit_.top.free_i = 1;
  }

  // A plane that the ray comes nearer to; true if there is such a one.
  bool random_face(Stop& stop) {
    rays::Face& face = stop.face;
    face = {stop.facet.normal, 0, 0, random_.below(2) == 0};
    for (int axis = 0; axis < 3; ++axis)
      face.approach -= std::int64_t{face.normal[axis]} * stop.ray.direction[axis];
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

  Stop random_stop() {
    Stop stop{};
    do {
      stop.ray = any_ray(random_);
      stop.facet = random_facet(random_);
    } while (!random_face(stop));
    stop.ray.node = static_cast<std::uint8_t>(1 + random_.below((2 << RC2_RAY_DEPTH) - 1));
    stop.ray.weight = static_cast<std::uint16_t>(random_.below(rays::kWeightOne + 1));
    stop.ray.inside = random_.below(2) == 0;
    stop.voxel = {random_.below(kSide), random_.below(kSide), random_.below(kSide)};
    stop.here = {random_.below(kSide), random_.below(kSide), random_.below(kSide)};
    stop.escaped = random_.below(10) == 0;
    return stop;
  }

  void offer(const Stop& stop) {
    const int at = coordinate_bits(kSide);
    std::vector<Field> fields = start_fields(stop.ray);
    fields.insert(fields.end(), {{stop.escaped ? 1 : 0, 1},
                                 {0, 1},
                                 {stop.here.x, at},
                                 {stop.here.y, at},
                                 {stop.here.z, at},
                                 {stop.voxel.x, at},
                                 {stop.voxel.y, at},
                                 {stop.voxel.z, at}});
    const rays::Face& face = stop.face;
    fields.insert(fields.end(), {{face.normal.x, rays::kNormalBits},
                                 {face.normal.y, rays::kNormalBits},
                                 {face.normal.z, rays::kNormalBits},
                                 {face.height, kHeightBits},
                                 {face.approach, kApproachBits},
                                 {face.is_back ? 1 : 0, 1},
                                 {0, kFacetBits},
                                 {stop.facet.mirror, kShareBits},
                                 {stop.facet.clear, kShareBits},
                                 {stop.facet.is_glass() ? 1 : 0, 1},
                                 {stop.ratio(), kIndexBits}});
    set_fields(unit_.top.stop_ray_i, fields);
    unit_.top.stop_i = 1;
    unit_.settle();
  }

  // Of the answer, its lowest fields first.
  void check_child(FieldsFromBelow& fields, const std::optional<rays::Ray>& want, bool is_cleared) {
    const glm::ivec3 direction = take_place(fields, rays::direction_bits(kSide));
    const std::int64_t weight = fields.take(kWeightBits, false);
    const std::int64_t inside = is_cleared ? fields.take(1, false) : 0;
    ASSERT_EQ(fields.take(1, false) != 0, want.has_value());
    if (!want) return;
    ASSERT_EQ(direction, want->direction);
    ASSERT_EQ(weight, want->weight);
    if (is_cleared) ASSERT_EQ(inside != 0, want->inside);
  }

  void check(const Stop& stop) {
    const rays::Split want = stop.escaped ? rays::Split{} : stop.split();
    FieldsFromBelow fields(unit_.top.answer_ray_o);
    check_child(fields, want.refracted, true);
    check_child(fields, want.reflected, false);
    const glm::ivec3 start = take_place(fields, rays::place_bits(kSide));
    if (stop.escaped) return;
    ASSERT_EQ(start, rays::clamp_to_voxel(stop.point(), stop.here));
    ASSERT_EQ(fields.take(2, false), want.too_deep);
    ASSERT_EQ(fields.take(2, false), want.too_light);
    ASSERT_EQ(take_place(fields, rays::place_bits(kSide)), stop.point());
  }

  Clocked<Vtop> unit_;
  scene::Random random_{1};
};

TEST_F(RayHit, SendsOnWhatIsMirroredAndRefractedInTime) {
  int refracted = 0, all_back = 0, mirrored = 0, moved = 0;
  for (int i = 0; i < kRounds; ++i) {
    SCOPED_TRACE(i);
    const Stop stop = random_stop();
    offer(stop);
    ASSERT_EQ(unit_.top.taken_o, 1);
    int cycles = 0, work = 0;
    for (; unit_.top.answer_o == 0; ++cycles) {
      work += unit_.top.work_o;
      unit_.tick();
      unit_.top.stop_i = 0;
      unit_.settle();
    }
    ASSERT_EQ(cycles, stop.meet_cycles() + stop.bend_cycles());
    ASSERT_EQ(work, stop.meet_cycles());
    check(stop);
    unit_.tick();
    if (stop.escaped) continue;
    const rays::Split sent = stop.split();
    mirrored += sent.reflected.has_value() ? 1 : 0;
    refracted += stop.facet.is_glass() && sent.refracted.has_value() ? 1 : 0;
    all_back += stop.facet.is_glass() && !stop.is_refracted() ? 1 : 0;
    moved += stop.point() != rays::meeting_point(stop.ray, stop.face, kSide) ? 1 : 0;
  }
  for (const int some : {refracted, all_back, mirrored, moved}) {
    EXPECT_GT(some, kRounds / 50);
    EXPECT_LT(some, kRounds - kRounds / 50);
  }
}

// A ray in each stage, and the last of them held up at times.
TEST_F(RayHit, TakesTheNextWhileOneBends) {
  std::deque<Stop> inside;
  Stop next = random_stop();
  int cycle = 0, free_from = 0, most = 0;
  for (int done = 0; done < kRounds / 10; ++cycle) {
    SCOPED_TRACE(cycle);
    unit_.top.free_i = random_.below(20) != 0 ? 1 : 0;
    offer(next);
    if (unit_.top.answer_o != 0 && unit_.top.free_i != 0) {
      check(inside.front());
      inside.pop_front();
      ++done;
    }
    if (unit_.top.taken_o != 0) {
      ASSERT_GE(cycle, free_from) << "the first stage takes one at a time";
      free_from = cycle + next.meet_cycles();
      inside.push_back(next);
      next = random_stop();
    }
    most = std::max(most, static_cast<int>(inside.size()));
    unit_.tick();
  }
  EXPECT_EQ(most, 2);
}

}  // namespace
