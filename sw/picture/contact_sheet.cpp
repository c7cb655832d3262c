#include "sw/picture/contact_sheet.h"

#include <algorithm>
#include <string>

namespace rc2::picture {
namespace {

constexpr Colour kInk = {0, 0, 0};
constexpr Colour kPaper = {190, 200, 210};
constexpr int kGap = 6;
constexpr int kDigits = 6;      // a label has room for so many
constexpr int kDigitPixel = 3;  // side of a dot of a digit
constexpr int kDigitStep = 4 * kDigitPixel;

// Digits three dots wide and five high, row after row.
constexpr std::array<const char*, 10> kFont = {
    "####.##.##.####", "..#..#..#..#..#", "###..#####..###", "###..####..####", "#.##.####..#..#",
    "####..###..####", "####..####.####", "###..#..#..#..#", "####.#####.####", "####.####..####"};

}  // namespace

ContactSheet::ContactSheet(int n, int columns, int rows, int side)
    : n_(n), square_(std::max(1, side / n)) {
  raster_.width = left(columns);
  raster_.height = top(rows);
  raster_.pixels.assign(
      static_cast<std::size_t>(raster_.width) * static_cast<std::size_t>(raster_.height), kPaper);
}

int ContactSheet::top(int row) const { return kGap + row * (side() + kGap); }

int ContactSheet::left(int column) const {
  return kGap + kDigits * kDigitStep + column * (side() + kGap);
}

void ContactSheet::fill(int left, int top, int side, Colour colour) {
  for (int row = top; row < top + side; ++row) {
    std::fill_n(raster_.pixels.begin() + std::ptrdiff_t{row} * raster_.width + left, side, colour);
  }
}

void ContactSheet::draw(int row, int column, const std::function<Colour(int, int)>& colour) {
  for (int y = 0; y < n_; ++y) {
    for (int x = 0; x < n_; ++x) {
      fill(left(column) + x * square_, top(row) + (n_ - 1 - y) * square_, square_, colour(x, y));
    }
  }
}

void ContactSheet::label(int row, std::int64_t number) {
  std::string digits = std::to_string(number);
  digits = std::string(kDigits - digits.size(), ' ') + digits;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (digits[i] == ' ') continue;
    const char* dots = kFont[static_cast<std::size_t>(digits[i] - '0')];
    for (int dot = 0; dot < 15; ++dot) {
      if (dots[dot] == '.') continue;
      fill(static_cast<int>(i) * kDigitStep + dot % 3 * kDigitPixel,
           top(row) + dot / 3 * kDigitPixel, kDigitPixel, kInk);
    }
  }
}

}  // namespace rc2::picture
