#pragma once

#include <string>

namespace rc2 {

/// Puts `bytes` into the file `path`, whole or not at all: they go to a temporary file beside it,
/// which then takes its name. Throws Error (path, why, mend) and leaves what was there before.
void replace_file(const std::string& path, const std::string& bytes);

}  // namespace rc2
