// rc2_run against a search voxel by voxel, for every column of n = 8 and every beginning.
#include "tb/rtl/block.h"

namespace {

TEST(Run, IsTheFirstRunAtOrAboveAVoxel) {
  constexpr unsigned kN = 8;
  rc2::tb::Module<Vtop> run;
  for (unsigned stops = 0; stops < 1U << kN; ++stops) {
    const auto stop = [&](unsigned z) { return (stops >> z & 1U) != 0; };
    for (unsigned from = 0; from <= kN; ++from) {
      unsigned first = from;
      while (first < kN && !stop(first)) ++first;
      unsigned end = first;
      while (end < kN && stop(end)) ++end;
      run.stops_i = static_cast<CData>(stops);
      run.from_i = static_cast<CData>(from);
      run.eval();
      ASSERT_EQ(run.found_o, first < kN ? 1 : 0) << "stops " << stops << " from " << from;
      if (first == kN) continue;
      ASSERT_EQ(run.first_o, first) << "stops " << stops << " from " << from;
      ASSERT_EQ(run.end_o, end) << "stops " << stops << " from " << from;
    }
  }
}

}  // namespace
