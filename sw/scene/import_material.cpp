#include "sw/scene/import_material.h"

#include <assimp/material.h>

#include <algorithm>
#include <cmath>

namespace rc2::scene {
namespace {

float share(float value) { return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.0F; }

glm::vec3 colour(const aiColor3D& c) { return {share(c.r), share(c.g), share(c.b)}; }

float number(const aiMaterial& source, const char* key, unsigned type, unsigned index,
             float otherwise) {
  float value = otherwise;
  return source.Get(key, type, index, value) == aiReturn_SUCCESS && std::isfinite(value)
             ? value
             : otherwise;
}

}  // namespace

Material import_material(const aiMaterial& source) {
  Material result;
  aiString name;
  if (source.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) result.name = name.C_Str();

  aiColor3D c;
  if (source.Get(AI_MATKEY_COLOR_DIFFUSE, c) == aiReturn_SUCCESS ||
      source.Get(AI_MATKEY_BASE_COLOR, c) == aiReturn_SUCCESS)
    result.diffuse = colour(c);
  if (source.Get(AI_MATKEY_COLOR_SPECULAR, c) == aiReturn_SUCCESS) result.specular = colour(c);
  if (source.Get(AI_MATKEY_COLOR_EMISSIVE, c) == aiReturn_SUCCESS) result.emission = colour(c);
  result.shininess = std::max(0.0F, number(source, AI_MATKEY_SHININESS, 0.0F));

  float mirror = number(source, AI_MATKEY_REFLECTIVITY, 0.0F);
  if (source.Get(AI_MATKEY_COLOR_REFLECTIVE, c) == aiReturn_SUCCESS)
    mirror *= std::max({c.r, c.g, c.b});
  const float smoothness = 1.0F - share(number(source, AI_MATKEY_ROUGHNESS_FACTOR, 1.0F));
  const float metal = share(number(source, AI_MATKEY_METALLIC_FACTOR, 0.0F));
  result.mirror = std::max(share(mirror), metal * smoothness * smoothness);

  const float opacity = share(number(source, AI_MATKEY_OPACITY, 1.0F));
  const float transmission = share(number(source, AI_MATKEY_TRANSMISSION_FACTOR, 0.0F));
  result.transparency = std::max(transmission, opacity > 0.0F ? 1.0F - opacity : 0.0F);
  const float index = number(source, AI_MATKEY_REFRACTI, 1.0F);
  result.refractive_index = index >= 1.0F ? index : 1.0F;
  return result;
}

std::int64_t texture_count(const aiMaterial& source) {
  std::int64_t count = 0;
  for (int type = aiTextureType_NONE; type <= AI_TEXTURE_TYPE_MAX; ++type)
    count += source.GetTextureCount(static_cast<aiTextureType>(type));
  return count;
}

}  // namespace rc2::scene
