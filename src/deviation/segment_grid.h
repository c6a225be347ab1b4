#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deviation/flatten.h"

namespace unstep::deviation {

struct Line {
  Place from;
  Place to;
};

[[nodiscard]] long double distance_to(const Line& line, Place place);

/// Lines in square cells, to find the nearest to a place. At most 2^12 cells
/// on a side, so that a place far from all of them is not sought for ever.
class SegmentGrid {
 public:
  explicit SegmentGrid(std::vector<Line> lines);

  /// REQUIRES: there are lines.
  [[nodiscard]] long double nearest(Place place) const;

 private:
  struct Cell {
    std::int64_t column = 0;
    std::int64_t row = 0;
  };
  [[nodiscard]] Cell cell_of(Place place) const;
  template <class Visit>
  void visit_cells(const Line& line, Visit visit) const;
  void look(Cell cell, Place place, long double& best) const;

  std::vector<Line> lines_;
  Place corner_;
  long double side_ = 1;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<std::uint32_t> starts_;   ///< by cell, into members_
  std::vector<std::uint32_t> members_;  ///< indices of lines
};

}  // namespace unstep::deviation
