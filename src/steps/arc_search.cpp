#include "steps/arc_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "interpolate/arc_steps.h"
#include "steps/arc_rule.h"

namespace unstep::steps {

namespace {

/// Steps from a circle to an end that is off it by less than one, and some that
/// go straight where the circle does not.
constexpr std::size_t kBeyond = 4;

}  // namespace

/// Steps that an arc draws as given, from the first on; `whole`: it draws no
/// other.
std::size_t ArcSearch::matched(const Arc& arc, bool& whole) const {
  whole = false;
  const Result<interpolation::ArcGeometry> checked =
      interpolation::check_arc(arc);
  if (!checked) return 0;
  interpolation::ArcSteps drawn(*checked, combined_,
                                interpolation::kFreemanLetters);
  std::array<Step, 256> part;
  // Most centres are wrong soon.
  std::size_t size = 16;
  for (std::size_t count = 0;; size = part.size()) {
    const std::size_t n = drawn.fill(std::span(part).first(size));
    if (n == 0) {
      whole = true;
      return count;
    }
    const std::size_t most = std::min(n, steps_.size() - count);
    const Step* const here = steps_.data() + count;
    const Step* const stop =
        std::mismatch(here, here + most, part.data()).first;
    const auto same = static_cast<std::size_t>(stop - here);
    count += same;
    if (same < n) return count;
  }
}

bool ArcSearch::draws(Point centre, bool clockwise, std::size_t count) const {
  bool whole = false;
  return matched({centre, point(count), clockwise}, whole) == count && whole;
}

bool ArcSearch::is_end(Point centre, bool clockwise, std::size_t count) const {
  return control_takes(centre, point(count), step_mm_) &&
         draws(centre, clockwise, count);
}

void ArcSearch::try_centre(Point centre, bool clockwise) {
  if (centre == Point{}) return;
  bool whole = false;
  std::size_t count = matched({centre, {}, clockwise}, whole);
  if (count + kBeyond <= best_.steps) return;
  // The last steps may lead to an end that is not on the circle, away from it
  // too.
  count = std::min(count + kBeyond, steps_.size());
  constexpr int kBack = 64;
  int tries = 0;
  while (count > best_.steps && !is_end(centre, clockwise, count)) {
    if (++tries == kBack) return;
    --count;
  }
  if (count <= best_.steps) return;
  count = before_tangent(centre, clockwise, count);
  if (count <= best_.steps) return;
  best_ = {{centre, point(count), clockwise}, count};
}

/// Steps straight on may belong to a line that follows the arc: where they
/// begin on the circle itself, the arc ends there.
std::size_t ArcSearch::before_tangent(Point centre, bool clockwise,
                                      std::size_t count) const {
  std::size_t at = count;
  while (at > kLeastArc && steps_[at - 1] == steps_[count - 1] &&
         off_circle(centre, point(at)) != 0) {
    --at;
  }
  const bool on_circle = off_circle(centre, point(at)) == 0;
  return on_circle && draws(centre, clockwise, at) ? at : count;
}

}  // namespace unstep::steps
