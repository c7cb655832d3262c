#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "sim/rtl_machine.h"

namespace rc2 {
namespace {

std::string how_to_build(const std::string& name) {
  const std::string n = name.substr(name.rfind('n') + 1);
  if (name.rfind("rays_", 0) == 0)
    return fmt::format(
        "cmake -D RC2_RTL_EXTRA_SIZE={} build && cmake --build build --target rtl_{}", n, name);
  const bool thesis = name.rfind("thesis_", 0) == 0;
  return fmt::format("make rtl N={}{}", n, thesis ? " MODE=thesis" : "");
}

}  // namespace

std::unique_ptr<Machine> make_rtl_machine(const std::string& name, const WaveWindow& waves) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  const auto library = program.parent_path() / "rtl" / fmt::format("librc2_rtl_{}.so", name);
  if (!std::filesystem::exists(library)) {
    throw Error(fmt::format("{}: there is no such Verilated machine; build it with `{}`",
                            library.string(), how_to_build(name)));
  }
  // The library stays loaded to the end of the program: the machine's code lives in it.
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw Error(fmt::format("{}: cannot be loaded ({}); rebuild it with `{}`", library.string(),
                            dlerror(), how_to_build(name)));
  }
  auto* factory = reinterpret_cast<RtlFactory*>(dlsym(handle, kRtlFactory));
  if (factory == nullptr) {
    throw Error(fmt::format("{}: is not a machine of this program; rebuild it with `{}`",
                            library.string(), how_to_build(name)));
  }
  return std::unique_ptr<Machine>(factory(waves));
}

}  // namespace rc2
