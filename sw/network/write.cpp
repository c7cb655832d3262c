#include "sw/network/write.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

namespace rc2::network {

std::string verilog(const Network& network, const std::string& module) {
  const int count = static_cast<int>(network.cells.size());
  const int bits = output_bit({network.size, network.size}) + 1;
  const auto wire = [&](int cell) {
    return fmt::format("c_{}_{}", network.cells[cell].x, network.cells[cell].y);
  };
  std::vector<std::string> inputs(count);
  const auto add = [&](int cell, const std::string& signal) {
    inputs[cell] += inputs[cell].empty() ? signal : ", " + signal;
  };
  for (int drawing = 0; drawing <= network.size; ++drawing) {
    add(network.starts[drawing], fmt::format("start[{}]", drawing));
  }
  for (const Link& link : network.links) add(link.to, wire(link.from));

  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "// Written by rc2 network. Pixel (x, y) is lit[x * (x + 1) / 2 + y].\n");
  fmt::format_to(out, "module {} (\n  input wire [{}:0] start,\n  output wire [{}:0] lit\n);\n",
                 module, network.size, bits - 1);
  std::vector<std::string> pixels(bits, "1'b0");
  for (int cell = 0; cell < count; ++cell) {
    // A reduction rather than a | b | c, which tools would read as a chain of gates.
    fmt::format_to(out, "  wire {} = |{{{}}};\n", wire(cell), inputs[cell]);
    pixels[output_bit(network.cells[cell])] = wire(cell);
  }
  for (int bit = 0; bit < bits; ++bit) {
    fmt::format_to(out, "  assign lit[{}] = {};\n", bit, pixels[bit]);
  }
  text += "endmodule\n";
  return text;
}

std::string description(const Network& network) {
  nlohmann::json json;
  json["size"] = network.size;
  json["starts"] = network.starts;
  json["cells"] = nlohmann::json::array();
  for (const glm::ivec2 at : network.cells) json["cells"].push_back({at.x, at.y});
  json["links"] = nlohmann::json::array();
  for (const Link& link : network.links) json["links"].push_back({link.from, link.to});
  return json.dump() + "\n";
}

}  // namespace rc2::network
