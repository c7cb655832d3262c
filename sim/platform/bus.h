// A bus of the example platform: one initiator, targets by address.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <array>
#include <cstdint>
#include <systemc>
#include <tlm>

namespace rc2 {

class Bus : public sc_core::sc_module {
 public:
  struct Range {
    std::uint64_t start, size;
  };
  static constexpr Range kMemory{0x0000'0000, 0x0001'0000}, kMachine{0x4000'0000, 0x3000};

  explicit Bus(const sc_core::sc_module_name& name)
      : sc_module(name), from_host("from_host"), to_memory("to_memory"), to_machine("to_machine") {
    from_host.register_b_transport(this, &Bus::b_transport);
  }

  tlm_utils::simple_target_socket<Bus> from_host;
  tlm_utils::simple_initiator_socket<Bus> to_memory, to_machine;

 private:
  // Each target counts its addresses from 0.
  void b_transport(::tlm::tlm_generic_payload& transaction, sc_core::sc_time& delay) {
    const std::uint64_t address = transaction.get_address();
    const auto inside = [&](Range range) {
      return address >= range.start && address - range.start < range.size;
    };
    if (inside(kMemory)) {
      transaction.set_address(address - kMemory.start);
      to_memory->b_transport(transaction, delay);
    } else if (inside(kMachine)) {
      transaction.set_address(address - kMachine.start);
      to_machine->b_transport(transaction, delay);
    } else {
      transaction.set_response_status(::tlm::TLM_ADDRESS_ERROR_RESPONSE);
    }
    transaction.set_address(address);
  }
};

}  // namespace rc2
