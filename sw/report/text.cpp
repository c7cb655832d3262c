#include <fmt/format.h>

#include <algorithm>

#include "sw/report/report.h"

namespace rc2::report {
namespace {

// Lines of a name and a fact, and tables below them.
class Page {
 public:
  void line(const std::string& name, const std::string& fact) {
    text_ += fmt::format("{:<12}{}\n", name, fact);
  }

  /// Columns as wide as their widest word, right-aligned.
  void table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> width(rows.front().size(), 0);
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
    }
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        text_ += fmt::format("{}{:>{}}", i == 0 ? "  " : "   ", row[i], width[i]);
      }
      text_ += '\n';
    }
  }

  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

// "3 more, 1 other" of the counts that are not zero.
std::string nonzero(const std::vector<std::pair<std::int64_t, const char*>>& counts) {
  std::string list;
  for (const auto& [count, what] : counts) {
    if (count != 0) list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, what);
  }
  return list;
}

std::string machine_words(const Report& report) {
  const std::string size = fmt::format("{0} x {0} cells with columns of {0} voxels", report.n);
  if (report.machine == "golden") return "golden model (it has no clock): " + size;
  return (report.machine == "rtl" ? "Verilated array: " : "cycle model: ") + size;
}

void scene_lines(Page& page, const Report& report) {
  page.line("scene", fmt::format("{}, {}", report.scene,
                                 report.fit == "cube" ? "fitted to the cube" : "in voxel units"));
  page.line("machine", machine_words(report));
  page.line("facets", fmt::format("{} loaded of {} polygons read (rule {}, vertices to 1/{} voxel)",
                                  report.facets.loaded, report.facets.read, report.rule,
                                  1 << report.fraction_bits));
  const std::string changed =
      nonzero({{report.facets.triangulated, "polygons split into triangles"},
               {report.facets.degenerate, "facets without area dropped"},
               {report.facets.outside, "facets outside the cube dropped"}});
  if (!changed.empty()) page.line("", changed);
  const std::string ignored = nonzero({{report.ignored.primitives, "points and lines"},
                                       {report.ignored.lights, "lights without a place"},
                                       {report.ignored.textures, "textures"}});
  if (!ignored.empty()) page.line("ignored", ignored);
  const double cube = static_cast<double>(report.n) * report.n * report.n;
  page.line("voxels", fmt::format("{} occupied, {:.1f} % of the cube", report.voxels,
                                  100.0 * static_cast<double>(report.voxels) / cube));
  if (report.machine != "golden") {
    page.line("loading",
              fmt::format("{} clock cycles; {} row feeder{}, {} words through the busiest",
                          report.load.cycles, report.feeders, report.feeders == 1 ? "" : "s",
                          report.load_words));
  }
}

std::string number(float value) { return fmt::format("{:.3g}", value); }

void light_lines(Page& page, const Report& report) {
  std::string origin = fmt::format("{} of {} used", report.lights.used, report.lights.read);
  if (report.lights.by_default) {
    origin = fmt::format("a default light, because none of the scene's {} lies in the cube",
                         report.lights.read);
    if (report.lights.read == 0) origin = "a default light, because the scene has none";
  } else if (report.lights.outside != 0) {
    origin += fmt::format(", {} outside the cube skipped", report.lights.outside);
  }
  page.line("lights", origin);
  page.line(
      "", fmt::format("each aims at {} targets at distance L = {} (rule {}, {} mode, queues of {})",
                      total_targets(report.target_distance), report.target_distance,
                      report.light_rule, report.mode, report.fa));
  const bool clocked = report.machine != "golden";
  std::vector<std::string> head = {"light",    "voxel",   "colour", "lit voxels",
                                   "absorbed", "escaped", "skipped"};
  if (clocked)
    head.insert(head.end(), {"to prepare", "cycles", "beams served", "merged", "deepest queue"});
  std::vector<std::vector<std::string>> rows = {head};
  for (std::size_t k = 0; k < report.sources.size(); ++k) {
    const Source& light = report.sources[k];
    const LightResult& result = light.result;
    rows.push_back(
        {std::to_string(k), fmt::format("({},{},{})", light.voxel.x, light.voxel.y, light.voxel.z),
         fmt::format("({},{},{})", number(light.colour.r), number(light.colour.g),
                     number(light.colour.b)),
         std::to_string(light.lit), std::to_string(result.targets.absorbed),
         std::to_string(result.targets.escaped), std::to_string(result.targets.skipped)});
    if (!clocked) continue;
    for (const std::int64_t value :
         {result.prepare_cycles, result.cycles, result.visits, result.merged, result.max_queue}) {
      rows.back().push_back(std::to_string(value));
    }
  }
  page.table(rows);
}

void agreement_lines(Page& page, const Report& report) {
  if (report.reference == report.machine) {
    page.line("agreement", fmt::format("this is the {} model itself", report.reference));
    return;
  }
  const Comparison& result = report.agreement;
  if (result.equal()) {
    page.line("agreement", fmt::format("every voxel, owner and target count as in the {} model",
                                       report.reference));
    return;
  }
  page.line("DISAGREES", fmt::format("with the {} model: {} voxels, {} owners, {} counts of light",
                                     report.reference, result.voxels_differing,
                                     result.owners_differing, result.lights_differing));
  for (const Difference& difference : result.first) page.line("", to_string(difference));
}

}  // namespace

std::string to_text(const Report& report) {
  Page page;
  scene_lines(page, report);
  light_lines(page, report);
  agreement_lines(page, report);
  std::string times;
  for (const auto& [step, seconds] : report.seconds) {
    times += fmt::format("{}{} {:.2f} s", times.empty() ? "" : ", ", step, seconds);
  }
  page.line("time", times);
  for (const auto& [what, path] : report.written) page.line(what, path);
  return page.str();
}

}  // namespace rc2::report
