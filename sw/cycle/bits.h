// Small sets as bits of a word.
#pragma once

namespace rc2::cycle {

/// The lowest member of a set that is not empty.
inline unsigned first_of(unsigned set) { return static_cast<unsigned>(__builtin_ctz(set)); }

/// The set without its lowest member.
inline unsigned without_first(unsigned set) { return set & (set - 1); }

}  // namespace rc2::cycle
