#include "sim/render_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace rc2 {
namespace {

std::vector<std::int64_t> issued(const RenderReport& report) {
  const auto& all = report.result->counts.issued;
  return {all.begin(), all.begin() + report.depth + 1};
}

}  // namespace

std::string to_json(const RenderReport& report) {
  const RayCounts& counts = report.result->counts;
  nlohmann::ordered_json json;
  json["scene"] = report.scene;
  json["machine"] = report.machine;
  json["view"] = report.view;
  json["light_rule"] = report.light_rule;
  json["unused_camera"] = report.has_unused_camera;
  json["n"] = report.n;
  json["depth"] = report.depth;
  json["queue"] = report.queue;
  json["least_weight"] = report.least_weight;
  json["facets"] = report.facets;
  json["lights"] = report.lights;
  json["rays"] = {{"issued", issued(report)},      {"hits", counts.hits},
                  {"escaped", counts.escaped},     {"rescued", counts.rescued},
                  {"too_light", counts.too_light}, {"too_deep", counts.too_deep},
                  {"probes", counts.probes},       {"planes", counts.planes}};
  const RayTraffic& traffic = report.result->traffic;
  nlohmann::ordered_json work;
  for (std::size_t stage = 0; stage < kRayStages; ++stage)
    work[kRayStageNames[stage]] = traffic.work[stage];
  json["traffic"] = {{"load_cycles", traffic.load_cycles},
                     {"cycles", traffic.cycles},
                     {"busiest", traffic.busiest().cycles},
                     {"busiest_cells", work},
                     {"latency", traffic.latency},
                     {"hops", traffic.hops},
                     {"waits", traffic.waits},
                     {"run_on", traffic.run_on},
                     {"sent_again", traffic.sent_again},
                     {"max_stack", traffic.max_stack},
                     {"messages", traffic.messages},
                     {"busiest_link", traffic.busiest_link}};
  json["agrees_with_golden"] = report.agrees;
  json["files"] = report.written;
  return json.dump(2) + "\n";
}

std::string to_text(const RenderReport& report) {
  const RayCounts& counts = report.result->counts;
  std::string text = fmt::format(
      "scene                  {}\n"
      "machine                {}, n = {}\n"
      "view                   {}{}\n"
      "facets, lights         {}, {} ({} rule)\n"
      "rays by depth          {}\n"
      "hit a facet            {}\n"
      "of them, by the net    {}\n"
      "left the cube          {}\n"
      "not sent, too light    {}\n"
      "not sent, too deep     {}\n"
      "columns looked into    {}\n"
      "planes looked at       {}\n",
      report.scene, report.machine, report.n, report.view,
      report.has_unused_camera ? "; the scene's camera is not used, see --view" : "", report.facets,
      report.lights, report.light_rule, fmt::join(issued(report), ", "), counts.hits,
      counts.rescued, counts.escaped, counts.too_light, counts.too_deep, counts.probes,
      counts.planes);
  if (report.machine != "golden") {
    const RayTraffic& traffic = report.result->traffic;
    const RayTraffic::Busiest busiest = traffic.busiest();
    text += fmt::format(
        "cycles to load them    {}\n"
        "cycles                 {}\n"
        "busiest cell           {} cycles ({})\n"
        "longest chain          {}\n"
        "began where they were  {}\n"
        "sent from home again   {}\n"
        "agrees with golden     {}\n",
        traffic.load_cycles, traffic.cycles, busiest.cycles, busiest.stage,
        report.machine == "rtl" ? "known to the cycle model"
                                : fmt::format("{} cycles, if nothing waited", traffic.latency),
        traffic.run_on, traffic.sent_again, report.agrees ? "in every hit" : "NO");
  }
  for (const std::string& path : report.written)
    text += fmt::format("written                {}\n", path);
  return text;
}

}  // namespace rc2
