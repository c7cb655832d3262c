#include "sw/thesis/snapshots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "sw/base/error.h"
#include "sw/thesis/engine.h"

namespace rc2::thesis {
namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour kBlack = {0, 0, 0};
constexpr Colour kWhite = {255, 255, 255};
constexpr Colour kPaper = {190, 200, 210};
constexpr int kGap = 6;
constexpr int kDigits = 6;      // a label has room for so many
constexpr int kDigitPixel = 3;  // side of a dot of a digit
constexpr int kDigitStep = 4 * kDigitPixel;

// Digits three dots wide and five high, row after row.
constexpr std::array<const char*, 10> kFont = {
    "####.##.##.####", "..#..#..#..#..#", "###..#####..###", "###..####..####", "#.##.####..#..#",
    "####..###..####", "####..####.####", "###..#..#..#..#", "####.#####.####", "####.####..####"};

class Sheet {
 public:
  Sheet(int n, std::size_t rows) : n_(n), square_(std::max(1, kMaxSheetSide / n)) {
    raster_.width = slice_left(n_ + 1) + slice() + kGap;
    raster_.height = static_cast<int>(rows) * (slice() + kGap) + kGap;
    raster_.pixels.assign(
        static_cast<std::size_t>(raster_.width) * static_cast<std::size_t>(raster_.height), kPaper);
  }

  void add_row(const Engine& engine) {
    draw_number(engine.cycles());
    for (int z = 0; z < n_; ++z) {
      draw_slice(slice_left(z), [&](int x, int y) { return engine.reached({x, y, z}); });
    }
    draw_slice(slice_left(n_ + 1), [&](int x, int y) { return engine.busy(x, y); });
    top_ += slice() + kGap;
  }

  picture::Raster take() { return std::move(raster_); }

 private:
  int slice() const { return n_ * square_; }
  int slice_left(int index) const { return kGap + kDigits * kDigitStep + index * (slice() + kGap); }

  void fill(int left, int top, int side, Colour colour) {
    for (int row = top; row < top + side; ++row) {
      std::fill_n(raster_.pixels.begin() + std::ptrdiff_t{row} * raster_.width + left, side,
                  colour);
    }
  }

  void draw_slice(int left, const std::function<bool(int, int)>& black) {
    for (int y = 0; y < n_; ++y) {
      for (int x = 0; x < n_; ++x) {
        fill(left + x * square_, top_ + (n_ - 1 - y) * square_, square_,
             black(x, y) ? kBlack : kWhite);
      }
    }
  }

  void draw_number(std::int64_t number) {
    const std::string digits = fmt::format("{:>{}}", number, kDigits);
    for (std::size_t i = 0; i < digits.size(); ++i) {
      if (digits[i] == ' ') continue;
      const char* dots = kFont[static_cast<std::size_t>(digits[i] - '0')];
      for (int dot = 0; dot < 15; ++dot) {
        if (dots[dot] == '.') continue;
        fill(static_cast<int>(i) * kDigitStep + dot % 3 * kDigitPixel, top_ + dot / 3 * kDigitPixel,
             kDigitPixel, kBlack);
      }
    }
  }

  int n_, square_;
  int top_ = kGap;
  picture::Raster raster_;
};

}  // namespace

ContactSheet draw_contact_sheet(const Experiment& experiment,
                                const std::vector<std::int64_t>& times) {
  ContactSheet result;
  Sheet sheet(experiment.n, times.size() + 1);
  Engine engine(experiment);
  const auto add_row = [&] {
    sheet.add_row(engine);
    result.times.push_back(engine.cycles());
  };
  auto next = times.begin();
  for (; !engine.done(); engine.step()) {
    if (next != times.end() && *next == engine.cycles()) {
      add_row();
      ++next;
    }
  }
  if (next != times.end()) {
    throw Error(
        fmt::format("--times {}: the diffusion is over after {} cycles; choose earlier "
                    "times, each one later than the one before",
                    *next, engine.cycles()));
  }
  add_row();
  result.raster = sheet.take();
  return result;
}

}  // namespace rc2::thesis
