// The bench around a unit: a driver or a sink and a monitor for each stream, a scoreboard, and a
// job that says what to send and what to expect, without knowing of time.
#pragma once

#include <memory>
#include <string>
#include <systemc>
#include <vector>

#include "tb/systemc/ends.h"
#include "tb/systemc/monitor.h"
#include "tb/systemc/scoreboard.h"
#include "tb/systemc/unit_module.h"

namespace rc2::tb {

class Bench;

/// What happens to a unit, step by step. A step begins when all that was sent has been taken and
/// all that was expected has come.
class Job {
 public:
  Job() = default;
  virtual ~Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// What the beats of an output mean, and their order.
  virtual Scoreboard::Stream output(const StreamName& name) const = 0;

  /// Begins the next step; false if there is none.
  virtual bool next(Bench& bench) = 0;
};

class Bench : public sc_core::sc_module {
 public:
  /// `trace`: where the waveform goes, or null. All must outlive the bench.
  Bench(const sc_core::sc_module_name& name, Unit& unit, Job& job, std::uint64_t seed,
        sc_core::sc_trace_file* trace);

  // ---- For the job; streams are numbered as in the unit's names ------------------------------
  void send(std::size_t in, const Beat& beat) { drivers_[in]->send(beat); }
  void expect(std::size_t out, const Expectation& wanted) { scoreboard_.expect(out, wanted); }
  /// The last beat that came.
  const Beat& last(std::size_t out) const { return last_[out]; }
  /// The step lasts so many cycles more.
  void pause(std::int64_t cycles) { pause_ = cycles; }
  /// From here on the stalls follow from this number.
  void reseed(std::uint64_t seed);

  // ---- What came of it -----------------------------------------------------------------------
  const Scoreboard& scoreboard() const { return scoreboard_; }
  /// A line for each stream: beats, cycles stalled, habits of its pacer.
  std::string summary() const;

 private:
  SC_HAS_PROCESS(Bench);
  void edge();
  bool quiet() const;
  Scoreboard make_scoreboard() const;

  Unit& unit_;
  Job& job_;
  sc_core::sc_clock clock_;
  Streams in_, out_;
  UnitModule unit_module_;
  Scoreboard scoreboard_;
  std::vector<std::unique_ptr<Driver>> drivers_;
  std::vector<std::unique_ptr<Sink>> sinks_;
  std::vector<std::unique_ptr<Monitor>> in_monitors_, out_monitors_;
  std::vector<Beat> last_;
  std::int64_t pause_ = 0, last_move_ = 0;
};

}  // namespace rc2::tb
