// Memory of the example platform.
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <cstring>
#include <systemc>
#include <tlm>
#include <vector>

namespace rc2 {

class Memory : public sc_core::sc_module {
 public:
  /// Eight bytes take one `clock_period`.
  Memory(const sc_core::sc_module_name& name, std::size_t size,
         const sc_core::sc_time& clock_period)
      : sc_module(name), socket("socket"), bytes_(size), clock_period_(clock_period) {
    socket.register_b_transport(this, &Memory::b_transport);
  }

  tlm_utils::simple_target_socket<Memory> socket;

 private:
  void b_transport(::tlm::tlm_generic_payload& transaction, sc_core::sc_time& delay) {
    const std::uint64_t address = transaction.get_address();
    const unsigned length = transaction.get_data_length();
    if (address > bytes_.size() || length > bytes_.size() - address) {
      transaction.set_response_status(::tlm::TLM_ADDRESS_ERROR_RESPONSE);
      return;
    }
    if (transaction.is_write()) std::memcpy(&bytes_[address], transaction.get_data_ptr(), length);
    if (transaction.is_read()) std::memcpy(transaction.get_data_ptr(), &bytes_[address], length);
    const unsigned beats = (length + 7) / 8;
    delay += clock_period_ * beats;
    transaction.set_response_status(::tlm::TLM_OK_RESPONSE);
  }

  std::vector<unsigned char> bytes_;
  sc_core::sc_time clock_period_;
};

}  // namespace rc2
