#pragma once

#include <cstddef>
#include <vector>

/// The vertices of a run of lines that may become fewer.
namespace unstep {

/// In program units from some vertex of the run, so that doubles hold them
/// exactly: differences of positions below 2^51.
struct RunPoint {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// `vertex` is where the program goes, `written` where the output can go: the
/// vertex on the grid of the output's decimals.
struct Polyline {
  std::vector<RunPoint> vertex;
  std::vector<RunPoint> written;
  [[nodiscard]] std::size_t size() const { return vertex.size(); }
};

}  // namespace unstep
