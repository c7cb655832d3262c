#include "tb/systemc/bench.h"

#include <fmt/format.h>

#include <algorithm>

namespace rc2::tb {
namespace {

// Cycles without any beat after which a unit is taken to hang.
constexpr std::int64_t kPatience = 20000;

Streams make_streams(const std::vector<StreamName>& names) {
  Streams streams;
  for (const StreamName& name : names) streams.push_back(std::make_unique<Stream>(name));
  return streams;
}

std::string line(const std::string& name, const Monitor& monitor, Pacer& pacer) {
  const auto& habits = pacer.cycles();
  const auto met =
      std::count_if(habits.begin(), habits.end(), [](std::int64_t cycles) { return cycles > 0; });
  return fmt::format("  {:<10} {:>9} beats, stalled in {:>9} cycles, {} of {} stall patterns\n",
                     name, monitor.counts().moved, monitor.counts().stalled, met, habits.size());
}

}  // namespace

Bench::Bench(const sc_core::sc_module_name& name, Unit& unit, Job& job, std::uint64_t seed,
             sc_core::sc_trace_file* trace)
    : sc_module(name),
      unit_(unit),
      job_(job),
      clock_("clk", kClockNanoseconds, sc_core::SC_NS),
      in_(make_streams(unit.names().in)),
      out_(make_streams(unit.names().out)),
      unit_module_("unit", clock_, unit, in_, out_),
      scoreboard_(make_scoreboard()),
      last_(out_.size()) {
  const auto ends = [&](std::size_t i, const StreamName& stream, const char* end) {
    return std::make_pair(seed * 64 + i, stream.name + end);
  };
  const auto moved = [this] { last_move_ = this_cycle(); };
  for (std::size_t i = 0; i < in_.size(); ++i) {
    const auto [own_seed, end] = ends(i, unit.names().in[i], "_driver");
    drivers_.push_back(std::make_unique<Driver>(end.c_str(), clock_, *in_[i], own_seed));
    in_monitors_.push_back(std::make_unique<Monitor>((end + "_monitor").c_str(), clock_, *in_[i],
                                                     [moved](const Beat&) { moved(); },
                                                     [](const Beat&, const Beat*) {}));
  }
  for (std::size_t i = 0; i < out_.size(); ++i) {
    const auto [own_seed, end] = ends(in_.size() + i, unit.names().out[i], "_sink");
    sinks_.push_back(std::make_unique<Sink>(end.c_str(), clock_, *out_[i], own_seed));
    out_monitors_.push_back(std::make_unique<Monitor>((end + "_monitor").c_str(), clock_, *out_[i],
                                                      [this, i, moved](const Beat& beat) {
                                                        moved();
                                                        last_[i] = beat;
                                                        scoreboard_.check(i, this_cycle(), beat);
                                                      },
                                                      [this, i](const Beat& held, const Beat* now) {
                                                        scoreboard_.broken_promise(i, this_cycle(),
                                                                                   held, now);
                                                      }));
  }
  if (trace != nullptr) {
    sc_core::sc_trace(trace, clock_, "clk");
    for (const auto& stream : in_) stream->trace(trace);
    for (const auto& stream : out_) stream->trace(trace);
  }
  SC_METHOD(edge);
  sensitive << clock_.negedge_event();  // when all have seen the rising edge
  dont_initialize();
}

Scoreboard Bench::make_scoreboard() const {
  std::vector<Scoreboard::Stream> streams;
  for (const StreamName& name : unit_.names().out) streams.push_back(job_.output(name));
  return Scoreboard(std::move(streams));
}

void Bench::reseed(std::uint64_t seed) {
  std::uint64_t own = seed * 64;
  for (const auto& driver : drivers_) driver->pacer().reseed(own++);
  for (const auto& sink : sinks_) sink->pacer().reseed(own++);
}

bool Bench::quiet() const {
  return scoreboard_.done() && std::all_of(drivers_.begin(), drivers_.end(),
                                           [](const auto& driver) { return driver->idle(); });
}

void Bench::edge() {
  if (!scoreboard_.difference() && !quiet() && this_cycle() - last_move_ > kPatience) {
    scoreboard_.silence(this_cycle(), kPatience);
  }
  if (scoreboard_.difference()) {
    sc_core::sc_stop();
  } else if (quiet() && --pause_ < 0) {
    last_move_ = this_cycle();
    if (!job_.next(*this)) sc_core::sc_stop();
  }
}

std::string Bench::summary() const {
  std::string text;
  for (std::size_t i = 0; i < in_.size(); ++i) {
    text += line(unit_.names().in[i].name, *in_monitors_[i], drivers_[i]->pacer());
  }
  for (std::size_t i = 0; i < out_.size(); ++i) {
    text += line(unit_.names().out[i].name, *out_monitors_[i], sinks_[i]->pacer());
  }
  return text;
}

}  // namespace rc2::tb
