// What the command line asks for, checked and with its defaults.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/command_line.h"
#include "sw/base/config.h"
#include "sw/facet/facet.h"
#include "sw/machine/machine.h"

namespace rc2 {

/// The scene and the machine that it is loaded into: options of run, voxelize and render.
struct SceneOptions {
  std::string scene;
  std::string machine;
  int n = 16;
  std::string fit;  ///< "cube", "none", or empty: cube for a file, none for a generated scene
  int fraction_bits = 4;
  std::string rule = "armoured";
  std::optional<int> feeders;
  std::int64_t seed = 1;
  std::string dump;

  bool fitted() const;
  int feeder_count() const { return feeders.value_or(default_feeders(n)); }
};

/// A scene and its lights: options of run and difference.
struct LightOptions : SceneOptions {
  std::vector<std::string> lights;
  std::string light_rule;  ///< empty: accurate where the mode and --rule allow it
  std::optional<int> target_distance;
  int fa = 16;
  std::string mode = "fast";
  std::string skip = "on";

  LightMode light_mode() const { return parse_light_mode(mode); }
  LightRule rule_of_light() const;
  int distance() const { return target_distance.value_or(2 * n); }

  /// What a machine must have been built for.
  MachineConfig needs() const {
    MachineConfig config{n, fraction_bits, distance(), fa, feeder_count()};
    config.mode = light_mode();
    config.skips = skip == "on";
    return config;
  }
};

struct RunOptions : LightOptions {
  std::string out = "out";
  std::string volume;
  std::string waves;
  std::int64_t waves_from = 0;
  std::int64_t waves_cycles = 10000;
};

/// Declare the options of a command; of the machine, `machine` is the default one.
void declare_scene_options(Command& command, SceneOptions& options);
void declare_machine_options(Command& command, SceneOptions& options, const std::string& machine);
void declare_lights(Command& command, std::vector<std::string>& lights);
/// Those of scene and lights.
void declare_light_options(Command& command, LightOptions& options);
/// All of RunOptions.
void declare_run_options(Command& command, RunOptions& options);

/// Throw Error on a value out of range, before any work is done. The first one completes the name
/// of a generated scene that lacks its seed.
void check_options(SceneOptions& options);
void check_options(LightOptions& options);
void check_options(RunOptions& options);

}  // namespace rc2
