#include "tb/systemc/cell_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "tb/systemc/cell_words.h"
#include "tb/systemc/dense_packets.h"

namespace rc2::tb {
namespace {

constexpr int kRest = 12;  // cycles after which nothing moves in a cell that got nothing
const Progress kQuiet;

std::string describe_word(const WordFormat& format, const Beat& beat) {
  constexpr std::array kNames{"HEAD", "SLAB", "SIDE", "GAP", "READ", "DATA", "END", "no word"};
  const Word word = unpack_word(format, beat.limbs, Leads::cells);
  const std::string name = kNames[static_cast<std::size_t>(word.kind)];
  switch (word.kind) {
    case WordKind::head:
      return fmt::format("{} of facet {}, skip {}, take {}", name, word.facet, word.skip[0],
                         word.take[0]);
    case WordKind::data: {
      const ReadbackWord data = unpack_readback(format, beat.low());
      return data.empty ? name + " of an empty cell"
                        : fmt::format("{}: voxel z = {} holds {:#x}{}", name, data.z, data.value,
                                      data.last_of_cell ? ", the last" : "");
    }
    default:
      return fmt::format("{} with d = {}", name, word.d);
  }
}

// Real beams bring each target to a voxel once at most; random ones overlap, but must not bring
// more than the largest light has, for which the memory is built.
bool is_countable(const CellLight& light) {
  return std::all_of(light.absorbed.begin(), light.absorbed.end(), [](const auto& voxel) {
    return voxel.second <= total_targets(kArray.max_distance);
  });
}

std::string describe_beam(const Beat& beat) {
  constexpr std::array kDirs{"+x", "-x", "+y", "-y", "+z", "-z", "no face", "no face"};
  const LinkBeam beam = unpack_beam(beat);
  return fmt::format("beam {} at z = {}, targets {}..{} x {}..{}",
                     kDirs[static_cast<std::size_t>(beam.dir)], beam.z, beam.u_min, beam.u_max,
                     beam.v_min, beam.v_max);
}

}  // namespace

CellJob::CellJob(glm::ivec2 cell, std::uint64_t seed, std::int64_t jobs)
    : cell_(cell), jobs_(jobs), dice_(seed) {}

Scoreboard::Stream CellJob::output(const StreamName& name) const {
  if (name.name == "words_out") {
    return {name.name, [this](const Beat& beat) { return describe_word(format_, beat); },
            Order::kept, cell_};
  }
  // In which order the beams of different links are served is a matter of time.
  if (name.name == "home") {
    return {name.name,
            [](const Beat& beat) { return fmt::format("{} targets end here", beat.low()); },
            Order::free, cell_};
  }
  return {name.name, describe_beam, Order::free, cell_};
}

bool CellJob::next(Bench& bench) {
  if (plan_.empty()) {
    if (jobs_-- == 0) return false;
    plan_ = {[this](Bench& b) {
               command(b, {true, false, {}});
             },
             [this](Bench& b) { load(b); }, [this](Bench& b) { light(b); },
             [this](Bench& b) { light(b); }};
  }
  const auto step = std::move(plan_.front());
  plan_.pop_front();
  step(bench);
  return true;
}

void CellJob::command(Bench& bench, const CellCommand& command) {
  bench.send(kCommandIn, pack_command(command));
  bench.pause(kRest);
}

void CellJob::pass(Bench& bench, const Beat& word) {
  bench.send(kWordsIn, word);
  expect_word(bench, word);
}

void CellJob::load(Bench& bench) {
  const facet::PacketStream packets = dense_packets(dice_, kArray, 40, cell_);
  golden_.load(packets, kQuiet);
  auto batches = packets.batches;
  if (batches.empty()) {
    batches.push_back({0, static_cast<std::uint32_t>(packets.heads.size()), false});
  }
  for (const facet::Batch& batch : batches) {
    for (std::uint32_t i = 0; i < batch.count; ++i) {
      const facet::PacketHead& packet = packets.heads[batch.first + i];
      const facet::Side* sides = packets.sides.data() + packet.first_side;
      for (const Word& word : words_before(cell_.x, cell_.y, packet, sides)) {
        bench.send(kWordsIn, Beat(HostWord(format_, word, Leads::cells)));
      }
      for (const Word& word : words_before(cell_.x + 1, cell_.y, packet, sides)) {
        expect_word(bench, Beat(HostWord(format_, word, Leads::cells)));
      }
    }
    if (batch.ends_object) pass(bench, Beat(HostWord(format_, Word{WordKind::end}, Leads::cells)));
  }

  const auto elsewhere = [this](const auto& voxel) { return glm::ivec2(voxel.at) != cell_; };
  column_ = golden_.read_voxels();
  column_.erase(std::remove_if(column_.begin(), column_.end(), elsewhere), column_.end());
  LayerMemory layers = golden_.read_layers();
  layers.erase(std::remove_if(layers.begin(), layers.end(), elsewhere), layers.end());
  ask(bench, ReadWhat::voxels, readback_of(kArray, column_));
  ask(bench, ReadWhat::layers, readback_of(kArray, layers));
  bench.pause(kRest);
}

// Before the question come the answers of the cells to the west.
void CellJob::ask(Bench& bench, ReadWhat what, const Readback& answer) {
  for (std::int64_t i = dice_.roll(0, 3); i > 0; --i) {
    pass(bench, pack_data(dice_.bits() & ((std::uint64_t{1} << format_.readback_bits()) - 1)));
  }
  const Beat question(HostWord(format_, what, Leads::cells));
  bench.send(kWordsIn, question);
  const int number = cell_.y * kArray.n + cell_.x;
  const std::vector<std::uint64_t> beats = answer.beats()[static_cast<std::size_t>(number)];
  for (const std::uint64_t beat : beats) {
    Expectation wanted{cell_, pack_data(beat)};
    const ReadbackWord word = unpack_readback(format_, beat);
    // Of an empty cell only the flags mean anything; the deepest queue is a matter of time.
    if (word.empty) wanted.mask = pack_data(std::uint64_t{3} << (format_.readback_bits() - 2));
    if (what == ReadWhat::counters && word.z == 1) {
      wanted.mask = pack_data(~std::uint64_t{0} << format_.value);
    }
    bench.expect(kWordsOut, wanted);
  }
  expect_word(bench, question);
}

void CellJob::light(Bench& bench) {
  const auto coordinate = [this] { return static_cast<int>(dice_.roll(0, kArray.n - 1)); };
  glm::ivec3 source(coordinate(), coordinate(), coordinate());
  if (dice_.one_in(4)) source = glm::ivec3(cell_, source.z);
  const LightJob light{source, static_cast<int>(dice_.roll(1, kArray.max_distance)),
                       static_cast<int>(dice_.roll_size(kArray.max_fa))};
  std::vector<bool> occupied(static_cast<std::size_t>(kArray.n));
  for (const VoxelRecord& voxel : column_) occupied[static_cast<std::size_t>(voxel.at.z)] = true;
  const LightReference reference(cell_, occupied, light);
  light_ = {};
  reference.start(light_);
  expect_light(bench, 0, 0);
  command(bench, {false, true, light});
  plan_.push_front([this](Bench& last) { read_light(last); });
  plan_.push_front([this, reference](Bench& later) { send_beams(later, reference); });
}

void CellJob::read_light(Bench& bench) {
  LightMemory arrived;
  for (const VoxelRecord& voxel : column_) {
    const auto found = light_.absorbed.find(voxel.at.z);
    arrived.push_back(found == light_.absorbed.end() ? 0
                                                     : static_cast<std::uint32_t>(found->second));
  }
  Readback counters(kArray);
  counters.add({cell_, 0}, static_cast<std::uint32_t>(light_.visits));
  counters.add({cell_, 1}, 0);
  ask(bench, ReadWhat::light, readback_of(kArray, column_, arrived));
  ask(bench, ReadWhat::counters, counters);
  bench.pause(kRest);
}

void CellJob::send_beams(Bench& bench, const LightReference& reference) {
  const std::size_t sent = light_.sent.size(), home = light_.home.size();
  for (std::int64_t i = dice_.roll(0, 60); i > 0; --i) {
    LinkBeam beam = reference.passing(static_cast<int>(dice_.roll(0, 5)),
                                      static_cast<int>(dice_.roll(0, kArray.n - 1)));
    if (LightReference::is_empty(beam)) continue;
    const auto part = [this](int& min, int& max) {
      if (dice_.one_in(2)) return;
      min = static_cast<int>(dice_.roll(min, max));
      max = static_cast<int>(dice_.roll(min, max));
    };
    part(beam.u_min, beam.u_max);
    part(beam.v_min, beam.v_max);
    CellLight with_it = light_;
    reference.serve(beam, with_it);
    if (!is_countable(with_it)) continue;
    light_ = std::move(with_it);
    bench.send(kLinkIn + static_cast<std::size_t>(dice_.roll(0, kLinks - 1)), pack_beam(beam));
  }
  expect_light(bench, sent, home);
  bench.pause(kRest);
}

void CellJob::expect_light(Bench& bench, std::size_t sent, std::size_t home) {
  for (; sent < light_.sent.size(); ++sent) {
    const auto& [link, beam] = light_.sent[sent];
    bench.expect(kLinkOut + link, {cell_, pack_beam(beam)});
  }
  for (; home < light_.home.size(); ++home) {
    bench.expect(kHomeOut, {cell_, Beat(static_cast<std::uint64_t>(light_.home[home]))});
  }
}

}  // namespace rc2::tb
