// The words of facet packets as they stand before a cell of a row pipe, from the packets alone.
#pragma once

#include <vector>

#include "sw/facet/packet.h"
#include "sw/machine/word.h"

namespace rc2::tb {

/// What comes to cell (x,y); nothing if the packet serves neither this cell nor one to its east.
/// What leaves the cell is what comes to (x+1,y).
std::vector<Word> words_before(int x, int y, const facet::PacketHead& packet,
                               const facet::Side* sides);

}  // namespace rc2::tb
