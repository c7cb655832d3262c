#pragma once

#include <memory>
#include <string>

#include "sim/rtl_machine.h"
#include "sw/machine/machine.h"

namespace rc2 {

/// The machine of that name (golden, cycle, rtl), fit for a job that needs `job`: its n, its
/// fraction bits, its L as max_distance and its FA as max_fa. The models are built to measure; the
/// Verilated array is as it is: Error if it is too small.
std::unique_ptr<Machine> make_machine(const std::string& name, const MachineConfig& job,
                                      const WaveWindow& waves = {});

}  // namespace rc2
