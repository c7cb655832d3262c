#include "sw/cycle/facet_stage.h"

namespace rc2::cycle {

namespace {

// The end of an object and a question concern every unit.
bool is_for_all(const Word& word) {
  return word.kind == WordKind::end || word.kind == WordKind::read;
}

// An answer is on its way to the host.
bool passes_by(const Word& word) { return word.kind == WordKind::data; }

}  // namespace

bool FacetStage::here() const {
  if (is_for_all(front())) return true;
  if (passes_by(front())) return false;
  return front().kind == WordKind::head ? front().skip[lead_] == 0 : here_;
}

bool FacetStage::on() const {
  if (is_for_all(front()) || passes_by(front())) return true;
  return front().kind == WordKind::head ? front().skip[lead_] != 0 || front().take[lead_] > 1 : on_;
}

Word FacetStage::stepped() const {
  Word word = front();
  if (word.kind != WordKind::head) {
    if (here()) word.d += word.step[lead_] * stride_;
  } else if (word.skip[lead_] == 0) {
    --word.take[lead_];
  } else {
    --word.skip[lead_];
  }
  return word;
}

void FacetStage::pop() {
  if (front().kind == WordKind::head) {
    const bool serves = here(), goes_on = on();
    here_ = serves;
    on_ = goes_on;
  }
  first_ ^= 1U;
  --held_;
}

void FacetStage::push(const Word& word) {
  buffer_[(first_ + held_) % 2] = word;
  ++held_;
}

}  // namespace rc2::cycle
