"""The proofs of scripts/formal, in the order of docs/proofs.md."""

from prove import Fault, Proof

PROOFS = [
    *(Proof("fifo_order", "same words, same order, same number as a queue that shifts", "rc2_fifo", "induction",
            Fault("parts/rc2_fifo.sv", "if (pop_i && !push_i) count_q", "if (pop_i) count_q"), 2, params=(("Depth", depth),))
      for depth in (1, 2, 3, 4, 8, 16)),
]
