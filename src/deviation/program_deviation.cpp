#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "deviation/program_curve.h"
#include "unstep/deviation.h"

/// The check of shortened programs.
namespace unstep {
namespace {

using deviation::PolylineFrechet3;
using deviation::ProgramSection;

constexpr long double kSagitta = 1e-6L;  ///< mm
constexpr long double kFinest = 1e-7L;   ///< mm, to which distances are found

Error differs(const ProgramSection& a, const ProgramSection& b,
              const std::string& what) {
  return {ErrorCode::corrupt,
          "line " + std::to_string(a.line) + " of the first has another " +
              what + " than line " + std::to_string(b.line) + " of the second"};
}

/// What must be the same; lengths have the slack of an inch's last decimal.
Status check_alike(const ProgramSection& a, const ProgramSection& b) {
  if (a.rapid != b.rapid) return differs(a, b, "kind of motion");
  if (!a.rapid && std::abs(a.feed - b.feed) > 1e-3) {
    return differs(a, b, "feed");
  }
  if (a.spindle != b.spindle) return differs(a, b, "spindle word");
  for (std::size_t axis = 3; axis < kProgramAxes; ++axis) {
    if (std::abs(a.end[axis] - b.end[axis]) <= 254) continue;
    return differs(a, b, "end of " + std::string(1, kProgramAxisLetters[axis]));
  }
  return {};
}

/// Grows `found` to the distance of two sections, if that is more.
class Measure {
 public:
  explicit Measure(double limit) : limit_(limit) {}

  void add(const ProgramSection& a, const ProgramSection& b) {
    PolylineFrechet3 frechet(a.path, b.path);
    long double low = found_.distance;
    if (frechet.within(low)) return;
    take(a, frechet.stuck_at());
    long double high = std::max(2 * low, 16 * kFinest);
    for (; low < limit_ && !frechet.within(high); high *= 2) {
      low = high;
      take(a, frechet.stuck_at());
    }
    while (high - low > kFinest && low <= limit_) {
      const long double middle = (low + high) / 2;
      if (frechet.within(middle)) {
        high = middle;
      } else {
        low = middle;
        take(a, frechet.stuck_at());
      }
    }
    found_.distance = static_cast<double>(high);
    found_.least = static_cast<double>(low);
  }

  [[nodiscard]] ProgramDeviation result() const {
    ProgramDeviation all = found_;
    // Both paths may have arcs that are chords here.
    const double chords = any_arc_ ? static_cast<double>(2 * kSagitta) : 0;
    all.distance += chords;
    all.least = std::max(0.0, all.least - chords);
    return all;
  }
  void has_arcs() { any_arc_ = true; }

 private:
  void take(const ProgramSection& a, std::size_t index) {
    const std::size_t i = std::min(index, a.path.size() - 1);
    found_.at = {static_cast<double>(a.path[i].x),
                 static_cast<double>(a.path[i].y),
                 static_cast<double>(a.path[i].z)};
    found_.line = a.lines[i];
  }

  long double limit_;
  bool any_arc_ = false;
  ProgramDeviation found_;
};

Result<ProgramDeviation> measure(const Program& first, const Program& second,
                                 double limit_mm) {
  const auto a = deviation::sections_of(first, kSagitta);
  if (!a) return a.error();
  const auto b = deviation::sections_of(second, kSagitta);
  if (!b) return b.error();
  const auto is_arc = [](const ProgramItem& item) { return item.is_arc(); };
  Measure measured(limit_mm);
  if (std::any_of(first.items.begin(), first.items.end(), is_arc) ||
      std::any_of(second.items.begin(), second.items.end(), is_arc)) {
    measured.has_arcs();
  }
  const std::size_t count = std::min(a->size(), b->size());
  for (std::size_t i = 0; i < count; ++i) {
    if (Status same = check_alike((*a)[i], (*b)[i]); !same) {
      return same.error();
    }
    measured.add((*a)[i], (*b)[i]);
    if (measured.result().least > limit_mm) return measured.result();
  }
  if (a->size() != b->size()) {
    const auto& longer = a->size() > b->size() ? *a : *b;
    return Error{ErrorCode::corrupt,
                 "motion after the end of the " +
                     std::string(a->size() > b->size() ? "second" : "first") +
                     ", line " + std::to_string(longer[count].line)};
  }
  return measured.result();
}

}  // namespace

Result<ProgramDeviation> measure_program_deviation(const Program& first,
                                                   const Program& second,
                                                   double limit_mm) {
  if (!(limit_mm >= 1e-4) || !(limit_mm <= 1000)) {
    return Error{ErrorCode::out_of_range,
                 "a limit of deviations is 0.0001 to 1000 mm"};
  }
  try {
    return measure(first, second, limit_mm);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the paths"};
  }
}

}  // namespace unstep
