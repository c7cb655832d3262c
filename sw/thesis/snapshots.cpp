#include "sw/thesis/snapshots.h"

#include <fmt/format.h>

#include "sw/base/error.h"
#include "sw/picture/contact_sheet.h"
#include "sw/thesis/engine.h"

namespace rc2::thesis {
namespace {

constexpr picture::Colour kBlack = {0, 0, 0};
constexpr picture::Colour kWhite = {255, 255, 255};

void draw_row(picture::ContactSheet& sheet, int row, const Engine& engine, int n) {
  const auto draw = [&](int column, auto black) {
    sheet.draw(row, column, [&](int x, int y) { return black(x, y) ? kBlack : kWhite; });
  };
  sheet.label(row, engine.cycles());
  for (int z = 0; z < n; ++z) {
    draw(z, [&](int x, int y) { return engine.reached({x, y, z}); });
  }
  draw(n + 1, [&](int x, int y) { return engine.busy(x, y); });
}

}  // namespace

ContactSheet draw_contact_sheet(const Experiment& experiment,
                                const std::vector<std::int64_t>& times) {
  ContactSheet result;
  const int n = experiment.n;
  picture::ContactSheet sheet(n, n + 2, static_cast<int>(times.size()) + 1, kMaxSheetSide);
  Engine engine(experiment);
  const auto add_row = [&] {
    draw_row(sheet, static_cast<int>(result.times.size()), engine, n);
    result.times.push_back(engine.cycles());
  };
  auto next = times.begin();
  for (; !engine.done(); engine.step()) {
    if (next != times.end() && *next == engine.cycles()) {
      add_row();
      ++next;
    }
  }
  if (next != times.end()) {
    throw Error(
        fmt::format("--times {}: the diffusion is over after {} cycles; choose earlier "
                    "times, each one later than the one before",
                    *next, engine.cycles()));
  }
  add_row();
  result.raster = sheet.take();
  return result;
}

}  // namespace rc2::thesis
