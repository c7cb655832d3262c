#pragma once

#include <string>

#include "sw/picture/image.h"

namespace rc2::picture {

/// Writes every channel of the image as OpenEXR scan lines: R, G, B, Z, N.X, N.Y, N.Z (float),
/// facet.id, light0, light1, ... (uint), and the attributes "software" and "rc2.n".
/// Throws Error, and leaves no file, if the path cannot be written.
void write_exr(const std::string& path, const Image& image);

}  // namespace rc2::picture
