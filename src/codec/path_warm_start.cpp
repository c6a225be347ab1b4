#include "codec/path_warm_start.h"

#include "codec/warm_start.h"
#include "entropy/logistic.h"

namespace unstep::codec::path_warm {
namespace {

/// Reads numbers of six bits to a character, high ones first.
class Text {
 public:
  explicit Text(std::string_view text) : text_(text) {}
  [[nodiscard]] bool done() const { return text_.empty(); }
  unsigned next(int characters) {
    unsigned value = 0;
    for (int i = 0; i < characters; ++i) {
      value = value << 6 | warm::from_char(text_.front());
      text_.remove_prefix(1);
    }
    return value;
  }

 private:
  std::string_view text_;
};

/// The counters of one context, to the mark of its end.
void apply_context(Text& in, VectorModel::Decisions& decisions,
                   std::size_t context) {
  std::uint32_t index = 0;
  while (!in.done()) {
    const unsigned passed = in.next(1);
    if (passed == kManyPassed) {
      const unsigned more = in.next(1);
      if (more == 0) return;
      index += 64 * more;
      continue;
    }
    index += passed;
    if (passed == kSomePassed) continue;
    const unsigned entry = in.next(1);
    entropy::Counter& counter = decisions.counter(context, index & 0xffffU);
    counter.p = static_cast<std::uint16_t>(
        entropy::squash(kLevels[entry / kCounterAges.size()]));
    counter.n = kCounterAges[entry % kCounterAges.size()];
    ++index;
  }
}

void apply_counters(std::string_view text, VectorModel& model) {
  Text in(text);
  for (VectorModel::Decisions& decisions : model.decisions()) {
    for (std::size_t i = 0; i < VectorModel::kContexts; ++i) {
      apply_context(in, decisions, i);
    }
  }
}

void apply_weights(std::string_view text, VectorModel& model) {
  Text in(text);
  while (!in.done()) {
    auto& decisions = model.decisions()[in.next(1) % 3];
    const std::size_t set = in.next(1) % VectorModel::kSets;
    const unsigned vector = in.next(2);
    VectorModel::Decisions::Weights weights{};
    for (std::size_t i = 0; i < kWeights; ++i) {
      weights[i] = static_cast<std::int16_t>(
          (static_cast<int>(in.next(2)) - kWeightZero) * (1 << kWeightShift));
    }
    if (vector != kAllVectors) {
      decisions.mixer().set_weights(set, vector, weights, kWeightAge);
      continue;
    }
    for (std::size_t k = 0; k < VectorModel::Decisions::kSelectors; ++k) {
      for (std::size_t s = 0; s < VectorModel::kSets; ++s) {
        decisions.mixer().set_weights(s, k, weights, 0);
      }
    }
  }
}

}  // namespace

void apply(const Table& table, VectorModel& model) {
  apply_counters(table.counters, model);
  apply_weights(table.weights, model);
}

}  // namespace unstep::codec::path_warm
