#pragma once

#include <cstddef>
#include <vector>

#include "deviation/flatten.h"

namespace unstep::deviation {

/// Whether the Frechet distance of two polylines is at most `bound`, by the
/// free space of Alt and Godau over the part that is reached. Rounding may
/// turn a no into a yes only if the distance is within bound + slack, slack =
/// 2^-58 of the largest coordinate: an interval's ends move with the bound at
/// least as fast as the bound itself, so a few roundings of its ends are no
/// more than as much on the bound.
class PolylineFrechet {
 public:
  /// REQUIRES: neither is empty.
  PolylineFrechet(const std::vector<Place>& chain,
                  const std::vector<Place>& path)
      : chain_(chain), path_(path) {}

  [[nodiscard]] bool within(long double bound);

  /// The chain's vertex at which the last answer of no came to its end.
  [[nodiscard]] std::size_t stuck_at() const { return stuck_; }

 private:
  struct Entry {
    std::size_t edge = 0;
    long double low = 0;  ///< 0..1 along the edge
  };
  struct Cut {
    bool any = false;
    long double low = 0;
    long double high = 0;
  };
  /// What the disc about `centre` cuts from the line, 0..1.
  [[nodiscard]] Cut cut(Place from, Place to, Place centre) const;
  [[nodiscard]] bool near(Place a, Place b) const;
  void row(std::size_t j);

  const std::vector<Place>& chain_;
  const std::vector<Place>& path_;
  long double bound_ = 0;
  std::vector<Entry> entries_;
  std::vector<Entry> next_;
  bool corner_ = false;
  bool last_ = false;
  std::size_t stuck_ = 0;
};

}  // namespace unstep::deviation
