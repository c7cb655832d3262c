#include "tb/systemc/cell_unit.h"

#include "tb/load/dice.h"

namespace rc2::tb {
namespace {

const WordFormat kFormat(kArray);
const int kCoordinateBits = kFormat.coordinate;
const int kDistanceBits = bits_for(kArray.max_distance + 1);
const int kQueueBits = bits_for(kArray.max_fa + 1);
const int kTargetBits = kDistanceBits + 1;
constexpr int kDirBits = 3;
constexpr int kLightAt = 32;  // in a command, above its two flags

// Fields of a word, lowest first.
class Fields {
 public:
  explicit Fields(std::uint64_t bits = 0) : bits_(bits) {}

  void add(int value, int width) {
    bits_ |= (static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << width) - 1)) << at_;
    at_ += width;
  }
  int next(int width) {
    const std::uint64_t value = bits_ >> at_ & ((std::uint64_t{1} << width) - 1);
    at_ += width;
    return static_cast<int>(value);
  }
  int next_signed(int width) {
    const int value = next(width);
    return value - (value >> (width - 1) << width);
  }
  std::uint64_t bits() const { return bits_; }

 private:
  std::uint64_t bits_;
  int at_ = 0;
};

}  // namespace

StreamNames cell_streams() {
  const int light_bits = 3 * kCoordinateBits + kDistanceBits + kQueueBits;
  const int word_bits = WordFormat::kKindBits + kFormat.lead + kFormat.rest;
  const int beam_bits = kDirBits + kCoordinateBits + 4 * kTargetBits;
  StreamNames names{{{"command", kLightAt + light_bits}, {"words_in", word_bits}},
                    {{"words_out", word_bits}}};
  for (std::size_t link = 0; link < kLinks; ++link) {
    names.in.push_back({"link" + std::to_string(link) + "_in", beam_bits});
    names.out.push_back({"link" + std::to_string(link) + "_out", beam_bits});
  }
  names.out.push_back({"home", WordFormat::home_bits(kArray.max_distance)});
  return names;
}

glm::ivec2 chosen_cell(std::uint64_t seed) {
  facet::Dice dice(seed);
  const auto inner = [&] { return static_cast<int>(dice.roll(1, kArray.n - 2)); };
  const int x = inner();
  return {x, inner()};
}

// The light lies as in light_t, whose last field is lowest.
Beat pack_command(const CellCommand& command) {
  Fields light;
  light.add(command.light.fa, kQueueBits);
  light.add(command.light.target_distance, kDistanceBits);
  light.add(command.light.source.z, kCoordinateBits);
  light.add(command.light.source.y, kCoordinateBits);
  light.add(command.light.source.x, kCoordinateBits);
  return Beat(light.bits() << kLightAt | (command.start ? 2U : 0U) | (command.clear ? 1U : 0U));
}

CellCommand unpack_command(const Beat& beat) {
  CellCommand command{(beat.low() & 1U) != 0, (beat.low() & 2U) != 0, {}};
  Fields light(beat.low() >> kLightAt);
  command.light.fa = light.next(kQueueBits);
  command.light.target_distance = light.next(kDistanceBits);
  command.light.source.z = light.next(kCoordinateBits);
  command.light.source.y = light.next(kCoordinateBits);
  command.light.source.x = light.next(kCoordinateBits);
  return command;
}

Beat pack_beam(const LinkBeam& beam) {
  Fields fields;
  fields.add(beam.v_max, kTargetBits);
  fields.add(beam.v_min, kTargetBits);
  fields.add(beam.u_max, kTargetBits);
  fields.add(beam.u_min, kTargetBits);
  fields.add(beam.z, kCoordinateBits);
  fields.add(beam.dir, kDirBits);
  return Beat(fields.bits());
}

LinkBeam unpack_beam(const Beat& beat) {
  Fields fields(beat.low());
  LinkBeam beam{};
  beam.v_max = fields.next_signed(kTargetBits);
  beam.v_min = fields.next_signed(kTargetBits);
  beam.u_max = fields.next_signed(kTargetBits);
  beam.u_min = fields.next_signed(kTargetBits);
  beam.z = fields.next(kCoordinateBits);
  beam.dir = fields.next(kDirBits);
  return beam;
}

Beat pack_data(std::uint64_t readback) {
  Beat beat(HostWord(kFormat, Word{WordKind::data}, Leads::cells));
  beat.limbs[0] |= static_cast<std::uint32_t>(readback);
  beat.limbs[1] |= static_cast<std::uint32_t>(readback >> 32);
  return beat;
}

}  // namespace rc2::tb
