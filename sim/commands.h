#pragma once

#include "sim/command_line.h"

namespace rc2 {

/// Each declares one command. Errors are thrown.
void declare_run(Command& program);
void declare_voxelize(Command& program);
void declare_compare(Command& program);
void declare_lines(Command& program);
void declare_tunnels(Command& program);
void declare_leaks(Command& program);
void declare_rounding(Command& program);
void declare_loading(Command& program);
void declare_load_speed(Command& program);
void declare_emission(Command& program);
void declare_virtual_image(Command& program);
void declare_walk(Command& program);
void declare_diffusion(Command& program);
void declare_difference(Command& program);
void declare_queues(Command& program);
void declare_light_error(Command& program);
void declare_measure(Command& program);
void declare_peers(Command& program);
void declare_choices(Command& program);
void declare_path_table(Command& program);
void declare_ray_traffic(Command& program);
void declare_render(Command& program);
void declare_render_error(Command& program);
void declare_network(Command& program);
void declare_thesis(Command& program);

}  // namespace rc2
