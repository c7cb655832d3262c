// Polygons in voxel space -> exact integer facets -> packets for the array.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "sw/facet/packet.h"
#include "sw/facet/polygon.h"
#include "sw/rays/ray.h"
#include "sw/scene/scene.h"

namespace rc2::facet {

/// Which voxels belong to a facet; docs/loading.md compares them.
enum class Rule { armoured, naive, supercover, half, blindee };

/// Throws Error on an unknown word.
Rule parse_rule(const std::string& word);
const char* to_string(Rule rule);

/// The points p, in vertex units, with normal . p = level. Exact.
struct Plane {
  Vertex normal{0};
  std::int64_t level = 0;
};

/// What the host remembers of a facet.
struct FacetInfo {
  glm::vec3 normal;  ///< outward, of unit length
  std::uint32_t material;
  Plane plane{};
  rays::Body body = rays::Body::sheet;  ///< of build_layers only
  std::uint32_t polygon = 0;            ///< of the scene
};

/// What became of the scene's polygons.
struct FacetCounts {
  std::int64_t read = 0;          ///< polygons in the scene
  std::int64_t triangulated = 0;  ///< polygons split because not planar or not convex
  std::int64_t loaded = 0;        ///< facets sent to the machine
  std::int64_t degenerate = 0;    ///< facets of no area after quantisation, dropped
  std::int64_t outside = 0;       ///< facets that lie wholly outside the cube, dropped

  // Of build_layers only.
  std::int64_t objects_closed = 0;  ///< solids, with their cavities: voxels inside are known
  std::int64_t objects_capped = 0;  ///< of the solids, those with holes that were closed
  std::int64_t crowded = 0;         ///< facets that are crowded (Surface)
  std::int64_t objects_open = 0;    ///< surfaces that are not closed: nothing inside
  std::int64_t rooms = 0;           ///< closed surfaces that face inwards, round others: likewise
};

struct FacetSet {
  PacketStream packets;
  std::vector<FacetInfo> facets;  ///< indexed by facet number
  FacetCounts counts;
};

/// Quantises the scene (voxel coordinates) to 1/2^fraction_bits and builds one packet per facet,
/// numbered in scene order. Throws Error naming the polygon if a vertex is NaN or infinite, if a
/// facet straddles the cube's border, or if there are more facets than kMaxFacets.
FacetSet build_facets(const scene::Scene& scene, int n, int fraction_bits, Rule rule);

}  // namespace rc2::facet
