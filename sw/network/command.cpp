#include "sw/network/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "sw/base/replace_file.h"
#include "sw/network/measure.h"
#include "sw/network/network.h"
#include "sw/network/write.h"

namespace rc2::network {
namespace {

struct Options {
  std::string shape, scheme, folder;
  int size = 0;
  bool planarity = false;
};

void print_measures(const Network& network) {
  const Measures measures = measure(network);
  fmt::print("cells {}\nlinks {}\ndepth {}\n", measures.cells, measures.links, measures.depth);
  fmt::print("max_fan_in {}\nmean_fan_in {:.4f}\nmax_fan_out {}\n", measures.max_fan_in,
             measures.mean_fan_in, measures.max_fan_out);
  fmt::print("total_length {:.3f}\nmean_length {:.4f}\nlongest {:.3f}\n", measures.total_length,
             measures.mean_length, measures.longest);
  fmt::print("planned_links {}\nwrong_links {}\nthreshold {}\n", network.repair.planned,
             network.repair.wrong, network.repair.threshold);
}

void print_planarity(const Network& network) {
  const Disturbances straight = straight_wires(network);
  fmt::print("straight_crossings {}\nstraight_overlaps {}\nstraight_through_cells {}\n",
             straight.crossings, straight.overlaps, straight.through);
  const Page one_side = page(network);
  fmt::print("page_crossed {}\npage_tracks {}\n", one_side.crossed, one_side.tracks);
}

void run(const Options& options) {
  const Network network = build(shape_of(options.shape), options.size, scheme_of(options.scheme));
  if (!options.folder.empty()) {
    std::string name = options.shape + "_" + options.scheme;
    std::replace(name.begin(), name.end(), ':', '_');
    replace_file(options.folder + "/" + name + ".v", verilog(network, name));
    replace_file(options.folder + "/" + name + ".json", description(network));
  }
  print_measures(network);
  if (options.planarity) print_planarity(network);
}

}  // namespace

void add_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "network", "build and measure a Boolean network that draws circles or segments");
  command->add_option("shape", options->shape, "circles or segments")->required();
  command->add_option("size", options->size, "largest radius R, or last column N")->required();
  command->add_option("scheme", options->scheme, "star, chain, tree, nearest or tree:F")
      ->required();
  command->add_option("--emit", options->folder,
                      "folder for SHAPE_SCHEME.v (hardware) and .json (cells and links)");
  command->add_flag("--planarity", options->planarity, "count the wires that cross");
  command->callback([options] { run(*options); });
}

}  // namespace rc2::network
