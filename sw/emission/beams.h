// Rays that travel together while their ways are the same (4.2.5), without time or queues.
#pragma once

#include "sw/emission/ledger.h"
#include "sw/emission/path_table.h"

namespace rc2::emission {

/// Six beams to the virtual faces at distance n - 1; a cell works out where a beam parts (4.3.4).
void send_beams(Ledger& ledger, const glm::ivec3& source);

/// The same beams, each known by the way that it has come: a cell looks it up in a table and finds
/// the ways that go on (4.3.2). Returns how many entries of tables were looked at.
std::int64_t send_beams_by_table(Ledger& ledger, const glm::ivec3& source);

}  // namespace rc2::emission
