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
  if (packet.layer != facet::Layer::armour && !config.layers) {
    refuse("it was built without layers");
  }
  if (packet.lo.x > packet.hi.x || packet.lo.y > packet.hi.y || packet.lo.z > packet.hi.z) {
    refuse("its box is empty");
  }
  if (std::size_t{packet.first_side} + packet.side_count > stream.sides.size()) {
    refuse("its sides are missing");
  }
  const int n = config.n, f = config.fraction_bits;
  const auto check_linear = [&](const facet::Linear& value, int bits) {
    if (!fits(value.a, bits) || !fits(value.b, bits) || !fits(value.c, bits)) {
      refuse("a coefficient is too large");
    }
    // Stepped from cell to cell the value goes from d to that in the corners of the box.
    const std::int64_t east = value.a * (packet.hi.x - packet.lo.x);
    const std::int64_t north = value.b * (packet.hi.y - packet.lo.y);
    const std::int64_t lowest = std::min<std::int64_t>(east, 0) + std::min<std::int64_t>(north, 0);
    const std::int64_t highest = std::max<std::int64_t>(east, 0) + std::max<std::int64_t>(north, 0);
    const int offset = offset_bits(n, f);
    if (!fits(value.d, offset) || !fits(value.d + lowest, offset) ||
        !fits(value.d + highest, offset)) {
      refuse("an offset is too large");
    }
  };
  const auto check_reach = [&](std::int64_t reach, int bits) {
    if (reach < 0 || reach >> bits != 0) refuse("its slab is too thick or a side pushed too far");
  };
  check_linear(packet.slab.value, plane_bits(n, f));
  check_reach(packet.slab.width, width_bits(n, f));
  for (std::uint32_t i = 0; i < packet.side_count; ++i) {
    const facet::Side& side = stream.sides[packet.first_side + i];
    check_linear(side.value, side_bits(n, f));
    check_reach(side.push, push_bits(n, f));
  }
  // A gap may wrap: only what is left of it inside the facet is kept.
  const std::int64_t steepest = std::int64_t{1} << gap_fraction_bits(n);
  for (const std::int64_t slope : {packet.gap.a, packet.gap.b, packet.gap.c}) {
    if (slope > steepest || slope < -steepest) refuse("its gap is too steep");
  }
  if (!fits(packet.gap.d, 48)) refuse("its gap is too large");
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
  check_feeders("row feeders", config.feeders, config.n);
  return config;
}

void check_feeders(const char* option, int feeders, int n) {
  if (feeders < 1 || feeders > n || (feeders & (feeders - 1)) != 0) {
    throw Error(fmt::format("{} {} cannot be built with n = {}: choose a power of two from 1 to {}",
                            option, feeders, n, n));
  }
}

void check_packets(const MachineConfig& config, const facet::PacketStream& stream) {
  for (const facet::PacketHead& packet : stream.heads) check_packet(config, stream, packet);
  std::size_t next = 0;
  for (const facet::Batch& batch : stream.batches) {
    if (batch.first != next || batch.count > stream.heads.size() - next) {
      throw Error("the batches of a packet stream do not follow each other; build the facets anew");
    }
    next += batch.count;
  }
  if (!stream.batches.empty() && next != stream.heads.size()) {
    throw Error("the batches of a packet stream leave packets over; build the facets anew");
  }
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
  if (job.rule == LightRule::thesis) return;
  if (!config.accurate_light()) {
    refuse_light(job,
                 "this machine knows the thesis's light rule only; ask for it with --light-rule "
                 "thesis, or use a machine that is in fast mode and has layers");
  }
}

void refuse_occupied_source(const LightJob& job, std::uint32_t owner) {
  refuse_light(job,
               fmt::format("its voxel is occupied by facet {}; move it to a free voxel", owner));
}

}  // namespace rc2
