#include "codec/warm_start.h"

#include "entropy/logistic.h"

namespace unstep::codec::warm {
namespace {

constexpr std::array<std::uint16_t, 64> kProbabilities = [] {
  std::array<std::uint16_t, 64> all{};
  for (int level = 0; level < 64; ++level) {
    all[static_cast<std::size_t>(level)] =
        static_cast<std::uint16_t>(entropy::squash((level - 32) * 72));
  }
  return all;
}();

}  // namespace

std::uint16_t probability(unsigned level) { return kProbabilities[level]; }

Record parse(std::string_view eight) {
  std::uint64_t bits = 0;
  for (const char c : eight) bits = bits << 6 | from_char(c);
  const auto field = [&](unsigned shift, unsigned count) {
    return static_cast<unsigned>(bits >> shift) & ((1U << count) - 1);
  };
  Record record;
  record.index = static_cast<std::uint16_t>(field(32, 16));
  record.check = static_cast<std::uint16_t>(field(20, 12));
  record.p = {probability(field(14, 6)), probability(field(8, 6))};
  record.n = {kAges[field(4, 4)], kAges[field(0, 4)]};
  return record;
}

}  // namespace unstep::codec::warm
