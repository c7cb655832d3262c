#include "sw/thesis/tables.h"

#include <fmt/format.h>

#include "sw/thesis/engine.h"

namespace rc2::thesis {
namespace {

void check_range(const char* option, Range range, int lowest, int highest) {
  if (range.first < lowest || range.last > highest || range.first > range.last) {
    throw Error(
        fmt::format("{} {}..{} is no range of this table; choose A..B with {} <= A <= B <= {}",
                    option, range.first, range.last, lowest, highest));
  }
}

std::string compare_modes(int n, const char* cones, const Experiment& beams) {
  const Experiment rays = one_by_one(beams);
  const Cost slow = run(rays);
  const Cost fast = run(beams);
  return fmt::format("{},{},{},{},{},{},{}\n", n, cones, rays.cones.size(), slow.cycles,
                     fast.cycles, slow.visits, fast.visits);
}

const char* heading(Table table) {
  switch (table) {
    case Table::kFaMax:
      return "n,fa_needed,t\n";
    case Table::kFa1:
      return "n,t\n";
    case Table::kFaSweep:
      return "n,fa,t\n";
    case Table::kModes:
      break;
  }
  return "n,cones,rays,t_one_by_one,t_beams,visits_one_by_one,visits_beams\n";
}

std::string rows(const TableRequest& request, int n, int fa) {
  switch (request.table) {
    case Table::kFaMax: {
      const Cost cost = run(one_cone(n, 2));
      return fmt::format("{},{},{}\n", n, cost.longest_queue, cost.cycles);
    }
    case Table::kFa1:
      return fmt::format("{},{}\n", n, run(corner(n, 1, request.conflict)).cycles);
    case Table::kFaSweep:
      return fmt::format("{},{},{}\n", n, fa, run(corner(n, fa, request.conflict)).cycles);
    case Table::kModes:
      break;
  }
  return compare_modes(n, "plane", plane(n)) + compare_modes(n, "x", one_cone(n, 0)) +
         compare_modes(n, "z", one_cone(n, 2)) + compare_modes(n, "xyz", corner(n, {}));
}

// A diffusion serves about as many beams as there are voxels.
double work_up_to(int n) {
  const double side = n;
  return side * side * side * side;
}

}  // namespace

void check(const TableRequest& request) {
  check_range("--n", request.n, request.table == Table::kFaMax ? 1 : 2, kMaxSide);
  if (request.table == Table::kFaSweep) {
    if (!request.fa) throw Error("the table fa_sweep needs its queues; add --fa A..B");
    check_range("--fa", *request.fa, 1, kMaxFa);
  } else if (request.fa) {
    throw Error("only the table fa_sweep has a choice of queues; leave --fa out");
  }
}

std::string to_csv(const TableRequest& request, const Progress& progress) {
  const Range queues = request.fa.value_or(Range{1, 1});
  const double begin = work_up_to(request.n.first - 1);
  const double all = work_up_to(request.n.last) - begin;
  std::string csv = heading(request.table);
  for (int n = request.n.first; n <= request.n.last; ++n) {
    for (int fa = queues.first; fa <= queues.last; ++fa) {
      if (progress) {
        const double of_row = work_up_to(n) - work_up_to(n - 1);
        const double share = static_cast<double>(fa - queues.first) /
                             static_cast<double>(queues.last - queues.first + 1);
        progress("table", 0, (work_up_to(n - 1) - begin + share * of_row) / all);
      }
      csv += rows(request, n, fa);
    }
  }
  return csv;
}

}  // namespace rc2::thesis
