#include "codec/warm_start.h"

#include "entropy/logistic.h"

namespace unstep::codec::warm {

Record parse(std::string_view eight) {
  std::uint64_t bits = 0;
  for (const char c : eight) bits = bits << 6 | from_char(c);
  const auto field = [&](unsigned shift, unsigned count) {
    return static_cast<unsigned>(bits >> shift) & ((1U << count) - 1);
  };
  // 64 stretches in steps of 72 / 256 around 0.
  const auto probability = [](unsigned level) {
    return static_cast<std::uint16_t>(
        entropy::squash((static_cast<int>(level) - 32) * 72));
  };
  Record record;
  record.index = static_cast<std::uint16_t>(field(32, 16));
  record.check = static_cast<std::uint16_t>(field(20, 12));
  record.p = {probability(field(14, 6)), probability(field(8, 6))};
  record.n = {kAges[field(4, 4)], kAges[field(0, 4)]};
  return record;
}

}  // namespace unstep::codec::warm
