#pragma once

#include "sim/command_line.h"

namespace rc2 {

/// Each declares one command. Errors are thrown.
void declare_run(Program& program);
void declare_voxelize(Program& program);
void declare_compare(Program& program);
void declare_lines(Program& program);
void declare_tunnels(Program& program);
void declare_leaks(Program& program);
void declare_rounding(Program& program);
void declare_loading(Program& program);
void declare_load_speed(Program& program);
void declare_emission(Program& program);
void declare_virtual_image(Program& program);
void declare_walk(Program& program);
void declare_diffusion(Program& program);
void declare_difference(Program& program);
void declare_queues(Program& program);
void declare_light_error(Program& program);
void declare_measure(Program& program);
void declare_peers(Program& program);
void declare_choices(Program& program);
void declare_path_table(Program& program);
void declare_ray_traffic(Program& program);
void declare_render(Program& program);
void declare_render_error(Program& program);
void declare_network(Program& program);
void declare_thesis(Program& program);

}  // namespace rc2
