// Many small square pictures in one: a row for each of some times, a column for each thing shown.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>

#include "sw/picture/raster.h"

namespace rc2::picture {

using Colour = std::array<std::uint8_t, 3>;

class ContactSheet {
 public:
  /// Pictures of n x n squares, each square as large as makes a picture's side `side` pixels at
  /// most, but no smaller than a pixel. A picture that is never drawn is background.
  ContactSheet(int n, int columns, int rows, int side);

  /// Writes a number of up to six digits in front of a row.
  void label(int row, std::int64_t number);

  /// colour(x, y) of each square; y goes upwards.
  void draw(int row, int column, const std::function<Colour(int x, int y)>& colour);

  Raster take() { return std::move(raster_); }

 private:
  int side() const { return n_ * square_; }
  int top(int row) const;
  int left(int column) const;
  void fill(int left, int top, int side, Colour colour);

  int n_, square_;
  Raster raster_;
};

}  // namespace rc2::picture
