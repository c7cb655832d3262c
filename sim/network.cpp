// Chapter 2: the Boolean networks that draw, as hardware and in figures.
#include "sw/network/network.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "sim/commands.h"
#include "sim/outputs.h"
#include "sw/base/replace_file.h"
#include "sw/network/measure.h"
#include "sw/network/write.h"

namespace rc2 {
namespace {

struct NetworkOptions {
  std::string shape, scheme, out;
  int size = 0;
  bool planarity = false;
};

void print_measures(const network::Network& built) {
  const network::Measures measures = network::measure(built);
  fmt::print("cells {}\nlinks {}\ndepth {}\n", measures.cells, measures.links, measures.depth);
  fmt::print("max_fan_in {}\nmean_fan_in {:.4f}\nmax_fan_out {}\n", measures.max_fan_in,
             measures.mean_fan_in, measures.max_fan_out);
  fmt::print("total_length {:.3f}\nmean_length {:.4f}\nlongest {:.3f}\n", measures.total_length,
             measures.mean_length, measures.longest);
  fmt::print("planned_links {}\nwrong_links {}\nthreshold {}\n", built.repair.planned,
             built.repair.wrong, built.repair.threshold);
}

void print_planarity(const network::Network& built) {
  const network::Disturbances straight = network::straight_wires(built);
  fmt::print("straight_crossings {}\nstraight_overlaps {}\nstraight_through_cells {}\n",
             straight.crossings, straight.overlaps, straight.through);
  const network::Page beside = network::page(built);
  fmt::print("page_crossed {}\npage_tracks {}\n", beside.crossed, beside.tracks);
}

ExitCode make_network(const NetworkOptions& options) {
  const network::Network built = network::build(network::shape_of(options.shape), options.size,
                                                network::scheme_of(options.scheme));
  Outputs outputs;
  if (!options.out.empty()) {
    outputs.add_folder(options.out);
    std::string name = options.shape + "_" + options.scheme;
    std::replace(name.begin(), name.end(), ':', '_');
    const std::string path = options.out + "/" + name;
    replace_file(path + ".v", network::verilog(built, name));
    replace_file(path + ".json", network::description(built));
  }
  print_measures(built);
  if (options.planarity) print_planarity(built);
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_network(Command& program) {
  auto options = std::make_shared<NetworkOptions>();
  Command command = program.command(
      "network",
      "Builds a Boolean network of thesis 2.4 and measures it, one name and value a line");
  command.option("shape", options->shape, "circles or segments").required();
  command.option("size", options->size, "Largest radius R, or last column N").required();
  command.option("scheme", options->scheme, "star, chain, tree, tree:F or nearest").required();
  command.option("--out", options->out,
                 "Folder for SHAPE_SCHEME.v (the hardware) and .json (its cells and links)");
  command.flag("--planarity", options->planarity, "Also count the wires that cross");
  command.run([options] { return make_network(*options); });
}

}  // namespace rc2
