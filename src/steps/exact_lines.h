#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "unstep/grid.h"
#include "unstep/interpolate.h"

namespace unstep::steps {

/// Finds plain lines that a method draws with exactly the given steps.
class LineSearch {
 public:
  /// Freeman codes of the method (evaluation8, evaluation or device), which
  /// must outlive the search. No line has more than `reach` steps.
  LineSearch(std::span<const Step> codes, Method method, std::size_t reach)
      : codes_(codes), method_(method), reach_(reach) {}

  /// Steps of a long line from step `at` on, at least 1: a single step always
  /// is a line. Never longer than the digital straight segment from there; the
  /// longest, but by Method::device where many ends near that segment's own do
  /// not do.
  std::size_t longest(std::size_t at, Segment& best);

  /// Steps of a line from there that is at most as long as the longest, but
  /// leaves a longer one after it. `line` as of longest(), of `count` steps.
  std::size_t before_next(std::size_t at, std::size_t count, Segment& line);

  /// Whether the line to the end of `count` steps makes just these.
  bool is_line(std::size_t at, std::size_t count, Segment& line) {
    line = ends_at(at, count);
    return draws(at, count, line);
  }

 private:
  [[nodiscard]] std::size_t line_bound(std::size_t at, std::size_t most) const;
  [[nodiscard]] std::size_t straight_bound(std::size_t at,
                                           std::size_t reach) const;
  std::size_t longest_within(std::size_t at, std::size_t bound, Segment& best);
  [[nodiscard]] Segment ends_at(std::size_t at, std::size_t count) const;
  bool draws(std::size_t at, std::size_t count, const Segment& line);
  void find_ends(std::size_t at, std::size_t bound);

  std::span<const Step> codes_;
  Method method_;
  std::size_t reach_;
  std::size_t credit_ = std::size_t{1} << 22;  ///< steps that may be looked at
  std::vector<Step> drawn_;
  std::vector<std::size_t> ends_;  ///< of find_ends(), the farthest last
};

}  // namespace unstep::steps
