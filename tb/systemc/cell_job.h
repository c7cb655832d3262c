// Random jobs for one cell: packets on the row pipe, then beams on all links, and after each the
// cell's answers.
#pragma once

#include <deque>
#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "sw/golden/golden_machine.h"
#include "sw/machine/readback.h"
#include "tb/load/dice.h"
#include "tb/systemc/bench.h"
#include "tb/systemc/cell_unit.h"
#include "tb/systemc/light_reference.h"

namespace rc2::tb {

class CellJob final : public Job {
 public:
  CellJob(glm::ivec2 cell, std::uint64_t seed, std::int64_t jobs);

  Scoreboard::Stream output(const StreamName& name) const override;

  /// In each job forgets the voxels, loads random packets of all layers and reads voxels and layers
  /// back; then twice sends random beams and reads back what arrived.
  bool next(Bench& bench) override;

 private:
  void load(Bench& bench);
  void light(Bench& bench);
  void send_beams(Bench& bench, const LightReference& reference);
  // What the light does from these numbers in light_ on.
  void expect_light(Bench& bench, std::size_t sent, std::size_t home);
  void read_light(Bench& bench);
  void ask(Bench& bench, ReadWhat what, const Readback& answer);
  // A word that comes out as it went in.
  void pass(Bench& bench, const Beat& word);
  void expect_word(Bench& bench, const Beat& word) { bench.expect(kWordsOut, {cell_, word}); }
  void command(Bench& bench, const CellCommand& command);

  glm::ivec2 cell_;
  std::int64_t jobs_;
  facet::Dice dice_;
  WordFormat format_{kArray};
  golden::GoldenMachine golden_{kArray};
  VoxelMemory column_;  // the cell's voxels
  CellLight light_;     // what the light under way does to the cell
  std::deque<std::function<void(Bench&)>> plan_;
};

}  // namespace rc2::tb
