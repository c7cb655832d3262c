// RC2 in a SystemC virtual platform: a TLM-2.0 loosely-timed target in front of any Machine
// (docs/tlm.md).
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <string>
#include <systemc>
#include <tlm>

#include "sw/tlm/host_port.h"

namespace rc2::tlm {

class Target : public sc_core::sc_module {
 public:
  /// `machine` must outlive this; a cycle of it lasts one `clock_period`. Throws Error.
  Target(const sc_core::sc_module_name& name, Machine& machine,
         const sc_core::sc_time& clock_period);

  tlm_utils::simple_target_socket<Target> socket;

  /// Why the last transaction failed, in one sentence; empty if it did not.
  const std::string& last_error() const { return last_error_; }

 private:
  void b_transport(::tlm::tlm_generic_payload& transaction, sc_core::sc_time& delay);
  ::tlm::tlm_response_status serve(const ::tlm::tlm_generic_payload& transaction,
                                   std::int64_t& cycles);
  ::tlm::tlm_response_status serve_register(bool write, std::uint64_t address, unsigned char* data,
                                            unsigned length);
  ::tlm::tlm_response_status take_packets(bool write, std::uint64_t offset,
                                          const unsigned char* data, unsigned length);
  ::tlm::tlm_response_status give_readback(bool write, std::uint64_t offset, unsigned char* data,
                                           unsigned length);
  ::tlm::tlm_response_status fail(::tlm::tlm_response_status status, std::string why);

  HostPort port_;
  sc_core::sc_time clock_period_;
  std::string last_error_;
};

}  // namespace rc2::tlm
