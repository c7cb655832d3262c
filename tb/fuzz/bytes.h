// The fuzzer's bytes as a source of choices. Where they end all further choices are 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rc2::tb {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }

  std::uint8_t byte() { return take<std::uint8_t>(); }
  std::uint16_t word() { return take<std::uint16_t>(); }
  double real() { return take<double>(); }

  /// 0 .. count-1, count being at most 256.
  std::size_t below(std::size_t count) { return byte() % count; }

 private:
  template <typename Value>
  Value take() {
    Value value{};
    if (size_ < sizeof value) {
      size_ = 0;
      return value;
    }
    std::memcpy(&value, data_, sizeof value);
    data_ += sizeof value;
    size_ -= sizeof value;
    return value;
  }

  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace rc2::tb
