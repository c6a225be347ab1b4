#include "steps/line3_search.h"

#include <algorithm>

#include "steps/line3.h"

namespace unstep::steps {
namespace {

GridDelta sum_of(const std::vector<StepWord>& words, std::size_t at,
                 std::size_t count) {
  GridDelta delta{};
  for (std::size_t i = at; i < at + count; ++i) {
    for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
      delta[axis] += step_of(words[i], axis);
    }
  }
  return delta;
}

bool draws(const std::vector<StepWord>& words, std::size_t at,
           std::size_t count, const GridDelta& delta) {
  Line3 line(delta);
  if (line.count() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (line.next() != words[at + i]) return false;
  }
  return true;
}

}  // namespace

std::size_t longest_line3(const std::vector<StepWord>& words, std::size_t at,
                          GridDelta& best) {
  const std::size_t most = std::min(words.size() - at, kReach);
  std::size_t good = 1;
  best = sum_of(words, at, 1);
  // Doubling while something on the way fits, then every end above the last.
  for (std::size_t reach = 2; reach / 2 <= good * 2 && reach / 2 < most;
       reach *= 2) {
    const std::size_t end = std::min(reach, most);
    GridDelta delta = sum_of(words, at, end);
    int tries = 0;
    for (std::size_t count = end; count > good && tries < 4096; --count) {
      if (draws(words, at, count, delta)) {
        good = count;
        best = delta;
        break;
      }
      ++tries;
      for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
        delta[axis] -= step_of(words[at + count - 1], axis);
      }
    }
  }
  return good;
}

}  // namespace unstep::steps
