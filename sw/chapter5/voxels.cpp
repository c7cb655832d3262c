#include "sw/chapter5/voxels.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "sw/golden/voxelise.h"

namespace rc2::chapter5 {
namespace {

struct Shared {
  Claim owner;
  glm::dvec3 normals;  // their sum
};

bool is_better(const Claim& a, const Claim& b, Owner owner) {
  switch (owner) {
    case Owner::core:
      return a.packed() < b.packed();
    case Owner::nearest: {
      const auto key = [](Claim claim) {
        claim.core = true;
        return claim.packed();
      };
      return key(a) < key(b);
    }
    default:
      return a.facet < b.facet;
  }
}

// The largest component kNormalOne. Facets that face each other may have no mean.
glm::ivec3 slope_form(const glm::dvec3& normal, const glm::ivec3& otherwise) {
  const glm::dvec3 size = glm::abs(normal);
  const double largest = std::max({size.x, size.y, size.z});
  if (largest < 1e-6) return otherwise;
  const glm::dvec3 scaled = normal * (rays::kNormalOne / largest);
  return {glm::round(scaled)};
}

struct InOrderOfDumps {
  bool operator()(const glm::ivec3& a, const glm::ivec3& b) const {
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
  }
};

}  // namespace

Voxels::Voxels(const facet::PacketStream& packets, const std::vector<rays::Facet>& facets, int n,
               Owner owner)
    : grid_(n) {
  std::map<glm::ivec3, Shared, InOrderOfDumps> filled;
  for (const facet::PacketHead& packet : packets.heads) {
    if (packet.layer != facet::Layer::armour) continue;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(facets[packet.facet].normal));
    golden::for_each_dexel(
        packet, packets.sides.data() + packet.first_side, [&](const golden::Dexel& dexel) {
          for (std::int64_t z = dexel.z.first; z <= dexel.z.last; ++z) {
            const Claim claim = golden::claim_of(n, packet, dexel, z);
            const glm::ivec3 at = packet.lo + glm::ivec3(dexel.x, dexel.y, z);
            const auto [voxel, is_new] = filled.try_emplace(at, Shared{claim, glm::dvec3(0)});
            Shared& shared = voxel->second;
            shared.normals += normal;
            if (!is_new && is_better(claim, shared.owner, owner)) shared.owner = claim;
          }
        });
  }
  for (const auto& [at, shared] : filled) {
    grid_[grid_.index(at)] = static_cast<std::uint32_t>(memory_.size());
    memory_.push_back({at, shared.owner});
    means_.push_back(slope_form(shared.normals, facets[shared.owner.facet].normal));
  }
}

}  // namespace rc2::chapter5
