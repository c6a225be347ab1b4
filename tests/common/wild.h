#pragma once

#include <limits>
#include <random>

namespace unstep::testing {

/// Random numbers with many at the ends of the range.
template <class T>
T wild(std::mt19937& random) {
  switch (random() % 4) {
    case 0: return std::numeric_limits<T>::max();
    case 1: return std::numeric_limits<T>::min();
    default: return static_cast<T>(random());
  }
}

}  // namespace unstep::testing
