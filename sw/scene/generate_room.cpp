#include "sw/scene/generate_parts.h"
#include "sw/scene/shapes.h"

namespace rc2::scene {

void generate_room(Scene& scene, int n) {
  // Everything is placed in a unit room and scaled to the voxel centres 1 .. n-2.
  const double low = n < 4 ? 0.0 : 1.0;
  const double size = n < 4 ? n - 1.0 : n - 3.0;
  const auto box = [&](const glm::dvec3& from, const glm::dvec3& to, std::uint32_t material) {
    add_box(scene, {low + size * 0.5 * (from + to), size * 0.5 * (to - from)}, material);
  };
  const auto ball = [&](const glm::dvec3& centre, double radius, std::uint32_t material) {
    add_sphere(scene, low + size * centre, size * radius, kEdge, material);
  };

  enum : std::uint32_t { kWall, kWood, kCupboard, kRed, kMirror, kGlass };
  scene.materials.resize(6);
  const auto material = [&](std::uint32_t index, const char* name, const glm::vec3& diffuse) {
    scene.materials[index].name = name;
    scene.materials[index].diffuse = diffuse;
  };
  material(kWall, "wall", {0.85F, 0.82F, 0.75F});
  material(kWood, "wood", {0.6F, 0.4F, 0.2F});
  material(kCupboard, "cupboard", {0.25F, 0.35F, 0.6F});
  material(kRed, "red", {0.8F, 0.15F, 0.1F});
  material(kMirror, "mirror", {0.1F, 0.1F, 0.1F});
  material(kGlass, "glass", {0.1F, 0.15F, 0.1F});
  for (const std::uint32_t shiny : {kRed, kMirror, kGlass}) {
    scene.materials[shiny].specular = glm::vec3(0.6F);
    scene.materials[shiny].shininess = 40.0F;
  }
  scene.materials[kMirror].mirror = 0.8F;
  scene.materials[kGlass].transparency = 0.8F;
  scene.materials[kGlass].refractive_index = 1.5F;

  add_box(scene, {glm::dvec3(low + 0.5 * size), glm::dvec3(0.5 * size)}, kWall, true);
  box({0.30, 0.32, 0.30}, {0.70, 0.40, 0.60}, kWood);
  for (const double x : {0.32, 0.60})
    for (const double z : {0.32, 0.50}) box({x, 0.0, z}, {x + 0.08, 0.32, z + 0.08}, kWood);
  box({0.75, 0.0, 0.05}, {0.95, 0.65, 0.35}, kCupboard);
  ball({0.50, 0.52, 0.45}, 0.10, kRed);
  ball({0.20, 0.15, 0.70}, 0.13, kMirror);
  ball({0.80, 0.14, 0.75}, 0.12, kGlass);
  scene.lights.push_back({low + size * glm::dvec3(0.45, 0.82, 0.62), {1.0F, 0.95F, 0.85F}});
}

}  // namespace rc2::scene
