// What a point of a surface sends to the eye of its own (thesis 1.1): Blinn's model. Machine and
// continuous scene are shaded by the same formula, so that only their rays can differ.
#pragma once

#include <glm/vec3.hpp>

#include "sw/scene/scene.h"

namespace rc2::scene {

/// Where nothing is seen. Linear RGB.
constexpr glm::vec3 kBackground(0.010F, 0.013F, 0.022F);

/// emission + Ka Ia, where Ka = Kd.
glm::vec3 own_light(const Material& material);

/// (Kd N.L + Ks (N.H)^m) of a lamp, H being Blinn's half vector; nothing if the surface turns away
/// from it. A material of shininess 0 has no highlight. All ways are unit vectors.
glm::vec3 thrown_back(const Material& material, const glm::vec3& normal, const glm::vec3& to_eye,
                      const glm::vec3& to_lamp);

/// E of a lamp: it fades gently with the distance, which gives shape to flat walls,
/// colour / (1 + (distance/n)^2), the same picture at every n.
glm::vec3 faded(const glm::vec3& colour, float distance, int n);

}  // namespace rc2::scene
