// One cell of the cycle model behind the pins of rc2_cell_thesis: the stage of the row pipe with
// its loading units, and the cell's router and beam engine out of a whole array's, whose other
// cells stay empty. The model has no readback of its own; here it is a list of words.
#include <deque>

#include "sw/cycle/cell.h"
#include "sw/cycle/cell_loader.h"
#include "sw/cycle/diffuser.h"
#include "sw/cycle/facet_stage.h"
#include "tb/systemc/cell_unit.h"
#include "tb/systemc/cycle_answer.h"

namespace rc2::tb {
namespace {

LinkBeam outside(const cycle::Beam& beam) {
  return {beam.dir, beam.z, beam.u.min, beam.u.max, beam.v.min, beam.v.max};
}

cycle::Beam inside(const LinkBeam& beam) {
  return {cycle::range(beam.u_min, beam.u_max), cycle::range(beam.v_min, beam.v_max),
          static_cast<std::uint16_t>(beam.z), static_cast<std::uint8_t>(beam.dir)};
}

class CycleCell final : public Unit {
 public:
  explicit CycleCell(glm::ivec2 at) : at_(at), cell_(cycle::cell_number(at.x, at.y, kArray.n)) {}

  const StreamNames& names() const override { return names_; }

  void settle(UnitPins& pins) override {
    pins.in[kCommandIn].ready = true;
    pins.in[kWordsIn].ready = stage_.ready();
    Pins& words = pins.out[kWordsOut];
    words.valid = !data_.empty() || (stage_.busy() && stage_.on() && may_leave());
    if (words.valid) words.beat = data_.empty() ? leaving_word() : pack_data(data_.front());
    for (unsigned d = 0; d < kLinks; ++d) {
      pins.in[kLinkIn + d].ready = router_.has_room(cell_, d);
      Pins& link = pins.out[kLinkOut + d];
      link.valid = (router_.full_links(cell_) >> d & 1U) != 0;
      if (link.valid) link.beat = pack_beam(outside(router_.on_link(cell_, d)));
    }
    pins.out[kHomeOut].valid = !home_.empty();
    if (!home_.empty()) pins.out[kHomeOut].beat = Beat(home_.front());
  }

  void clock(const UnitPins& pins) override {
    const auto moves = [](const Pins& stream) { return stream.valid && stream.ready; };
    if (moves(pins.out[kHomeOut])) home_.pop_front();
    step_pipe(moves(pins.out[kWordsOut]), pins.out[kWordsOut].ready);
    for (unsigned d = 0; d < kLinks; ++d) {
      if (moves(pins.out[kLinkOut + d])) router_.release(cell_, d);
      if (moves(pins.in[kLinkIn + d])) {
        router_.receive(cell_, d, inside(unpack_beam(pins.in[kLinkIn + d].beat)));
      }
    }
    step_light();
    if (moves(pins.in[kWordsIn])) {
      stage_.push(unpack_word(format_, pins.in[kWordsIn].beat.limbs, Leads::cells));
    }
    if (moves(pins.in[kCommandIn])) obey(unpack_command(pins.in[kCommandIn].beat));
  }

 private:
  // ---- Row pipe --------------------------------------------------------------------------------
  // The unit beside the stage, if the word concerns it, lets it go.
  bool may_leave() const {
    if (!stage_.here()) return true;
    const Word& word = stage_.front();
    if (word.kind == WordKind::read) return answered_;
    return loader_.ready(word);
  }

  Beat leaving_word() const { return Beat(HostWord(format_, stage_.stepped(), Leads::cells)); }

  void step_pipe(bool moved, bool ready) {
    const bool read = stage_.busy() && stage_.front().kind == WordKind::read;
    const bool leaves = stage_.busy() && data_.empty() && may_leave() && (!stage_.on() || ready);
    const bool concerns = stage_.busy() && stage_.here() && !read;
    if (moved && !data_.empty()) data_.pop_front();
    if (read && !answered_ && !loader_.filling()) {
      begin_answer(static_cast<ReadWhat>(stage_.front().d));
      answered_ = true;
    } else if (read && leaves) {
      answered_ = false;
    }
    loader_.step(concerns ? &stage_.front() : nullptr, leaves, columns_, cell_);
    if (leaves) stage_.pop();
  }

  void begin_answer(ReadWhat what) {
    Readback readback(kArray);
    answer(columns_, kArray.n, cell_, what, readback);
    if (what == ReadWhat::counters) {
      readback.add({at_, 0}, static_cast<std::uint32_t>(diffuser_.visits()));
      readback.add({at_, 1}, static_cast<std::uint32_t>(diffuser_.max_queue()));
    }
    const auto beats = readback.beats()[cell_];
    data_.assign(beats.begin(), beats.end());
  }

  // ---- Light -----------------------------------------------------------------------------------
  void step_light() {
    const std::int64_t before = diffuser_.tally().home();
    diffuser_.step(cell_, 0);
    router_.merge(cell_);
    const std::int64_t ended = diffuser_.tally().home() - before;
    if (ended != 0) home_.push_back(static_cast<std::uint64_t>(ended));
  }

  void obey(const CellCommand& command) {
    if (command.clear) columns_.clear();
    if (!command.start) return;
    columns_.darken();
    router_.start(command.light);
    diffuser_.start(command.light);
  }

  glm::ivec2 at_;
  std::size_t cell_;
  StreamNames names_ = cell_streams();
  WordFormat format_{kArray};
  cycle::Columns columns_{kArray.n};
  cycle::FacetStage stage_{cycle::Pipe::row, 1};
  cycle::CellLoader loader_{kArray.n};
  cycle::Router router_{kArray.n};
  cycle::Diffuser diffuser_{kArray.n, columns_, router_};
  bool answered_ = false;
  std::deque<std::uint64_t> data_, home_;
};

}  // namespace

std::unique_ptr<Unit> make_cycle_cell(glm::ivec2 cell) { return std::make_unique<CycleCell>(cell); }

}  // namespace rc2::tb
