// The waveform of a Verilated array. One that is built by rows (rtl.cmake) has none.
#pragma once

#include <cstdint>
#include <string>

#include "sw/base/error.h"
#if VM_TRACE
#include <verilated_fst_c.h>
#endif

namespace rc2 {

class WaveWriter {
 public:
  bool is_open() const { return open_; }

#if VM_TRACE
  /// Throws Error if the file cannot be written.
  template <typename Top>
  void open(Top& top, const std::string& path) {
    top.trace(&trace_, 99);
    trace_.open(path.c_str());
    open_ = trace_.isOpen();
    if (!open_) {
      throw Error(path + ": the waveform cannot be written; name a file in a folder that exists");
    }
  }
  void dump(std::int64_t time) { trace_.dump(static_cast<std::uint64_t>(time)); }
  void close() {
    if (open_) trace_.close();
    open_ = false;
  }

 private:
  VerilatedFstC trace_;
#else
  template <typename Top>
  void open(Top& /*top*/, const std::string& path) {
    throw Error(path + ": this array is built without waves; take a smaller one");
  }
  void dump(std::int64_t /*time*/) {}
  void close() {}

 private:
#endif
  bool open_ = false;
};

}  // namespace rc2
