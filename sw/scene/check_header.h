#pragma once

#include <string>

namespace rc2::scene {

/// Refuses a file whose header would lead Assimp astray: one that announces more vertices or faces
/// than the file has bytes (its readers of OFF and PLY reserve memory for what the header says
/// before they look for it), and a PLY header that does not end (its reader never ends either).
/// Throws Error; files of other formats, or with a header that is not understood, pass.
void check_header(const std::string& path);

}  // namespace rc2::scene
