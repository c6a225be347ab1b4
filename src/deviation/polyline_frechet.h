#pragma once

#include <cstddef>
#include <vector>

#include "deviation/flatten.h"

namespace unstep::deviation {

/// A place in space.
struct Place3 {
  long double x = 0;
  long double y = 0;
  long double z = 0;
};

/// Whether the Frechet distance of two polylines is at most `bound`, by the
/// free space of Alt and Godau over the part that is reached. Rounding may
/// turn a no into a yes only if the distance is within bound + slack, slack =
/// 2^-58 of the largest coordinate: an interval's ends move with the bound at
/// least as fast as the bound itself, so a few roundings of its ends are no
/// more than as much on the bound.
template <class Point>
class BasicPolylineFrechet {
 public:
  /// REQUIRES: neither is empty.
  BasicPolylineFrechet(const std::vector<Point>& chain,
                       const std::vector<Point>& path)
      : chain_(chain), path_(path) {}

  [[nodiscard]] bool within(long double bound);

  /// The vertex of `chain` at which the last answer of no came to its end.
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
  [[nodiscard]] Cut cut(Point from, Point to, Point centre) const;
  [[nodiscard]] bool near(Point a, Point b) const;
  void row(std::size_t j);

  const std::vector<Point>& chain_;
  const std::vector<Point>& path_;
  long double bound_ = 0;
  std::vector<Entry> entries_;
  std::vector<Entry> next_;
  bool corner_ = false;
  bool last_ = false;
  std::size_t stuck_ = 0;
};

using PolylineFrechet = BasicPolylineFrechet<Place>;
using PolylineFrechet3 = BasicPolylineFrechet<Place3>;
extern template class BasicPolylineFrechet<Place>;
extern template class BasicPolylineFrechet<Place3>;

}  // namespace unstep::deviation
