#include "codec/centreline_warm_start.h"

#include "codec/warm_start.h"

namespace unstep::codec::centreline_warm {

unsigned Reader::take(int characters) {
  unsigned value = 0;
  for (; characters > 0; --characters) {
    value = value << 6 | warm::from_char(text_[at_++]);
  }
  return value;
}

Record Reader::next() {
  constexpr unsigned kFar = 63;
  unsigned passed = take(1);
  if (passed == kFar) passed = take(3);
  Record record;
  index_ += passed;
  record.index = static_cast<std::uint16_t>(index_++);
  const unsigned told = take(3);
  record.check = static_cast<std::uint16_t>(told >> 2);
  record.size = (told & 3) + 1;
  for (std::size_t i = 0; i < record.size; ++i) {
    const unsigned which = take(1);
    record.counters[i] = {static_cast<std::uint8_t>(which >> 3),
                          kAges[which & 7], warm::probability(take(1))};
  }
  return record;
}

}  // namespace unstep::codec::centreline_warm
