#include "sim/wave_list.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "sw/base/error.h"

namespace rc2 {
namespace {

// GTKWave's marks for how a line is shown.
constexpr const char* kDecimal = "@24";
constexpr const char* kSigned = "@420";
constexpr const char* kHexadecimal = "@22";
constexpr const char* kBits = "@28";
constexpr const char* kTitle = "@200";

class SaveFile {
 public:
  void title(const std::string& text) { text_ += fmt::format("{}\n-{}\n", kTitle, text); }
  void signal(const char* format, const std::string& name, int width) {
    if (width > 1) return vector(format, name, width);
    text_ += fmt::format("{}\n{}\n", format, name);
  }
  void vector(const char* format, const std::string& name, int width) {
    text_ += fmt::format("{}\n{}[{}:0]\n", format, name, width - 1);
  }
  void text(const std::string& text) { text_ += text; }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

void list_cell(SaveFile& list, const MachineConfig& config, int x, int y, const std::string& what) {
  const int coordinate = coordinate_bits(config.n);
  const int target = bits_for(config.max_distance + 1) + 1;
  const bool thesis = config.mode == LightMode::thesis;
  const std::string cell = cell_scope(config, x, y) + '.';
  list.title(fmt::format("Cell ({}, {}): {}", x, y, what));
  list.signal(kBits, cell + "busy_o", 1);
  list.signal(kDecimal, cell + "queued", queue_bits(config.max_fa));
  if (thesis) {
    for (const char* field : {"dir", "z"}) {
      list.signal(kDecimal, cell + "u_diffuser.head." + field, field[0] == 'd' ? 3 : coordinate);
    }
    for (const char* field : {"umin", "umax", "vmin", "vmax"}) {
      list.signal(kSigned, cell + "u_diffuser.head." + field, target);
    }
    list.signal(kBits, cell + "link_valid_i", 8);
    list.signal(kBits, cell + "link_valid_o", 8);
    list.signal(kBits, cell + "link_ready_i", 8);
    list.signal(kBits, cell + "absorb", 1);
    list.signal(kDecimal, cell + "absorb_z", coordinate);
  } else {
    const std::string lane = cell + "u_side_lane.";
    list.signal(kBits, lane + "serve", 1);
    list.signal(kBits, lane + "beam.along_y", 1);
    for (const char* field : {"beam.vmin", "beam.vmax"}) list.signal(kSigned, lane + field, target);
    list.signal(kSigned, lane + "free_min_o", target + 1);
    list.signal(kSigned, lane + "free_max_o", target + 1);
    list.signal(kBits, cell + "side_valid_i", 8);
    list.signal(kBits, cell + "side_valid_o", 8);
    list.signal(kBits, cell + "side_room_i", 8);
    list.signal(kBits, cell + "reached", 1);
    list.signal(kBits, cell + "stopped", 1);
    list.signal(kDecimal, cell + "z", coordinate);
  }
  const std::string voxels = cell + "u_voxels.";
  list.signal(kBits, voxels + "dexel_valid", 1);
  list.signal(kDecimal, voxels + "dexel_facet", kFacetBits);
  list.signal(kDecimal, voxels + "dexel_lo", coordinate);
  list.signal(kDecimal, voxels + "dexel_hi", coordinate);
  list.signal(kHexadecimal, voxels + "occupied", config.n);
}

}  // namespace

// Cell (x,y) is c[x+1] of rtl/rc2_row.sv in g[y+1] of rtl/rc2_grid.sv, or of g[y+1] in
// rtl/rc2_grid_thesis.sv.
std::string cell_scope(const MachineConfig& config, int x, int y) {
  const bool thesis = config.mode == LightMode::thesis;
  return fmt::format("rc2.rc2_machine.u_array.{}.u_grid.g[{}].{}c[{}].n.u_cell", thesis ? 'm' : 'l',
                     y + 1, thesis ? "" : "n.u_row.", x + 1);
}

void write_wave_list(const std::string& waves, const MachineConfig& config, glm::ivec3 source,
                     std::int64_t start, std::optional<glm::ivec2> cell) {
  const std::string machine = "rc2.rc2_machine.";
  const std::int64_t time = start * kWaveTimePerCycle;
  SaveFile list;
  list.text(
      fmt::format("[*] The light at ({}, {}, {}) starts at {}: {} time units are one cycle.\n",
                  source.x, source.y, source.z, time, kWaveTimePerCycle));
  list.text(fmt::format("[dumpfile] \"{}\"\n", std::filesystem::absolute(waves).string()));
  list.text(fmt::format("[timestart] {}\n[size] 1600 1000\n[signals_width] 300\n",
                        time - 5 * kWaveTimePerCycle));
  list.text(fmt::format("*-6.000000 {}{}\n", time,
                        " -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1"
                        " -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1"));
  list.title("Machine");
  list.signal(kBits, machine + "clk_i", 1);
  list.vector(kBits, machine + "s_axis_tvalid", config.feeders);
  list.vector(kBits, machine + "s_axis_tready", config.feeders);
  list.signal(kBits, machine + "m_axis_tvalid", 1);
  list.signal(kBits, machine + "start_q", 1);
  list.signal(kBits, machine + "busy", 1);
  list.signal(kHexadecimal, machine + "u_array.rows_busy", config.n);
  list.signal(kDecimal, machine + "busy_cycles_q", 32);
  list.signal(kDecimal, machine + "home_q",
              bits_for(24LL * config.max_distance * config.max_distance + 3));
  const glm::ivec2 middle = cell.value_or(glm::ivec2(source));
  list_cell(list, config, middle.x, middle.y, cell ? "asked for" : "the light's own");
  const int east = middle.x + 1 < config.n ? middle.x + 1 : middle.x - 1;
  list_cell(list, config, east, middle.y, "beside it");
  list_cell(list, config, 0, 0, "a corner");

  const auto path = std::filesystem::path(waves).replace_extension(".gtkw");
  std::ofstream file(path);
  file << list.str();
  file.close();
  if (!file) {
    throw Error(path.string() +
                ": the list of signals cannot be written; name a folder that is writable");
  }
}

}  // namespace rc2
