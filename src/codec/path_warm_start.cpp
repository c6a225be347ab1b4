#include "codec/path_warm_start.h"

#include <array>

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

void apply_counters(std::string_view text, VectorModel& model) {
  Text in(text);
  std::size_t part = 0;
  std::size_t context = 0;
  std::uint32_t index = 0;
  while (!in.done() && part < model.decisions().size()) {
    const unsigned passed = in.next(2);
    const unsigned level = in.next(1);
    const std::uint8_t age = warm::kAges[in.next(1) % warm::kAges.size()];
    if (passed == 0 && age == 0) {
      index = 0;
      context = (context + 1) % VectorModel::kContexts;
      if (context == 0) ++part;
      continue;
    }
    index += passed;
    if (age == 0) continue;
    entropy::Counter& counter =
        model.decisions()[part].counter(context, index & 0xffffU);
    counter.p = static_cast<std::uint16_t>(
        entropy::squash((static_cast<int>(level) - 32) * 72));
    counter.n = age;
    ++index;
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
