// Pictures made of rays, and how much two pictures differ.
#include "sw/picture/compose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "sw/picture/difference.h"
#include "sw/scene/shade.h"

namespace rc2::picture {
namespace {

constexpr int kSide = 4;

// A pixel whose ray hits facet 0 head on, and what its tests change.
struct Subject {
  VoxelMemory voxels{{{1, 2, 1}, {0}}};
  std::vector<facet::FacetInfo> facets{{{0, 0, 1}, 0}, {{0, 0, 1}, 1}};
  std::vector<scene::Material> materials = std::vector<scene::Material>(2);
  std::vector<Lamp> lamps{{{1, 2, 3}, glm::vec3(1), {1}}};
  std::vector<RayHit> hits{hit(1, 0, rays::kWeightOne)};

  static RayHit hit(std::uint8_t node, std::uint32_t facet, int weight) {
    RayHit hit{
        primary_ray({1, 2}, kSide), facet, false, {1, 2, 1}, rays::kPlaceOne * glm::ivec3(1, 2, 1)};
    hit.ray.node = node;
    hit.ray.weight = static_cast<std::uint16_t>(weight);
    return hit;
  }

  Image image(int depth = 4) const {
    return compose({kSide, voxels, facets, materials, hits}, lamps, depth);
  }
  glm::vec3 colour(int depth = 4) const {
    const Image made = image(depth);
    return made.colour[made.pixel(1, 2)];
  }
};

void expect_near(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-5F) << a.x << " " << a.y << " " << a.z;
}

TEST(Compose, ShadesAHitByTheLampThatReachesItsVoxel) {
  Subject subject;
  const scene::Material& material = subject.materials[0];
  const glm::vec3 dark = scene::own_light(material);
  subject.lamps[0].voxel = {3, 2, 3};
  // Diffuse 0.8, 45 degrees, faded by 1 + d^2 / n^2.
  const glm::vec3 lit(static_cast<float>(0.8 * std::sqrt(0.5) / (1 + 8.0 / 16)));
  expect_near(subject.colour(), dark + lit);
  subject.lamps[0].arrived = {0};
  expect_near(subject.colour(), dark);
  subject.lamps[0].arrived.clear();
  expect_near(subject.colour(), dark + lit);
  const Image image = subject.image();
  EXPECT_FLOAT_EQ(image.depth[image.pixel(1, 2)], 2.5F - 1.0F / rays::kPlaceOne);
  EXPECT_EQ(image.facet[image.pixel(1, 2)], 0U);
  expect_near(image.colour[image.pixel(0, 0)], scene::kBackground);
}

TEST(Compose, AddsUpTheTreeByWeightAsFarAsTheDepth) {
  Subject subject;
  subject.lamps.clear();
  subject.materials[0].emission = {1, 0, 0};
  subject.materials[1].emission = {0, 1, 0};
  for (scene::Material& material : subject.materials) material.diffuse = glm::vec3(0);
  subject.hits.push_back(Subject::hit(2, 1, rays::kWeightOne / 2));
  subject.hits.push_back(Subject::hit(3, RayHit::kNoFacet, rays::kWeightOne / 4));
  subject.hits.push_back(Subject::hit(4, 1, rays::kWeightOne / 8));
  expect_near(subject.colour(0), {1, 0, 0});
  expect_near(subject.colour(1), glm::vec3(1, 0.5F, 0) + 0.25F * scene::kBackground);
  expect_near(subject.colour(2), glm::vec3(1, 0.625F, 0) + 0.25F * scene::kBackground);
}

TEST(Compose, TurnsASheetAndPassesThroughGlass) {
  Subject subject;
  subject.facets[0].normal = {0, 0, -1};
  subject.hits[0].is_back = true;
  subject.facets[0].body = rays::Body::sheet;
  EXPECT_GT(subject.colour().x, scene::own_light(subject.materials[0]).x);
  subject.facets[0].body = rays::Body::solid;
  expect_near(subject.colour(), glm::vec3(0));
}

TEST(Compose, RefusesHitsOfAnotherScene) {
  Subject subject;
  subject.hits[0].facet = 7;
  EXPECT_THROW(subject.image(), Error);
  subject.hits[0].facet = 0;
  subject.hits[0].voxel.z = 0;
  EXPECT_THROW(subject.image(), Error);
}

TEST(Compose, RefusesTheLightOfAnotherLoad) {
  Subject subject;
  subject.lamps[0].arrived = {1, 1};
  EXPECT_THROW(subject.image(), Error);
  subject.lamps[0].arrived.clear();
  EXPECT_NO_THROW(subject.image());
  subject.materials.clear();
  EXPECT_THROW(subject.image(), Error);
}

// Squares, slopes and three changes.
std::pair<Image, Image> pattern(int n) {
  Image a;
  a.n = n;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      a.colour.emplace_back(static_cast<float>((x / 6 + y / 6) % 2) * 0.8F,
                            static_cast<float>(x) / static_cast<float>(n),
                            static_cast<float>(y) / static_cast<float>(n));
  Image b = a;
  const auto at = [&](int x, int y) -> glm::vec3& {
    return b.colour[static_cast<std::size_t>(y) * static_cast<std::size_t>(n) +
                    static_cast<std::size_t>(x)];
  };
  for (int y = 10; y < 20; ++y)
    for (int x = 12; x < 30; ++x) at(x, y).r = 0.3F;
  for (int y = 25; y < 40; ++y)
    for (int x = 5; x < 9; ++x) at(x, y).g += 0.2F;
  for (int y = 30; y < 36; ++y)
    for (int x = 30; x < 36; ++x) at(x, y) = {0.1F, 0.9F, 0.2F};
  return {a, b};
}

// 0.0996750 is what flip-evaluator 1.7, the authors' own program, says of these two.
TEST(Difference, FlipIsThatOfItsAuthors) {
  const auto [a, b] = pattern(48);
  EXPECT_NEAR(flip(a, b), 0.0996750, 1e-5);
  EXPECT_NEAR(flip(a, a), 0, 1e-9);
}

TEST(Difference, CountsWrongPixelsAndSquares) {
  const auto [a, b] = pattern(48);
  Image c = a;
  c.colour[5] += glm::vec3(0.04F);
  c.colour[6].b += 0.3F;
  const Difference found = difference(c, a);
  EXPECT_NEAR(found.wrong, 1.0 / (48 * 48), 1e-9);
  EXPECT_NEAR(found.rmse, std::sqrt((0.04 * 0.04 + 0.3 * 0.3 / 3) / (48 * 48)), 1e-6);
  EXPECT_GT(difference(b, a).wrong, 0.05);
}

}  // namespace
}  // namespace rc2::picture
