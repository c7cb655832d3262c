#include "sw/tlm/target.h"

#include <fmt/format.h>

#include <cstring>

#include "sw/base/error.h"
#include "sw/tlm/memory_map.h"

namespace rc2::tlm {
namespace {

using ::tlm::tlm_response_status;

constexpr std::int64_t kRegisterCycles = 2;  // what AXI4-Lite takes

bool lies_in(std::uint64_t address, unsigned length, std::uint64_t start, std::uint64_t size) {
  return address >= start && address - start <= size && length <= size - (address - start);
}

bool is_whole(std::uint64_t offset, unsigned length, unsigned bytes) {
  return length != 0 && offset % bytes == 0 && length % bytes == 0;
}

}  // namespace

Target::Target(const sc_core::sc_module_name& name, Machine& machine,
               const sc_core::sc_time& clock_period)
    : sc_module(name), socket("socket"), port_(machine), clock_period_(clock_period) {
  socket.register_b_transport(this, &Target::b_transport);
}

void Target::b_transport(::tlm::tlm_generic_payload& transaction, sc_core::sc_time& delay) {
  last_error_.clear();
  std::int64_t cycles = 0;
  tlm_response_status status = ::tlm::TLM_OK_RESPONSE;
  try {
    status = serve(transaction, cycles);
  } catch (const Error& error) {
    status = fail(::tlm::TLM_GENERIC_ERROR_RESPONSE, error.what());
  }
  transaction.set_dmi_allowed(false);
  transaction.set_response_status(status);
  delay += clock_period_ * static_cast<double>(cycles + port_.take_cycles());
}

tlm_response_status Target::serve(const ::tlm::tlm_generic_payload& transaction,
                                  std::int64_t& cycles) {
  if (transaction.get_command() == ::tlm::TLM_IGNORE_COMMAND) return ::tlm::TLM_OK_RESPONSE;
  const bool write = transaction.is_write();
  const std::uint64_t address = transaction.get_address();
  const unsigned length = transaction.get_data_length();
  unsigned char* data = transaction.get_data_ptr();
  if (transaction.get_byte_enable_ptr() != nullptr) {
    return fail(::tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE,
                "bytes cannot be enabled one by one; leave the byte enables out");
  }
  if (transaction.get_streaming_width() < length) {
    return fail(::tlm::TLM_BURST_ERROR_RESPONSE,
                fmt::format("the streaming width {} is less than the length {}; the windows are "
                            "queues as they are",
                            transaction.get_streaming_width(), length));
  }
  if (lies_in(address, length, kRegisters, kRegistersSize)) {
    cycles = kRegisterCycles;
    return serve_register(write, address, data, length);
  }
  if (lies_in(address, length, kPackets, kPacketsSize)) {
    cycles = length / kPacketBytes;
    return take_packets(write, address - kPackets, data, length);
  }
  if (lies_in(address, length, kReadback, kReadbackSize)) {
    cycles = length / kReadbackBytes;
    return give_readback(write, address - kReadback, data, length);
  }
  return fail(::tlm::TLM_ADDRESS_ERROR_RESPONSE,
              fmt::format("there is nothing at {:#x}, or not {} bytes of it; see the memory map",
                          address, length));
}

tlm_response_status Target::serve_register(bool write, std::uint64_t address, unsigned char* data,
                                           unsigned length) {
  std::uint32_t value = 0;
  if (length != sizeof value || address % sizeof value != 0) {
    return fail(::tlm::TLM_BURST_ERROR_RESPONSE,
                fmt::format("{} bytes at {:#x} are no register; read or write 4 at a multiple of 4",
                            length, address));
  }
  if (!HostPort::is_register(address)) {
    return fail(::tlm::TLM_ADDRESS_ERROR_RESPONSE,
                fmt::format("there is no register at {:#x}; see the memory map", address));
  }
  if (!write) {
    value = port_.read(address);
    std::memcpy(data, &value, sizeof value);
    return ::tlm::TLM_OK_RESPONSE;
  }
  if (!HostPort::is_writable(address)) {
    return fail(::tlm::TLM_COMMAND_ERROR_RESPONSE,
                fmt::format("the register at {:#x} can only be read", address));
  }
  std::memcpy(&value, data, sizeof value);
  port_.write(address, value);
  return ::tlm::TLM_OK_RESPONSE;
}

tlm_response_status Target::take_packets(bool write, std::uint64_t offset,
                                         const unsigned char* data, unsigned length) {
  if (!write) {
    return fail(::tlm::TLM_COMMAND_ERROR_RESPONSE, "packets can only be written");
  }
  if (!is_whole(offset, length, kPacketBytes)) {
    return fail(::tlm::TLM_BURST_ERROR_RESPONSE,
                fmt::format("{} bytes at {:#x} of the packets are not whole words; a word takes {} "
                            "bytes at a multiple of {}",
                            length, offset, kPacketBytes, kPacketBytes));
  }
  for (unsigned at = 0; at < length; at += kPacketBytes) {
    HostWord::Limbs limbs;
    static_assert(sizeof limbs == kPacketBytes);
    std::memcpy(limbs.data(), data + at, sizeof limbs);
    port_.push(limbs);
  }
  return ::tlm::TLM_OK_RESPONSE;
}

tlm_response_status Target::give_readback(bool write, std::uint64_t offset, unsigned char* data,
                                          unsigned length) {
  if (write) {
    return fail(::tlm::TLM_COMMAND_ERROR_RESPONSE, "the readback can only be read");
  }
  if (!is_whole(offset, length, kReadbackBytes)) {
    return fail(::tlm::TLM_BURST_ERROR_RESPONSE,
                fmt::format("{} bytes at {:#x} of the readback are not whole beats; a beat takes "
                            "{} bytes at a multiple of {}",
                            length, offset, kReadbackBytes, kReadbackBytes));
  }
  if (length / kReadbackBytes > port_.waiting()) {
    return fail(::tlm::TLM_GENERIC_ERROR_RESPONSE,
                fmt::format("{} beats of readback are waiting, not {}; send a READ word first, and "
                            "ask the register {:#x} how many there are",
                            port_.waiting(), length / kReadbackBytes, static_cast<int>(kWaiting)));
  }
  for (unsigned at = 0; at < length; at += kReadbackBytes) {
    const std::uint64_t beat = port_.pop();
    std::memcpy(data + at, &beat, sizeof beat);
  }
  return ::tlm::TLM_OK_RESPONSE;
}

tlm_response_status Target::fail(tlm_response_status status, std::string why) {
  last_error_ = std::move(why);
  return status;
}

}  // namespace rc2::tlm
