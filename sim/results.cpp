#include "sim/results.h"

#include <filesystem>

#include "sw/base/replace_file.h"
#include "sw/picture/exr.h"
#include "sw/picture/png.h"
#include "sw/picture/raster.h"
#include "sw/picture/render.h"
#include "sw/volume/volume.h"

namespace rc2 {
namespace {

std::string in_folder(const RunOptions& options, const char* name) {
  return (std::filesystem::path(options.out) / name).string();
}

}  // namespace

void write_pictures(const RunOptions& options, const Job& job, const std::vector<Lamp>& lamps,
                    const report::Memories& memories, report::Report& report) {
  if (!options.dump.empty()) {
    replace_file(options.dump, report::to_csv(memories));
    report.written.emplace_back("dump", options.dump);
  }
  if (!options.volume.empty()) {
    volume::write_vdb(options.volume, memories.voxels, memories.lights);
    report.written.emplace_back("volume", options.volume);
  }
  const picture::Image image =
      picture::render(options.n, memories.voxels, lit_lamps(lamps, memories.lights),
                      job.facets.facets, job.scene.materials);
  const std::string exr = in_folder(options, "picture.exr");
  const std::string png = in_folder(options, "picture.png");
  picture::write_exr(exr, image);
  report.written.emplace_back("exr", exr);
  picture::write_png(png, picture::develop(image));
  report.written.emplace_back("png", png);
}

void write_report(const RunOptions& options, report::Report& report) {
  const std::string path = in_folder(options, "report.json");
  report.written.emplace_back("report", path);
  replace_file(path, report::to_json(report));
}

}  // namespace rc2
