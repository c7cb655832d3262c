#include "sw/machine/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace rc2 {
namespace {

bool inside(glm::ivec3 at, int n) {
  return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < n && at.y < n && at.z < n;
}

bool fits(std::int64_t value, int signed_bits) {
  const std::int64_t limit = std::int64_t{1} << (signed_bits - 1);
  return -limit <= value && value < limit;
}

void check_packet(const MachineConfig& config, const facet::PacketStream& stream,
                  const facet::PacketHead& packet) {
  const auto refuse = [&](const char* why) {
    throw Error(
        fmt::format("the packet of facet {} does not fit the machine (n = {}, {} fraction "
                    "bits): {}; build the facets for this machine",
                    packet.facet, config.n, config.fraction_bits, why));
  };
  if (packet.facet >= static_cast<std::uint32_t>(kMaxFacets)) refuse("its number is too large");
  if (!inside(packet.lo, config.n) || !inside(packet.hi, config.n)) {
    refuse("its box reaches out of the cube");
  }
  if (packet.lo.x > packet.hi.x || packet.lo.y > packet.hi.y || packet.lo.z > packet.hi.z) {
    refuse("its box is empty");
  }
  if (packet.bound_count < 2) refuse("it has fewer than two bounds");
  if (std::size_t{packet.first_bound} + packet.bound_count > stream.bounds.size()) {
    refuse("its bounds are missing");
  }
  const int coefficient = coefficient_bits(config.n, config.fraction_bits);
  const int offset = offset_bits(config.n, config.fraction_bits);
  for (std::uint32_t i = 0; i < packet.bound_count; ++i) {
    const facet::Bound& bound = stream.bounds[packet.first_bound + i];
    if (!fits(bound.a, coefficient) || !fits(bound.b, coefficient) || !fits(bound.c, coefficient)) {
      refuse("a coefficient is too large");
    }
    // Stepped from cell to cell the offset goes from d to its values in the corners of the box.
    const std::int64_t east = bound.a * (packet.hi.x - packet.lo.x);
    const std::int64_t north = bound.b * (packet.hi.y - packet.lo.y);
    const std::int64_t lowest = std::min<std::int64_t>(east, 0) + std::min<std::int64_t>(north, 0);
    const std::int64_t highest = std::max<std::int64_t>(east, 0) + std::max<std::int64_t>(north, 0);
    if (!fits(bound.d, offset) || !fits(bound.d + lowest, offset) ||
        !fits(bound.d + highest, offset)) {
      refuse("an offset is too large");
    }
  }
}

[[noreturn]] void refuse_light(const LightJob& job, const std::string& why) {
  throw Error(fmt::format("the light at voxel ({},{},{}) cannot be lit: {}", job.source.x,
                          job.source.y, job.source.z, why));
}

}  // namespace

const MachineConfig& checked(const MachineConfig& config) {
  const auto check = [](const char* what, int value, int lowest, int highest) {
    if (value < lowest || value > highest) {
      throw Error(fmt::format("a machine cannot have {} = {}: choose {} to {}", what, value, lowest,
                              highest));
    }
  };
  check("n", config.n, 2, kMaxSide);
  check("fraction bits", config.fraction_bits, 0, kMaxFractionBits);
  check("largest target distance L", config.max_distance, 1, kMaxDistance);
  check("deepest FA", config.max_fa, 1, 1 << 30);
  return config;
}

void check_packets(const MachineConfig& config, const facet::PacketStream& stream) {
  for (const facet::PacketHead& packet : stream.heads) check_packet(config, stream, packet);
}

void check_light(const MachineConfig& config, const LightJob& job) {
  if (!inside(job.source, config.n)) {
    refuse_light(
        job, fmt::format("it is outside the cube; its coordinates must be 0 to {}", config.n - 1));
  }
  if (job.target_distance < 1 || job.target_distance > config.max_distance) {
    refuse_light(job, fmt::format("the target distance L is {}; choose 1 to {}",
                                  job.target_distance, config.max_distance));
  }
  if (job.fa < 1 || job.fa > config.max_fa) {
    refuse_light(job, fmt::format("the depth FA is {}; choose 1 to {}", job.fa, config.max_fa));
  }
}

void refuse_occupied_source(const LightJob& job, std::uint32_t owner) {
  refuse_light(job,
               fmt::format("its voxel is occupied by facet {}; move it to a free voxel", owner));
}

}  // namespace rc2
