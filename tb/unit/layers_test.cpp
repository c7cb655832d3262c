// The batches of build_layers, read by an interpreter that looks at every voxel of every box.
#include "sw/facet/layers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "sw/base/config.h"
#include "sw/facet/opposed.h"
#include "sw/facet/optics.h"
#include "sw/machine/checks.h"
#include "sw/machine/claim.h"
#include "sw/scene/random.h"
#include "sw/scene/shapes.h"
#include "sw/surface/closed_meshes.h"
#include "sw/surface/mesh.h"
#include "sw/surface/voxel_array.h"
#include "sw/surface/winding.h"
#include "tb/load/dice.h"
#include "tb/unit/voxel_set.h"

namespace rc2::facet {
namespace {

using scene::Random;
using scene::Scene;
using Set = surface::VoxelSet;

template <class Visit>
void for_each_voxel(const glm::ivec3& lo, const glm::ivec3& hi, const Visit& visit) {
  for (int z = lo.z; z <= hi.z; ++z)
    for (int y = lo.y; y <= hi.y; ++y)
      for (int x = lo.x; x <= hi.x; ++x) visit(glm::ivec3(x, y, z));
}

template <class Visit>
void for_each_filled(const PacketStream& stream, const PacketHead& head, const Visit& visit) {
  for_each_voxel(head.lo, head.hi, [&](const glm::ivec3& p) {
    if (is_inside(stream, head, p)) visit(p);
  });
}

std::uint32_t claim_of(const PacketStream& stream, const PacketHead& head, const glm::ivec3& p,
                       int n) {
  const glm::ivec3 at = p - head.lo;
  bool core = true;
  for (std::uint32_t i = 0; i < head.side_count; ++i) {
    const Side& side = stream.sides[head.first_side + i];
    core = core && value_at(side.value, at) >= side.push;
  }
  return Claim{head.facet, core, gap_of(n, value_at(head.gap, at))}.packed();
}

// A machine as sw/facet/packet.h describes it.
class Machine {
 public:
  Machine(const PacketStream& stream, int n)
      : armour(n), shown(n), guard(n), inside(n), n_(n), owner_(n), parity_(n) {
    for (const Batch& batch : stream.batches) {
      for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i)
        obey(stream, stream.heads[i]);
      if (batch.ends_object) end_object();
    }
  }

  Set armour, shown, guard, inside;

 private:
  void obey(const PacketStream& stream, const PacketHead& head) {
    switch (head.layer) {
      case Layer::armour:
        for_each_filled(stream, head, [&](const glm::ivec3& p) {
          const std::uint32_t claim = claim_of(stream, head, p, n_);
          owner_[p] = armour[p] != 0 ? std::min(owner_[p], claim) : claim;
          armour[p] = 1;
        });
        break;
      case Layer::shown:
        for_each_filled(stream, head, [&](const glm::ivec3& p) { shown[p] = 1; });
        break;
      case Layer::guard:
        for_each_filled(stream, head, [&](const glm::ivec3& p) {
          if (armour[p] == 0) guard[p] = 1;
        });
        break;
      case Layer::inside:
        flip(stream, head);
        break;
    }
  }

  void flip(const PacketStream& stream, PacketHead head) {
    head.slab.width = INT64_MAX;
    for (int y = head.lo.y; y <= head.hi.y; ++y) {
      for (int x = head.lo.x; x <= head.hi.x; ++x) {
        bool above = false;
        for (int z = head.lo.z; z < n_; ++z) {
          above = above || is_inside(stream, head, {x, y, z});
          if (above) parity_[{x, y, z}] ^= 1;
        }
      }
    }
  }

  void end_object() {
    for_each_voxel(glm::ivec3(0), glm::ivec3(n_ - 1), [&](const glm::ivec3& p) {
      inside[p] |= parity_[p];
      parity_[p] = 0;
    });
  }

  int n_;
  surface::VoxelArray<std::uint32_t> owner_;
  Set parity_;
};

int difference(const Set& a, const Set& b) {
  return static_cast<int>(
      std::inner_product(a.begin(), a.end(), b.begin(), 0, std::plus<>(), std::not_equal_to<>()));
}

int count(const Set& set) { return static_cast<int>(std::count(set.begin(), set.end(), 1)); }

bool has_layer(const PacketStream& stream, Layer layer) {
  return std::any_of(stream.heads.begin(), stream.heads.end(),
                     [&](const PacketHead& head) { return head.layer == layer; });
}

// Voxels that the mesh goes round.
Set enclosed(const Scene& scene, int n, int fraction_bits) {
  const auto winding = surface::winding_numbers(surface::quantise(scene, fraction_bits), n);
  Set result(n);
  for_each_voxel(glm::ivec3(0), glm::ivec3(n - 1),
                 [&](const glm::ivec3& p) { result[p] = winding[p] != 0 ? 1 : 0; });
  return result;
}

Set inside(const Scene& scene, int n, int fraction_bits) {
  return Machine(build_layers(scene, n, fraction_bits).packets, n).inside;
}

Scene family_mesh(const surface::MeshFamily& family, std::uint64_t seed, int n) {
  Scene scene = surface::make_mesh(family, seed);
  for (glm::dvec3& v : scene.vertices) v *= (n - 1.0) / (family.n - 1.0);
  return scene;
}

Scene empty_scene() {
  Scene scene;
  scene.name = "test";
  scene.materials.resize(1);
  return scene;
}

void add_box(Scene& scene, const glm::dvec3& low, const glm::dvec3& high, bool inwards = false) {
  scene::add_box(scene, {0.5 * (low + high), 0.5 * (high - low)}, 0, inwards);
}

void append(Scene& scene, const Scene& other) {
  for (std::size_t i = 0; i < other.polygon_count(); ++i)
    scene.add({&other.vertices[other.first[i]], &other.vertices[other.first[i + 1]]}, 0);
}

Scene without(const Scene& scene, std::size_t polygon) {
  Scene result = empty_scene();
  for (std::size_t i = 0; i < scene.polygon_count(); ++i)
    if (i != polygon)
      result.add({&scene.vertices[scene.first[i]], &scene.vertices[scene.first[i + 1]]}, 0);
  return result;
}

Scene inside_out(Scene scene) {
  for (std::size_t i = 0; i < scene.polygon_count(); ++i)
    std::reverse(&scene.vertices[scene.first[i]], &scene.vertices[scene.first[i + 1]]);
  return scene;
}

// Meshes of all families in cubes from 8 to 48 and with all fraction bits.
template <class Visit>
void for_each_mesh(int seeds, const Visit& visit) {
  for (const surface::MeshFamily& family : surface::kMeshFamilies) {
    for (int seed = 0; seed < seeds; ++seed) {
      const int n = 8 + (seed * 19 + 7 * family.name[0]) % 41, fraction_bits = seed % 9;
      SCOPED_TRACE(fmt::format("{} {} n {} f {}", family.name, seed, n, fraction_bits));
      visit(family_mesh(family, static_cast<std::uint64_t>(seed), n), n, fraction_bits);
    }
  }
}

TEST(Layers, ArmourAndShownAreTheFacetsByTheirRules) {
  for_each_mesh(9, [](const Scene& scene, int n, int fraction_bits) {
    const FacetSet layers = build_layers(scene, n, fraction_bits);
    const Machine machine(layers.packets, n);
    for (const auto& [rule, set] :
         {std::pair(Rule::armoured, &machine.armour), std::pair(Rule::naive, &machine.shown)}) {
      FacetSet facets = build_facets(scene, n, fraction_bits, rule);
      EXPECT_EQ(layers.counts.loaded, facets.counts.loaded);
      facets.packets.batches = {
          {0, static_cast<std::uint32_t>(facets.packets.heads.size()), false}};
      EXPECT_EQ(difference(*set, Machine(facets.packets, n).armour), 0) << to_string(rule);
    }
  });
}

TEST(Layers, EachFacetHasItsNumberInEveryLayer) {
  for_each_mesh(2, [](const Scene& scene, int n, int fraction_bits) {
    const FacetSet set = build_layers(scene, n, fraction_bits);
    const std::size_t facets = set.facets.size();
    const std::vector<PacketHead>& heads = set.packets.heads;
    ASSERT_GE(set.packets.batches.size(), 2U);
    std::uint32_t next = 0;
    for (const Batch& batch : set.packets.batches) {
      EXPECT_EQ(batch.first, next);
      EXPECT_EQ(batch.ends_object, heads[batch.first].layer == Layer::inside);
      for (next = batch.first; next < batch.first + batch.count; ++next)
        EXPECT_EQ(heads[next].layer, heads[batch.first].layer);
    }
    EXPECT_EQ(next, heads.size());
    for (const PacketHead& head : heads) {
      ASSERT_LT(head.facet, facets);
      if (head.layer != Layer::guard) continue;
      EXPECT_EQ(head.surface, heads[head.facet].surface);
    }
    for (std::size_t i = 0; i < facets; ++i) {
      EXPECT_EQ(heads[i].facet, i);
      EXPECT_EQ(heads[facets + i].facet, i);
      EXPECT_EQ(heads[facets + i].layer, Layer::shown);
    }
  });
}

TEST(Layers, FacingKeepsTheSignsOfLargeComponents) {
  Dice dice(1);
  for (int trial = 0; trial < 2000; ++trial) {
    Vertex normal;
    for (int axis = 0; axis < 3; ++axis) normal[axis] = dice.roll(-15, 15);
    if (normal == Vertex(0)) continue;
    const glm::i64vec3 size = glm::abs(normal);
    const std::int64_t largest = std::max({size.x, size.y, size.z});
    int code = 0;
    for (int axis = 0; axis < 3; ++axis)
      code = 3 * code + 1 + (size[axis] * 12 >= largest * 5 ? (normal[axis] > 0 ? 1 : -1) : 0);
    EXPECT_EQ(facing(normal), code);
    EXPECT_EQ(facing(-normal), 26 - code);
  }
}

TEST(Layers, InsideIsWhereAClosedMeshGoesRound) {
  int voxels = 0;
  for_each_mesh(27, [&](const Scene& scene, int n, int fraction_bits) {
    const FacetSet set = build_layers(scene, n, fraction_bits);
    const Set expected = enclosed(scene, n, fraction_bits);
    EXPECT_EQ(difference(Machine(set.packets, n).inside, expected), 0);
    EXPECT_EQ(set.counts.objects_open, 0);
    voxels += count(expected);
  });
  EXPECT_GT(voxels, 100'000);
}

// Debian's assimp-testmodels; the engine's parts overlap and share sides.
TEST(Layers, InsideIsWhereAModelGoesRoundAnOddNumberOfTimes) {
  for (const char* name :
       {"Collada/duck.dae", "BLEND/HUMAN.blend", "LWO/LXOB_Modo/CrazyEngine.lxo"}) {
    const int n = 48, fraction_bits = 4;
    Scene scene = scene::read_file(std::string("/usr/share/assimp/models/") + name);
    scene::fit_to_cube(scene, n);
    const FacetSet set = build_layers(scene, n, fraction_bits);
    EXPECT_EQ(set.counts.objects_open, 0) << name;
    const Machine machine(set.packets, n);
    const auto winding = surface::winding_numbers(surface::quantise(scene, fraction_bits), n);
    for_each_voxel(glm::ivec3(0), glm::ivec3(n - 1), [&](const glm::ivec3& p) {
      if (winding[p] == 0 || winding[p] % 2 != 0) {
        EXPECT_EQ(machine.inside[p], winding[p] != 0 ? 1 : 0) << name;
      }
    });
  }
}

TEST(Layers, OrderWithinABatchDoesNotMatter) {
  Dice dice(2);
  for_each_mesh(2, [&](const Scene& scene, int n, int fraction_bits) {
    PacketStream stream = build_layers(scene, n, fraction_bits).packets;
    const Machine before(stream, n);
    for (const Batch& batch : stream.batches)
      dice.shuffle(stream.heads.begin() + batch.first,
                   stream.heads.begin() + batch.first + batch.count);
    const Machine after(stream, n);
    EXPECT_EQ(difference(before.guard, after.guard), 0);
    EXPECT_EQ(difference(before.inside, after.inside), 0);
  });
}

TEST(Layers, SolidsThatOverlapStaySolid) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const int n = 24;
    Scene scene = empty_scene();
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 centre{random.between(8, 15), random.between(8, 15), random.between(8, 15)};
      const glm::dvec3 half{random.between(2, 4), random.between(2, 4), random.between(2, 4)};
      scene::add_box(scene, {centre, half, scene::random_rotation(random)}, 0);
    }
    const FacetSet set = build_layers(scene, n, 4);
    EXPECT_EQ(set.counts.objects_closed, 3);
    EXPECT_EQ(difference(Machine(set.packets, n).inside, enclosed(scene, n, 4)), 0);
  }
}

TEST(Layers, SolidsThatOverlapAndShareAnEdgeStaySolid) {
  Scene scene = empty_scene();
  add_box(scene, {1, 1, 1}, {14, 3.5, 8});
  add_box(scene, {1, 1, 1}, {3.5, 14, 8});
  const FacetSet set = build_layers(scene, 16, 2);
  EXPECT_EQ(set.counts.objects_closed, 2);
  EXPECT_EQ(difference(Machine(set.packets, 16).inside, enclosed(scene, 16, 2)), 0);
}

TEST(Layers, SolidsThatShareAFaceAreSolid) {
  Scene scene = empty_scene();
  add_box(scene, {1, 1, 1}, {8, 8, 8});
  add_box(scene, {1, 1, 8}, {8, 8, 14});
  EXPECT_EQ(difference(inside(scene, 16, 2), enclosed(scene, 16, 2)), 0);
}

TEST(Layers, ASolidThatIsThereTwiceIsSolid) {
  for (const int copies : {2, 3, 4}) {
    Scene scene = empty_scene();
    for (int i = 0; i < copies; ++i) add_box(scene, {1, 1, 1}, {8, 8, 8});
    const FacetSet set = build_layers(scene, 16, 2);
    EXPECT_EQ(set.counts.objects_closed, 1);
    EXPECT_EQ(difference(Machine(set.packets, 16).inside, enclosed(scene, 16, 2)), 0) << copies;
  }
}

// Boxes one in the other, all ways to turn those in the first one inside out.
TEST(Layers, NestedShellsEncloseWhatTheMeshGoesRound) {
  const int n = 24, levels = 5;
  for (int turned = 0; turned < 1 << levels; turned += 2) {
    Scene scene = empty_scene();
    for (int i = levels - 1; i >= 0; --i)  // the innermost first
      scene::add_box(scene, {glm::dvec3(11.3), glm::dvec3(10 - 2 * i)}, 0, (turned >> i & 1) != 0);
    EXPECT_EQ(difference(inside(scene, n, 4), enclosed(scene, n, 4)), 0) << turned;
  }
}

TEST(Layers, ACavityBelongsToTheSolidThatItIsIn) {
  const int n = 32;
  Scene scene = empty_scene();
  add_box(scene, {1, 1, 1}, {30, 30, 30});
  add_box(scene, {2, 2, 2}, {15, 29, 29}, true);
  add_box(scene, {17, 2, 2}, {29, 29, 29}, true);
  add_box(scene, {4, 4, 4}, {13, 13, 13});  // in the first: a solid in a solid
  add_box(scene, {6, 6, 6}, {11, 11, 11});
  add_box(scene, {19, 4, 4}, {27, 27, 27});  // in the second: a hollow solid
  add_box(scene, {21, 6, 6}, {25, 25, 25}, true);
  const FacetSet set = build_layers(scene, n, 0);
  EXPECT_EQ(set.counts.objects_closed, 4);
  EXPECT_EQ(difference(Machine(set.packets, n).inside, enclosed(scene, n, 0)), 0);
}

TEST(Layers, SolidsTurnedInsideOutAreSolid) {
  for_each_mesh(9, [](const Scene& scene, int n, int fraction_bits) {
    const Scene turned = inside_out(scene);
    EXPECT_EQ(difference(inside(turned, n, fraction_bits), enclosed(turned, n, fraction_bits)), 0);
  });
}

TEST(Layers, ASolidTurnedInsideOutThatSticksInAnotherIsNoCavity) {
  Scene scene = empty_scene(), upright = empty_scene();
  for (Scene* s : {&scene, &upright}) {
    add_box(*s, {2, 2, 2}, {12, 12, 12});
    add_box(*s, {8, 4, 4}, {15, 9, 9}, s == &scene);
  }
  EXPECT_EQ(difference(inside(scene, 17, 3), enclosed(upright, 17, 3)), 0);
}

TEST(Layers, ARoomIsFullOfAirAndWhatIsInItIsSolid) {
  const int n = 24;
  Scene things = empty_scene();
  add_box(things, {3, 3, 3}, {9, 9, 9});
  add_box(things, {7, 7, 7}, {14, 14, 14});
  scene::add_sphere(things, {16, 8, 8}, 4, 1, 0);
  Scene room = things;
  add_box(room, glm::dvec3(1), glm::dvec3(22), true);
  const FacetSet set = build_layers(room, n, 4);
  EXPECT_EQ(set.counts.rooms, 1);
  EXPECT_EQ(set.counts.objects_closed, 3);
  EXPECT_EQ(difference(Machine(set.packets, n).inside, enclosed(things, n, 4)), 0);
}

TEST(Layers, RaysAreToldWhatAFacetBelongsTo) {
  Scene scene = empty_scene();
  add_box(scene, {3, 3, 3}, {9, 9, 9});
  add_box(scene, glm::dvec3(1), glm::dvec3(22), true);
  scene.add({{12, 12, 12}, {18, 12, 12}, {12, 18, 12}}, 0);
  const FacetSet set = build_layers(scene, 24, 4);
  ASSERT_EQ(set.facets.size(), 13U);
  for (const FacetInfo& facet : set.facets)
    EXPECT_EQ(facet.body, facet.polygon < 6    ? rays::Body::solid
                          : facet.polygon < 12 ? rays::Body::room
                                               : rays::Body::sheet);
}

TEST(Optics, RoundsNormalsAndShares) {
  EXPECT_EQ(slope_form({0, 0, -7}), glm::ivec3(0, 0, -rays::kNormalOne));
  EXPECT_EQ(slope_form({-3, 3, 1}), glm::ivec3(-1024, 1024, 341));
  EXPECT_EQ(slope_form({2048, 1, -3}), glm::ivec3(1024, 1, -1));
  FacetInfo facet{{}, 0, {{0, 5, 0}, 0}};
  facet.body = rays::Body::room;
  scene::Material material;
  material.mirror = 0.75F;
  material.transparency = 0.5F;
  material.refractive_index = 1.5F;
  const rays::Facet found = find_optics({facet}, {material}).front();
  EXPECT_EQ(found.mirror, 192);
  EXPECT_EQ(found.clear, 64) << "there is no more left";
  EXPECT_EQ(found.enter, 2731);
  EXPECT_EQ(found.leave, 6144);
  EXPECT_EQ(found.body, rays::Body::room);
  material.refractive_index = 1e9F;
  EXPECT_EQ(find_optics({facet}, {material}).front().leave, rays::kMaxIndex * rays::kIndexOne);
}

TEST(Layers, ASolidMayReachTheBorderOfTheCube) {
  Scene scene = empty_scene();
  add_box(scene, glm::dvec3(-0.5), glm::dvec3(7.5));
  const FacetSet set = build_layers(scene, 8, 1);
  EXPECT_EQ(set.counts.objects_closed, 1);
  EXPECT_EQ(count(Machine(set.packets, 8).inside), 8 * 8 * 8);
  EXPECT_EQ(set.counts.outside, 3);  // the lower sides: half-open
  std::set<std::uint32_t> numbers;
  for (const PacketHead& head : set.packets.heads)
    if (head.layer == Layer::inside) numbers.insert(head.facet);
  EXPECT_EQ(numbers.size(), 2U);
  EXPECT_GE(*numbers.rbegin(), set.facets.size());  // the bottom has no voxel and no number
  check_packets({8, 1, 1, 1}, set.packets);
}

TEST(Layers, OpenSurfacesHaveNoInside) {
  Scene box = empty_scene();
  add_box(box, {2, 3, 2}, {11, 12, 11});
  for (std::size_t polygon = 0; polygon < 6; ++polygon) {
    const FacetSet set = build_layers(without(box, polygon), 16, 2);
    EXPECT_EQ(set.counts.objects_open, 1);
    EXPECT_EQ(count(Machine(set.packets, 16).inside), 0);
  }
}

// A cap over a missing triangle lies in its plane, but for the rounding of its middle.
TEST(Layers, SmallHolesAreCapped) {
  const int n = 32;
  Scene sphere = empty_scene();
  scene::add_sphere(sphere, glm::dvec3(15.3), 13, 2, 0);
  const Set whole = inside(sphere, n, 6);
  for (const std::size_t polygon : {0, 77, 300}) {
    const FacetSet set = build_layers(without(without(sphere, polygon), polygon + 9), n, 6);
    EXPECT_EQ(set.counts.objects_closed, 1);
    EXPECT_EQ(set.counts.objects_capped, 1);
    EXPECT_EQ(set.counts.objects_open, 0);
    EXPECT_LE(difference(Machine(set.packets, n).inside, whole), 2);
  }
}

TEST(Layers, AnOpenSurfaceLeavesOtherSolidsAlone) {
  Scene solid = empty_scene(), other = empty_scene();
  add_box(solid, {2, 2, 2}, {7, 7, 7});
  add_box(other, {5, 5, 5}, {12, 12, 12});
  Scene both = without(other, 3);
  append(both, solid);
  const FacetSet set = build_layers(both, 16, 3);
  EXPECT_EQ(set.counts.objects_closed, 1);
  EXPECT_EQ(set.counts.objects_open, 1);
  EXPECT_EQ(difference(Machine(set.packets, 16).inside, enclosed(solid, 16, 3)), 0);
}

// The walls of a tower are cut where it leaves the cube, so nearly there that the lower half rounds
// to the border and no polygon crosses it.
TEST(Layers, ASolidPartlyOutsideTheCubeHasNoInside) {
  const int n = 8;
  const double border = n - 0.5;
  Scene scene = empty_scene();
  add_box(scene, {1, 1, 1}, {6, 6, border});
  add_box(scene, {1, 1, border}, {6, 6, n + 3});
  for (std::size_t i = scene.polygon_count(); i-- > 0;) {
    const glm::dvec3* first = &scene.vertices[scene.first[i]];
    if (std::all_of(first, first + 4, [&](const glm::dvec3& v) { return v.z == border; }))
      scene = without(scene, i);
  }
  for (glm::dvec3& v : scene.vertices)
    if (v.z == border) v.z += 1e-9;
  const FacetSet set = build_layers(scene, n, 1);
  EXPECT_EQ(set.counts.outside, 5);
  EXPECT_EQ(set.counts.objects_closed, 0);
  EXPECT_EQ(set.counts.objects_open, 1);
  EXPECT_FALSE(has_layer(set.packets, Layer::inside));
}

// Packets that share a voxel with one that faces the opposite way.
std::set<std::uint32_t> opposed_by_voxels(const PacketStream& stream, int n) {
  surface::VoxelArray<std::vector<std::uint32_t>> fillers(n);
  for (std::uint32_t i = 0; i < stream.heads.size(); ++i)
    for_each_filled(stream, stream.heads[i], [&](const glm::ivec3& p) { fillers[p].push_back(i); });
  const auto facing_of = [&](std::uint32_t i) {
    const Linear& plane = stream.heads[i].slab.value;
    return facing({plane.a, plane.b, plane.c});
  };
  std::set<std::uint32_t> result;
  for_each_voxel(glm::ivec3(0), glm::ivec3(n - 1), [&](const glm::ivec3& p) {
    for (const std::uint32_t i : fillers[p])
      for (const std::uint32_t k : fillers[p])
        if (facing_of(i) + facing_of(k) == 26) result.insert(i);
  });
  return result;
}

TEST(Layers, NoOpposedFacetsAreMissed) {
  Random random(4);
  std::size_t found = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const int n = 4 + trial, fraction_bits = trial % 9;
    Scene scene = empty_scene();
    for (int i = 0; i < 60; ++i) {
      std::vector<glm::dvec3> corners(3);
      const double size = i < 10 ? n : 0.3 * n;
      const glm::dvec3 at{random.between(0, n - size), random.between(0, n - size),
                          random.between(0, n - size)};
      for (glm::dvec3& v : corners)
        v = at +
            glm::dvec3{random.between(0, size), random.between(0, size), random.between(0, size)};
      for (glm::dvec3& v : corners) v = glm::min(v, glm::dvec3(n - 1));
      scene.add(corners, 0);
    }
    const PacketStream stream = build_facets(scene, n, fraction_bits, Rule::armoured).packets;
    const std::vector<std::uint32_t> opposed = find_opposed(stream.heads);
    for (const std::uint32_t i : opposed_by_voxels(stream, n)) {
      EXPECT_TRUE(std::binary_search(opposed.begin(), opposed.end(), i));
      ++found;
    }
  }
  EXPECT_GT(found, 150U);
}

TEST(Layers, APlateIsGuardedAndAThickBoxIsNot) {
  for (int axis = 0; axis < 3; ++axis) {
    Scene plate = empty_scene(), box = empty_scene();
    glm::dvec3 half(8), middle(15.2);
    half[axis] = 0.25;
    add_box(plate, middle - half, middle + half);
    half[axis] = 3;
    add_box(box, middle - half, middle + half);
    const Machine machine(build_layers(plate, 32, 4).packets, 32);
    // Its sides are half a voxel from the middle: a step beyond either is all that is guarded.
    for_each_voxel(glm::ivec3(9), glm::ivec3(21), [&](const glm::ivec3& p) {
      const bool is_near = std::abs(p[axis] - middle[axis]) <= 1.25;
      EXPECT_EQ(machine.guard[p], is_near && machine.armour[p] == 0);
    });
    EXPECT_FALSE(has_layer(build_layers(box, 32, 4).packets, Layer::guard));
  }
}

// A triangle on its own is a sheet. Everything in integers: twice a height against twice S and K.
TEST(Layers, AGuardIsWhereOneStepThroughASheetCanEnd) {
  Dice dice(9);
  int guards = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 24, fraction_bits = static_cast<int>(dice.roll(0, 4));
    const std::int64_t one = std::int64_t{1} << fraction_bits;
    Border border(3);
    for (Vertex& v : border)
      for (int axis = 0; axis < 3; ++axis) v[axis] = dice.roll(0, (n - 1) * one);
    const Vertex normal = cross(border[1] - border[0], border[2] - border[0]);
    const glm::i64vec3 size = glm::abs(normal);
    const std::int64_t sum = size.x + size.y + size.z, large = std::max({size.x, size.y, size.z});
    if (sum == 0) continue;
    Scene scene = empty_scene();
    std::vector<glm::dvec3> corners;
    for (const Vertex& v : border) corners.push_back(glm::dvec3(v) / static_cast<double>(one));
    scene.add(corners, 0);
    const FacetSet set = build_layers(scene, n, fraction_bits);
    if (set.counts.crowded != 0) continue;
    ASSERT_EQ(set.packets.heads[0].surface, Surface::sheet);
    const Machine machine(set.packets, n);
    Vertex along(0);
    const int axis = dominant_axis(normal);
    along[axis] = normal[axis];
    for_each_voxel(glm::ivec3(0), glm::ivec3(n - 1), [&](const glm::ivec3& p) {
      const Vertex at = Vertex(p) * one;
      bool within = 2 * std::abs(dot(normal, at - border[0])) <= one * (2 * sum + large);
      for (std::size_t i = 0; i < 3; ++i)
        within = within && dot(cross(along, border[(i + 1) % 3] - border[i]), at - border[i]) >= 0;
      EXPECT_EQ(machine.guard[p], within && machine.armour[p] == 0);
      guards += machine.guard[p];
    });
  }
  EXPECT_GT(guards, 10'000);
}

Scene stack_of_sheets(int sheets) {
  Scene scene = empty_scene();
  for (int i = 0; i < sheets; ++i) {
    const double z = 8 + 0.4 * i;
    scene.add({{2, 2, z}, {26, 2, z + 3}, {26, 26, z + 3}, {2, 26, z}}, 0);
  }
  return scene;
}

TEST(Layers, ACrowdHasNoGuard) {
  EXPECT_EQ(build_layers(stack_of_sheets(2), 32, 4).counts.crowded, 0);
  const FacetSet crowd = build_layers(stack_of_sheets(6), 32, 4);
  EXPECT_EQ(crowd.counts.crowded, 6);
  EXPECT_FALSE(has_layer(crowd.packets, Layer::guard));
  for (std::size_t i = 0; i < crowd.facets.size(); ++i)
    EXPECT_EQ(crowd.packets.heads[i].surface, Surface::crowd);
}

// A facet alone is no crowd, however large.
TEST(Layers, OneLargeFacetIsNoCrowd) {
  for (const int n : {64, 512, 1024}) {
    Scene scene;
    scene.materials.resize(1);
    const double high = n - 2;
    scene.add({{1, 1, 9}, {high, 1, 9}, {high, high, 20}, {1, high, 20}}, 0);
    EXPECT_EQ(build_layers(scene, n, 4).counts.crowded, 0) << n;
  }
}

TEST(Layers, ClosedMeshesAreNoCrowd) {
  for_each_mesh(4, [](const Scene& scene, int n, int fraction_bits) {
    if (n < 24) return;  // the smaller, the more of it is in a cube of four voxels
    EXPECT_EQ(build_layers(scene, n, fraction_bits).counts.crowded, 0);
  });
}

TEST(Layers, ThickBoxesPayNothingHoweverTheyAreTurned) {
  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    Scene scene = empty_scene();
    scene::add_box(scene, {glm::dvec3(31.5), {12, 9, 3}, scene::random_rotation(random)}, 0);
    EXPECT_FALSE(has_layer(build_layers(scene, 64, 4).packets, Layer::guard));
  }
}

bool fits(std::int64_t value, int bits) {
  return -(std::int64_t{1} << (bits - 1)) <= value && value < std::int64_t{1} << (bits - 1);
}

// Tetrahedra between the corners of the cube and anywhere: no number is larger than the machine's
// words, not even at the ends of the columns.
TEST(Layers, PacketsFitTheMachine) {
  Random random(6);
  int packets = 0;
  for (const int n : {2, 3, 4, 5, 8, 16, 31, 33, 64, 100, 256, 512, 513, 1023, 1024}) {
    for (int fraction_bits = 0; fraction_bits <= kMaxFractionBits; ++fraction_bits) {
      const double low = fraction_bits == 0 ? 0 : -0.5, high = fraction_bits == 0 ? n - 1 : n - 0.5;
      Scene scene = empty_scene();
      for (int i = 0; i < 40; ++i) {
        std::array<glm::dvec3, 4> corners;
        for (glm::dvec3& corner : corners)
          for (int axis = 0; axis < 3; ++axis)
            corner[axis] = random.below(3) == 0   ? random.between(low, high)
                           : random.below(2) == 0 ? low
                                                  : high;
        for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
          scene.add({corners[a], corners[b], corners[c]}, 0);
      }
      const PacketStream stream = build_layers(scene, n, fraction_bits).packets;
      EXPECT_NO_THROW(check_packets({n, fraction_bits, 1, 1}, stream));
      for (const PacketHead& head : stream.heads) {
        if (head.layer != Layer::inside && head.layer != Layer::guard) continue;
        ++packets;
        const int top = head.layer == Layer::inside ? n - 1 : head.hi.z - head.lo.z;
        for (const int x : {0, head.hi.x - head.lo.x})
          for (const int y : {0, head.hi.y - head.lo.y})
            for (const int z : {0, top})
              EXPECT_TRUE(
                  fits(value_at(head.slab.value, {x, y, z}), offset_bits(n, fraction_bits)));
      }
    }
  }
  EXPECT_GT(packets, 5'000);
}

}  // namespace
}  // namespace rc2::facet
