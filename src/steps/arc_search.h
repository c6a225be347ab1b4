#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "steps/reverse_arc.h"
#include "unstep/grid.h"

namespace unstep::steps {

/// Arcs of fewer steps are no better than lines.
inline constexpr std::size_t kLeastArc = 12;

/// Tries centres of an arc that begins where the steps do.
class ArcSearch {
 public:
  /// As of longest_arc().
  ArcSearch(std::span<const Step> steps, std::span<const Point> points,
            bool combined, double step_mm)
      : steps_(steps),
        points_(points),
        combined_(combined),
        step_mm_(step_mm) {}

  /// Only arcs of more steps count.
  void set_least(std::size_t least) { best_.steps = least; }
  /// Relative to the start.
  void try_centre(Point centre, bool clockwise);
  /// What was tried and had most steps.
  [[nodiscard]] const ExactArc& best() const { return best_; }

  /// Whether the arc to the point after `count` steps draws just these, and a
  /// control takes it.
  [[nodiscard]] bool is_end(Point centre, bool clockwise,
                            std::size_t count) const;
  /// Relative to the start.
  [[nodiscard]] Point point(std::size_t i) const {
    return {points_[i].x - points_[0].x, points_[i].y - points_[0].y};
  }

 private:
  [[nodiscard]] std::size_t matched(const Arc& arc, bool& whole) const;
  [[nodiscard]] bool draws(Point centre, bool clockwise,
                           std::size_t count) const;
  [[nodiscard]] std::size_t before_tangent(Point centre, bool clockwise,
                                           std::size_t count) const;

  std::span<const Step> steps_;
  std::span<const Point> points_;
  bool combined_;
  double step_mm_;
  ExactArc best_;
};

}  // namespace unstep::steps
