// The processor of the example platform: it runs a piece of host software, to which the RC2 target
// on the bus looks like any other Machine. Words and readback go through the platform's memory.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/tlm_quantumkeeper.h>

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <systemc>
#include <tlm>
#include <vector>

#include "sw/machine/host_word.h"
#include "sw/machine/machine.h"

namespace rc2 {

class Host : public sc_core::sc_module, public Machine {
 public:
  using Software = std::function<void(Machine& machine)>;
  /// Says why the target refused the last transaction.
  using Why = std::function<std::string()>;

  Host(const sc_core::sc_module_name& name, Software software, Why why);

  tlm_utils::simple_initiator_socket<Host> socket;

  std::int64_t transactions() const { return transactions_; }
  /// What the software has thrown; null if it ended well.
  std::exception_ptr failure() const { return failure_; }

  // ---- Machine: only while the software runs -------------------------------------------------
  /// As the registers say; those who built the target know of its row feeders.
  const MachineConfig& config() const override { return config_; }
  LoadResult load(const facet::PacketStream& packets, const Progress& progress) override;
  LightResult light(const LightJob& job, const Progress& progress) override;
  VoxelMemory read_voxels() override;
  LayerMemory read_layers() override;
  LightMemory read_light() override;

 private:
  SC_HAS_PROCESS(Host);

  struct Reading {
    glm::ivec3 at;
    std::uint32_t value;
  };

  void run();
  void identify();
  void send_words(const std::vector<HostWord::Limbs>& words);
  // Sorted by z, then y, then x.
  std::vector<Reading> ask(ReadWhat what);
  std::vector<std::uint64_t> fetch_readback();

  std::uint32_t read_register(unsigned address);
  void write_register(unsigned address, std::uint32_t value);
  void transfer(::tlm::tlm_command command, std::uint64_t address, void* data, std::size_t bytes);

  Software software_;
  Why why_;
  std::exception_ptr failure_;
  tlm_utils::tlm_quantumkeeper time_;
  std::int64_t transactions_ = 0;
  MachineConfig config_;
  std::optional<WordFormat> format_;
};

}  // namespace rc2
