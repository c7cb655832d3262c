// rc2_cell_thesis through Verilator. The array's broadcasts come from a command stream, and the
// targets that come home, which nothing can hold up, wait in a queue of their own.
#include <deque>

#include "Vrc2_cell_thesis.h"
#include "tb/systemc/cell_unit.h"
#include "tb/systemc/verilated_unit.h"

namespace rc2::tb {
namespace {

class RtlCell final : public VerilatedUnit<Vrc2_cell_thesis> {
 public:
  RtlCell(glm::ivec2 cell, const std::string& waves) : VerilatedUnit(waves), cell_(cell) {}

  const StreamNames& names() const override { return names_; }

 private:
  void drive(Vrc2_cell_thesis& top, const UnitPins& pins) override {
    top.x_i = static_cast<CData>(cell_.x);
    top.y_i = static_cast<CData>(cell_.y);
    const Pins& command = pins.in[kCommandIn];
    top.clear_i = command.valid && (command.beat.low() & 1U) != 0;
    top.start_i = command.valid && (command.beat.low() & 2U) != 0;
    // A light's constants are there from its start on.
    top.light_i = command.valid ? command.beat.limbs[1] : light_;
    top.home_i = 0;
    top.word_valid_i = pins.in[kWordsIn].valid;
    put(top.word_i, pins.in[kWordsIn].beat);
    top.word_ready_i = pins.out[kWordsOut].ready;
    unsigned valid = 0, ready = 0;
    for (std::size_t d = 0; d < kLinks; ++d) {
      valid |= static_cast<unsigned>(pins.in[kLinkIn + d].valid) << d;
      ready |= static_cast<unsigned>(pins.out[kLinkOut + d].ready) << d;
    }
    top.link_valid_i = static_cast<CData>(valid);
    top.link_ready_i = static_cast<CData>(ready);
    put(top.link0_i, pins.in[kLinkIn].beat);
    put(top.link1_i, pins.in[kLinkIn + 1].beat);
    put(top.link2_i, pins.in[kLinkIn + 2].beat);
    put(top.link3_i, pins.in[kLinkIn + 3].beat);
    put(top.link4_i, pins.in[kLinkIn + 4].beat);
    put(top.link5_i, pins.in[kLinkIn + 5].beat);
    put(top.link6_i, pins.in[kLinkIn + 6].beat);
    put(top.link7_i, pins.in[kLinkIn + 7].beat);
  }

  void observe(const Vrc2_cell_thesis& top, UnitPins& pins) override {
    pins.in[kCommandIn].ready = true;
    pins.in[kWordsIn].ready = top.word_ready_o != 0;
    pins.out[kWordsOut].valid = top.word_valid_o != 0;
    pins.out[kWordsOut].beat = get(top.word_o);
    for (std::size_t d = 0; d < kLinks; ++d) {
      pins.in[kLinkIn + d].ready = (top.link_ready_o >> d & 1U) != 0;
      pins.out[kLinkOut + d].valid = (top.link_valid_o >> d & 1U) != 0;
    }
    pins.out[kLinkOut].beat = get(top.link0_o);
    pins.out[kLinkOut + 1].beat = get(top.link1_o);
    pins.out[kLinkOut + 2].beat = get(top.link2_o);
    pins.out[kLinkOut + 3].beat = get(top.link3_o);
    pins.out[kLinkOut + 4].beat = get(top.link4_o);
    pins.out[kLinkOut + 5].beat = get(top.link5_o);
    pins.out[kLinkOut + 6].beat = get(top.link6_o);
    pins.out[kLinkOut + 7].beat = get(top.link7_o);
    pins.out[kHomeOut].valid = !home_.empty();
    if (!home_.empty()) pins.out[kHomeOut].beat = Beat(home_.front());
  }

  void before_edge(const Vrc2_cell_thesis& top, const UnitPins& pins) override {
    if (pins.out[kHomeOut].valid && pins.out[kHomeOut].ready) home_.pop_front();
    if (top.home_o != 0) home_.push_back(top.home_o);
    light_ = top.light_i;
  }

  glm::ivec2 cell_;
  QData light_ = 0;
  std::deque<std::uint64_t> home_;
  StreamNames names_ = cell_streams();
};

}  // namespace

std::unique_ptr<Unit> make_rtl_cell(glm::ivec2 cell, const std::string& waves) {
  return std::make_unique<RtlCell>(cell, waves);
}

}  // namespace rc2::tb
