// How much a picture differs from the one that it should be.
#pragma once

#include "sw/picture/image.h"

namespace rc2::picture {

struct Difference {
  double wrong = 0;  ///< share of the pixels whose colour is off by more than 0.05, rms of channels
  double rmse = 0;   ///< of all channels, linear and clamped to 0..1
  double flip = 0;   ///< mean error that one sees when the pictures alternate, 0..1
};

/// Compares the colours of two pictures of the same size.
Difference difference(const Image& image, const Image& reference);

/// Andersson et al., FLIP: A Difference Evaluator for Alternating Images (2020), with the
/// constants of the paper: the mean over the pixels, of colours clamped to 0..1, for an eye to
/// which 67.02 pixels are a degree.
double flip(const Image& image, const Image& reference);

}  // namespace rc2::picture
