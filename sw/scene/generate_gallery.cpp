#include <array>

#include "sw/scene/generate_parts.h"
#include "sw/scene/shapes.h"

namespace rc2::scene {
namespace {

enum : std::uint32_t {
  kCeiling,
  kFront,
  kPale,
  kRed,
  kBlue,
  kGreen,
  kLightFloor,
  kDarkFloor,
  kFrame,
  kMirror,
  kSilver,
  kGlass,
  kOchre,
  kCount
};

constexpr int kTiles = 6;

std::vector<Material> materials() {
  std::vector<Material> all(kCount);
  const auto material = [&](std::uint32_t index, const char* name, const glm::vec3& diffuse) {
    all[index].name = name;
    all[index].diffuse = diffuse;
  };
  material(kCeiling, "ceiling", {0.80F, 0.80F, 0.78F});
  material(kFront, "front wall", {0.55F, 0.52F, 0.50F});
  material(kPale, "pale tile", {0.78F, 0.75F, 0.68F});
  material(kRed, "red tile", {0.70F, 0.18F, 0.12F});
  material(kBlue, "blue tile", {0.15F, 0.28F, 0.60F});
  material(kGreen, "green tile", {0.20F, 0.45F, 0.25F});
  material(kLightFloor, "light floor", {0.62F, 0.52F, 0.38F});
  material(kDarkFloor, "dark floor", {0.25F, 0.17F, 0.10F});
  material(kFrame, "frame", {0.30F, 0.20F, 0.10F});
  material(kMirror, "mirror", {0.03F, 0.03F, 0.04F});
  material(kSilver, "silver", {0.05F, 0.05F, 0.06F});
  material(kGlass, "glass", {0.02F, 0.03F, 0.03F});
  material(kOchre, "ochre", {0.75F, 0.50F, 0.12F});
  for (const std::uint32_t floor : {kLightFloor, kDarkFloor}) all[floor].mirror = 0.15F;
  for (const std::uint32_t shiny : {kMirror, kSilver, kGlass}) {
    all[shiny].specular = glm::vec3(0.5F);
    all[shiny].shininess = 60.0F;
  }
  all[kMirror].mirror = 0.85F;
  all[kSilver].mirror = 0.80F;
  all[kGlass].mirror = 0.08F;
  all[kGlass].transparency = 0.85F;
  all[kGlass].refractive_index = 1.5F;
  return all;
}

// The two colours of a wall, by axis and side.
constexpr std::array<std::array<std::array<std::uint32_t, 2>, 2>, 3> kWalls{
    {{{{kRed, kPale}, {kBlue, kPale}}},
     {{{kLightFloor, kDarkFloor}, {kCeiling, kCeiling}}},
     {{{kGreen, kPale}, {kFront, kFront}}}}};

}  // namespace

void generate_gallery(Scene& scene, int n) {
  // The walls are more than half a voxel from the middle of the nearest column in the room, so that
  // each voxel that a viewer in front sees belongs to one wall only.
  const double low = n < 4 ? 0.0 : 0.25;
  const double size = n < 4 ? n - 1.0 : n - 1.5;
  const auto place = [&](const glm::dvec3& share) { return low + size * share; };
  scene.materials = materials();

  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int u = 0; u < kTiles; ++u)
        for (int v = 0; v < kTiles; ++v)
          add_tile(scene, {low, size}, {axis, side, u, v, kTiles},
                   kWalls[static_cast<std::size_t>(axis)][static_cast<std::size_t>(side)]
                         [static_cast<std::size_t>((u + v) % 2)]);

  // Turned by halves of angles with rational sines, the same with every mathematics library.
  const glm::dmat3 lean{{1, 0, 0}, {0, 399.0 / 401, 40.0 / 401}, {0, -40.0 / 401, 399.0 / 401}};
  const glm::dmat3 turn{{99.0 / 101, 0, 20.0 / 101}, {0, 1, 0}, {-20.0 / 101, 0, 99.0 / 101}};
  const glm::dmat3 hung = turn * lean;
  const auto box = [&](const glm::dvec3& centre, const glm::dvec3& half, const glm::dmat3& axes,
                       std::uint32_t material) {
    add_box(scene, {place(centre), size * half, axes}, material);
  };
  box({0.45, 0.56, 0.14}, {0.34, 0.30, 0.025}, hung, kMirror);
  box({0.80, 0.15, 0.26}, {0.10, 0.13, 0.09}, turn, kOchre);
  box({0.42, 0.07, 0.62}, {0.05, 0.05, 0.05}, glm::dmat3(1.0), kFrame);
  add_sphere(scene, place({0.24, 0.17, 0.42}), size * 0.16, kEdge, kSilver);
  add_sphere(scene, place({0.62, 0.14, 0.50}), size * 0.13, kEdge, kGlass);

  scene.lights.push_back({place({0.35, 0.90, 0.62}), {0.95F, 0.92F, 0.85F}});
  scene.lights.push_back({place({0.88, 0.62, 0.88}), {0.35F, 0.38F, 0.45F}});
  scene.camera = Camera{place({0.52, 0.47, 0.97}), {-0.04, -0.18, -1}, {0, 1, 0}, 1.25};
}

}  // namespace rc2::scene
