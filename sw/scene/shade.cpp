#include "sw/scene/shade.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rc2::scene {
namespace {

constexpr glm::vec3 kAmbient(0.12F);

}  // namespace

glm::vec3 own_light(const Material& material) {
  return material.emission + material.diffuse * kAmbient;
}

glm::vec3 thrown_back(const Material& material, const glm::vec3& normal, const glm::vec3& to_eye,
                      const glm::vec3& to_lamp) {
  const float facing = glm::dot(normal, to_lamp);
  if (facing <= 0) return glm::vec3(0);
  glm::vec3 share = material.diffuse * facing;
  if (material.shininess > 0) {
    const glm::vec3 half = glm::normalize(to_lamp + to_eye);
    share +=
        material.specular * std::pow(glm::max(0.0F, glm::dot(normal, half)), material.shininess);
  }
  return share;
}

glm::vec3 faded(const glm::vec3& colour, float distance, int n) {
  const float relative = distance / static_cast<float>(n);
  return colour / (1 + relative * relative);
}

}  // namespace rc2::scene
