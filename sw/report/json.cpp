#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sw/report/report.h"

namespace rc2::report {
namespace {

using Json = nlohmann::ordered_json;

// Sums over all sources; of the queues, the deepest.
LightResult totals(const Report& report) {
  LightResult sum;
  for (const Source& source : report.sources) {
    const LightResult& one = source.result;
    sum.prepare_cycles += one.prepare_cycles;
    sum.cycles += one.cycles;
    sum.home_cycles += one.home_cycles;
    sum.visits += one.visits;
    sum.merged += one.merged;
    sum.max_queue = std::max(sum.max_queue, one.max_queue);
    sum.targets.total += one.targets.total;
    sum.targets.absorbed += one.targets.absorbed;
    sum.targets.escaped += one.targets.escaped;
    sum.targets.skipped += one.targets.skipped;
  }
  return sum;
}

Json voxel(glm::ivec3 at) { return {at.x, at.y, at.z}; }

// 0.95F is 0.949999988079071 as a double: its shortest decimal is what the user wrote.
double shortest(float value) { return std::stod(fmt::format("{}", value)); }

Json colour(glm::vec3 rgb) { return {shortest(rgb.r), shortest(rgb.g), shortest(rgb.b)}; }

Json beams(const LightResult& light) {
  return {{"visits", light.visits}, {"merged", light.merged}, {"max_queue", light.max_queue}};
}

Json targets(const TargetCount& count) {
  return {{"total", count.total},
          {"absorbed", count.absorbed},
          {"escaped", count.escaped},
          {"skipped", count.skipped}};
}

Json source(const Source& light) {
  return {{"voxel", voxel(light.voxel)},
          {"colour", colour(light.colour)},
          {"prepare_cycles", light.result.prepare_cycles},
          {"cycles", light.result.cycles},
          {"home_cycles", light.result.home_cycles},
          {"lit", light.lit},
          {"beams", beams(light.result)},
          {"targets", targets(light.result.targets)}};
}

template <typename Value>
Json optional(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json agreement(const Report& report) {
  Json first = Json::array();
  for (const Difference& difference : report.agreement.first) {
    first.push_back({{"voxel", voxel(difference.at)},
                     {"what", difference.what},
                     {"expected", optional(difference.expected)},
                     {"got", optional(difference.got)}});
  }
  return {{"reference", report.reference},
          {"voxels_differing", report.agreement.voxels_differing},
          {"owners_differing", report.agreement.owners_differing},
          {"lights_differing", report.agreement.lights_differing},
          {"first", first}};
}

template <typename Value>
Json object(const std::vector<std::pair<std::string, Value>>& pairs) {
  Json result = Json::object();
  for (const auto& [name, value] : pairs) result[name] = value;
  return result;
}

template <typename Get>
Json per_source(const Report& report, Get get) {
  Json list = Json::array();
  for (const Source& light : report.sources) list.push_back(get(light));
  return list;
}

}  // namespace

std::string to_json(const Report& report) {
  const LightResult total = totals(report);
  Json json;
  json["scene"] = report.scene;
  json["fit"] = report.fit;
  json["machine"] = report.machine;
  json["n"] = report.n;
  json["fraction_bits"] = report.fraction_bits;
  json["rule"] = report.rule;
  json["light_rule"] = report.light_rule;
  json["mode"] = report.mode;
  json["L"] = report.target_distance;
  json["fa"] = report.fa;
  json["feeders"] = report.feeders;
  json["load_words"] = report.load_words;
  json["facets"] = {{"read", report.facets.read},
                    {"triangulated", report.facets.triangulated},
                    {"loaded", report.facets.loaded},
                    {"degenerate", report.facets.degenerate},
                    {"outside", report.facets.outside}};
  json["ignored"] = {{"primitives", report.ignored.primitives},
                     {"lights", report.ignored.lights},
                     {"textures", report.ignored.textures}};
  json["lights"] = {{"read", report.lights.read},
                    {"used", report.lights.used},
                    {"outside", report.lights.outside},
                    {"default", report.lights.by_default}};
  json["cycles"] = {
      {"load", report.load.cycles},
      {"prepare", per_source(report, [](const Source& s) { return s.result.prepare_cycles; })},
      {"light", per_source(report, [](const Source& s) { return s.result.cycles; })},
      {"home", per_source(report, [](const Source& s) { return s.result.home_cycles; })},
      {"hop_stages", report.hop_stages}};
  json["voxels"] = report.voxels;
  json["lit"] = per_source(report, [](const Source& s) { return s.lit; });
  json["beams"] = beams(total);
  json["targets"] = targets(total.targets);
  json["sources"] = per_source(report, source);
  json["agreement"] = agreement(report);
  json["seconds"] = object(report.seconds);
  json["files"] = object(report.written);
  json["commit"] = report.commit;
  json["tools"] = object(report.tools);
  // A path may hold bytes that are not UTF-8; a report with a mark in their place is better than
  // none.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rc2::report
