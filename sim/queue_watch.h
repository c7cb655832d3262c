// The depths of all queues of a Verilated array, read out of the running model.
#pragma once

#include <verilated.h>
#include <verilated_sym_props.h>

#include <stdexcept>
#include <vector>

#include "sim/wave_list.h"
#include "sw/base/config.h"

namespace rc2 {

class QueueWatch {
 public:
  /// Finds the cells' variables `queued`, which rtl/rc2.vlt makes public. Throws std::logic_error
  /// if they are not.
  QueueWatch(const VerilatedContext& context, const MachineConfig& config) {
    for (int y = 0; y < config.n; ++y) {
      for (int x = 0; x < config.n; ++x) {
        const VerilatedScope* scope = context.scopeFind(cell_scope(config, x, y).c_str());
        const VerilatedVar* queue = scope == nullptr ? nullptr : scope->varFind("queued");
        if (queue == nullptr || queue->vltype() != VLVT_UINT8)
          throw std::logic_error("the queues of this array cannot be seen; see rtl/rc2.vlt");
        queues_.push_back(static_cast<const CData*>(queue->datap()));
      }
    }
  }

  /// Of cell y*n + x, as the registers hold them now.
  std::vector<std::uint32_t> depths() const {
    std::vector<std::uint32_t> depths;
    for (const CData* queue : queues_) depths.push_back(*queue);
    return depths;
  }

 private:
  std::vector<const CData*> queues_;
};

}  // namespace rc2
