#pragma once

#include <string>

#include "sw/picture/raster.h"

namespace rc2::picture {

/// Writes an 8-bit sRGB PNG. Throws Error, and leaves no file, if the path cannot be written.
void write_png(const std::string& path, const Raster& raster);

}  // namespace rc2::picture
