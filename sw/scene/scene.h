// A scene as the host sees it before it becomes integers: polygons, materials, lights, camera.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rc2::scene {

/// Surface of a facet (thesis 1.1). Colours are linear RGB, 0..1.
struct Material {
  std::string name;
  glm::vec3 diffuse{0.8F};
  glm::vec3 specular{0.0F};
  float shininess = 0.0F;  ///< Phong exponent m
  glm::vec3 emission{0.0F};
  float mirror = 0.0F;        ///< share of light reflected, 0..1
  float transparency = 0.0F;  ///< share of light refracted, 0..1
  float refractive_index = 1.0F;
};

/// A point light. Position in the units of the scene. Colours are relative to each other: the
/// brightest component of a scene read from a file is at most 1.
struct Light {
  glm::dvec3 position;
  glm::vec3 colour{1.0F};
};

struct Camera {
  glm::dvec3 position, direction, up;
  double angle;  ///< from the left to the right border of the picture, radians; 45 degrees if the
                 ///< file does not say it in a way that Assimp reads
};

/// Polygons in flat storage: polygon i has vertices first[i] .. first[i+1]-1, in order around its
/// border; seen from its outside they turn counter-clockwise.
struct Scene {
  std::string name;
  std::vector<glm::dvec3> vertices;
  /// Of each vertex, in its polygon: a unit vector to shade by; 0 where there is none.
  std::vector<glm::dvec3> normals;
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> material;  ///< per polygon, index into materials
  std::vector<Material> materials;
  std::vector<Light> lights;
  std::optional<Camera> camera;

  std::int64_t ignored_primitives = 0;  ///< points and lines of the file: they have no area
  std::int64_t ignored_lights = 0;      ///< without a place (directional, ambient) or black
  std::int64_t ignored_textures = 0;    ///< images that materials name: facets have one colour

  std::size_t polygon_count() const { return material.size(); }

  /// Appends one polygon; with normals at its corners, or without.
  void add(const std::vector<glm::dvec3>& corners, std::uint32_t material_index,
           const std::vector<glm::dvec3>& corner_normals = {});
};

/// Reads any format Assimp knows, all nodes placed, y up where the format says which axis is up.
/// Polygons keep their number of sides. Spot and area lights become point lights.
/// Throws Error (file, what, why, mend), also if there is no polygon or a vertex is not finite.
Scene read_file(const std::string& path);

/// True if `name` is a generated scene: empty, room, gallery, ball:R, shells:PERCENT:SEED,
/// dust:PERCENT:SEED.
bool is_generated_name(const std::string& name);

/// Builds a generated scene for an n-cube, in voxel coordinates (never fitted). The same name and
/// n give the same scene with every compiler. Its meshes are closed, dust excepted.
///  - empty            nothing
///  - room             a closed room with furniture, three balls and a light under the ceiling
///  - gallery          a tiled room with a mirror on its wall, a silver and a glass ball, two
///  lights
///                     and a camera
///  - ball:R           a sphere of radius R voxels (0 < R <= n/2) in the middle
///  - shells:P:SEED    spheres and boxes whose armoured voxels are about P % of the cube (n >= 4)
///  - dust:P:SEED      P % of the voxels, each by a facet that occupies it alone if f >= 1
/// Throws Error on a malformed name.
Scene generate(const std::string& name, int n);

/// Scales uniformly and moves the scene, lights and camera included, so that its longest side
/// spans voxel centres 1 .. n-2 (0 .. n-1 for n < 4) and its middle is the middle of the cube.
/// Throws Error if the scene has no extent.
void fit_to_cube(Scene& scene, int n);

}  // namespace rc2::scene
