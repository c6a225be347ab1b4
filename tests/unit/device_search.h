#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "unstep/interpolate.h"

// The guarantee of device mode: forward(reverse(chain)) stays within one unit
// of the chain on each axis at the same step index.
//
// Lemma used below: a segment starts and ends on the chain, and the device is
// clear between segments, so the deviation is that of each segment alone.

namespace unstep::testing {

using Axis = DeviceRegisters::Axis;

// Largest deviation of the device's line (x, y) from the word that made it;
// 1 is a step along y.
inline std::int64_t deviation(std::int64_t x, std::int64_t y,
                              const std::vector<std::uint8_t>& word) {
  DeviceRegisters device;
  device.start(x, y);
  std::int64_t off = 0;  // the word's y minus the line's; x is its negative
  std::int64_t worst = 0;
  for (std::size_t i = 0; device.forward; ++i) {
    off += word[i];
    off -= device.clock() == Axis::y;
    worst = std::max(worst, std::abs(off));
  }
  return worst;
}

struct Search {
  std::size_t max_length;
  std::int64_t worst = 0;
  std::uint64_t words = 0;

  // Every monotone path: what is open may end here, or go on either way.
  void all_paths(const DeviceRegisters& open, std::vector<std::uint8_t>& word,
                 std::size_t length) {
    if (length == max_length) return;
    for (const Axis axis : {Axis::x, Axis::y}) {
      DeviceRegisters next = open;
      const bool breaks = next.accept(axis);
      word.push_back(axis == Axis::y);
      check(next, word);
      if (breaks) {
        std::vector<std::uint8_t> fresh;
        all_paths({}, fresh, length + 1);
      } else {
        all_paths(next, word, length + 1);
      }
      word.pop_back();
    }
  }

  // Every word that the device takes as one segment. A step is forced unless
  // F == 0, so there are few of them.
  void one_segment(const DeviceRegisters& open,
                   std::vector<std::uint8_t>& word) {
    for (const Axis axis : {Axis::x, Axis::y}) {
      DeviceRegisters next = open;
      const bool breaks = next.accept(axis);
      word.push_back(axis == Axis::y);
      check(next, word);
      if (!breaks && word.size() < max_length) one_segment(next, word);
      word.pop_back();
    }
  }

  void check(const DeviceRegisters& at, const std::vector<std::uint8_t>& word) {
    ++words;
    worst = std::max(worst, deviation(at.x, at.y, word));
  }
};

}  // namespace unstep::testing
