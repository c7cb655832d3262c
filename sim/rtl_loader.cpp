#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "sim/rtl_machine.h"

namespace rc2 {

std::unique_ptr<Machine> make_rtl_machine(int n, const WaveWindow& waves) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  const auto library = program.parent_path() / "rtl" / fmt::format("librc2_rtl_n{}.so", n);
  if (!std::filesystem::exists(library)) {
    throw Error(
        fmt::format("{}: there is no Verilated machine of n = {}; build it with `make rtl N={}`",
                    library.string(), n, n));
  }
  // The library stays loaded to the end of the program: the machine's code lives in it.
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw Error(fmt::format("{}: cannot be loaded ({}); rebuild it with `make rtl N={}`",
                            library.string(), dlerror(), n));
  }
  auto* factory = reinterpret_cast<RtlFactory*>(dlsym(handle, kRtlFactory));
  if (factory == nullptr) {
    throw Error(fmt::format("{}: is not a machine of this program; rebuild it with `make rtl N={}`",
                            library.string(), n));
  }
  return std::unique_ptr<Machine>(factory(waves));
}

}  // namespace rc2
