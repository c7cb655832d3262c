#include "sim/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace rc2 {
namespace {

using Seconds = std::chrono::duration<double>;
using namespace std::chrono_literals;

constexpr int kBarWidth = 20;

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress ProgressBar::step(const std::string& title) {
  wipe();
  title_ = title;
  start_ = Clock::now();
  next_ = start_ + (terminal_ ? 1s : 10s);
  return [this](const char*, std::int64_t cycles, double share) { show(cycles, share); };
}

void ProgressBar::wipe() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
  drawn_ = false;
}

void ProgressBar::show(std::int64_t cycles, double share) {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + (terminal_ ? Clock::duration(200ms) : Clock::duration(10s));

  const double seconds = Seconds(now - start_).count();
  share = std::clamp(share, 0.0, 1.0);
  std::string line = fmt::format("{}: {:.0f} %", title_, 100 * share);
  if (cycles > 0) {
    line +=
        fmt::format(", {} cycles, {:.0f} cycles/s", cycles, static_cast<double>(cycles) / seconds);
  }
  if (share > 0) line += fmt::format(", {:.0f} s left", seconds * (1 - share) / share);
  if (terminal_) {
    const auto filled = static_cast<std::size_t>(share * kBarWidth);
    fmt::print(stderr, "\r\033[K[{:-<{}}] {}", std::string(filled, '#'), kBarWidth, line);
    drawn_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
}

}  // namespace rc2
