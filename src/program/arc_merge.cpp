#include "program/arc_merge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "program/arc_fit.h"
#include "program/arc_geometry.h"

namespace unstep {
namespace {

using Kind = ProgramItem::Kind;

class Merger {
 public:
  Merger(Program& program, double tolerance, const ArcRules& rules)
      : program_(program), tolerance_(tolerance), rules_(rules) {}

  void merge() {
    std::vector<ProgramItem> out;
    out.reserve(program_.items.size());
    double used = 0;  // of the tolerance, by the last item
    for (const ProgramItem& item : program_.items) {
      const ProgramItem& start =
          out.size() < 2 ? program_.start : out[out.size() - 2];
      double more = 0;
      if (!out.empty() && is_one(start, out.back(), item, more) &&
          used + more <= tolerance_) {
        used += more;
        const PlanePoint centre = out.back().centre;
        out.back() = item;
        out.back().centre = centre;
        out.back().radius = 0;
        continue;
      }
      used = 0;
      out.push_back(item);
    }
    program_.items = std::move(out);
  }

 private:
  [[nodiscard]] bool is_plain(const ProgramItem& item) const {
    return item.is_arc() && !item.keep_text && item.turns == 1;
  }

  /// Whether both arcs can be one; `more` is how far that is from them.
  [[nodiscard]] bool is_one(const ProgramItem& start, const ProgramItem& a,
                            const ProgramItem& b, double& more) const {
    if (!is_plain(a) || !is_plain(b) || a.kind != b.kind ||
        a.modes != b.modes || a.feed != b.feed || a.spindle != b.spindle ||
        a.known != b.known || start.known != a.known ||
        start.modes != a.modes || start.others != a.others ||
        a.others != b.others || rules_.by_radius) {
      return false;
    }
    const auto axes =
        plane_axes(program_.modes[a.modes].plane.value_or(ProgramPlane::xy));
    if (start.end[axes[2]] != a.end[axes[2]] ||
        a.end[axes[2]] != b.end[axes[2]]) {
      return false;
    }
    const auto at = [&axes](const ProgramItem& item) {
      return PlanePoint{item.end[axes[0]], item.end[axes[1]]};
    };
    const double r0 = distance(at(start), a.centre);
    const double r1 = distance(at(a), a.centre);
    const double r2 = distance(at(b), a.centre);
    more = std::abs(r1 - r0) + std::abs(r2 - r1) +
           2 * distance(a.centre, b.centre);
    return radii_agree(r0, r2, rules_) && sweep_fits(start, a, b, axes);
  }

  /// Less than a full turn, or one that ends where it began.
  [[nodiscard]] bool sweep_fits(const ProgramItem& start, const ProgramItem& a,
                                const ProgramItem& b,
                                const std::array<std::size_t, 3>& axes) const {
    const auto at = [&axes](const ProgramItem& item) {
      return PlanePoint{item.end[axes[0]], item.end[axes[1]]};
    };
    const bool counter = a.kind == Kind::counter;
    const double sweep = arc_sweep(at(start), at(a), a.centre, counter) +
                         arc_sweep(at(a), at(b), b.centre, counter);
    const double most = rules_.max_sweep_degrees * std::numbers::pi / 180;
    if (sweep > most + 1e-9) return false;
    // Where rounding might make a full turn of none, or none of one.
    return at(start) == at(b) ? sweep > 6.2 : sweep < 6.2;
  }

  Program& program_;
  double tolerance_;
  ArcRules rules_;
};

}  // namespace

void merge_arcs(Program& program, double tolerance, const ArcRules& rules) {
  Merger(program, tolerance, rules).merge();
}

}  // namespace unstep
