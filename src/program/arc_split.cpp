#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>
#include <vector>

#include "program/arc_fit.h"
#include "program/arc_geometry.h"
#include "unstep/program.h"

namespace unstep {
namespace {

/// A tenth of a micrometre: the pieces' ends are rounded to it.
constexpr std::int64_t kGrid = kProgramUnitsPerMm / 10'000;

std::int64_t rounded(double value) {
  return std::llround(value / static_cast<double>(kGrid)) * kGrid;
}

/// What R does not say is cut in two that it does: near a half turn in the
/// middle, near a full one into 194 to 205 degrees and the rest.
double first_part(double degrees) {
  return degrees > kMostRadiusSweep ? 0.57 : 0.5;
}

/// Where the arc is cut, as shares of its sweep between 0 and 1.
std::vector<double> cuts(double from, double sweep, bool counter,
                         const ArcRules& rules) {
  std::vector<double> shares{0};
  // Cuts nearer than this to an end would leave arcs of no length.
  constexpr double kLeast = 1e-4;
  if (rules.quadrants) {
    const double quarter = std::numbers::pi / 2;
    const double sign = counter ? 1 : -1;
    const double first = std::floor(from * sign / quarter) + 1;
    for (double k = first;; ++k) {
      const double turned = k * quarter - from * sign;
      if (turned >= sweep - kLeast) break;
      if (turned > kLeast) shares.push_back(turned / sweep);
    }
  }
  shares.push_back(1);
  const double most = rules.max_sweep_degrees / 180 * std::numbers::pi;
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    const double part = (shares[i + 1] - shares[i]) * sweep;
    const double pieces = std::max(1.0, std::ceil(part / most - 1e-9));
    const double piece = part / pieces * 180 / std::numbers::pi;
    for (double k = 0; k < pieces; ++k) {
      const double share = (shares[i + 1] - shares[i]) / pieces;
      all.push_back(shares[i] + share * k);
      if (rules.by_radius && !radius_says(piece)) {
        all.push_back(all.back() + share * first_part(piece));
      }
    }
  }
  all.push_back(1);
  return all;
}

class Split {
 public:
  Split(const Program& in, const ArcRules& rules) : rules_(rules) {
    out_ = in;
    out_.items.clear();
    at_ = in.position(in.start);
    for (const ProgramItem& item : in.items) {
      if (item.is_arc() && !item.keep_text) {
        add_arc(item);
      } else {
        out_.items.push_back(item);
      }
      at_ = in.position(item);
    }
  }
  Program take() { return std::move(out_); }

 private:
  void add_arc(const ProgramItem& item) {
    const bool counter = item.kind == ProgramItem::Kind::counter;
    const auto axes =
        plane_axes(out_.modes[item.modes].plane.value_or(ProgramPlane::xy));
    const PlanePoint start{at_[axes[0]], at_[axes[1]]};
    const PlanePoint end{item.end[axes[0]], item.end[axes[1]]};
    const double sweep = arc_sweep(start, end, item.centre, counter);
    const double from =
        std::atan2(static_cast<double>(start[1] - item.centre[1]),
                   static_cast<double>(start[0] - item.centre[0]));
    const double r0 = distance(start, item.centre);
    const double r1 = distance(end, item.centre);
    const std::vector<double> shares = cuts(from, sweep, counter, rules_);
    const ProgramPosition last = out_.position(item);
    for (std::size_t i = 1; i + 1 < shares.size(); ++i) {
      const double share = shares[i];
      const double angle = from + (counter ? sweep : -sweep) * share;
      const double radius = r0 + (r1 - r0) * share;
      ProgramPosition to{};
      for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
        to[axis] =
            at_[axis] == last[axis]
                ? at_[axis]
                : rounded(static_cast<double>(at_[axis]) +
                          static_cast<double>(last[axis] - at_[axis]) * share);
      }
      to[axes[0]] = rounded(static_cast<double>(item.centre[0]) +
                            radius * std::cos(angle));
      to[axes[1]] = rounded(static_cast<double>(item.centre[1]) +
                            radius * std::sin(angle));
      add_piece(item, to, sweep * (share - shares[i - 1]));
    }
    add_piece(item, last, sweep * (1 - shares[shares.size() - 2]));
  }

  /// `sweep` in radians.
  void add_piece(const ProgramItem& whole, const ProgramPosition& to,
                 double sweep) {
    ProgramItem piece = whole;
    piece.radius = std::abs(piece.radius);
    if (sweep > std::numbers::pi) piece.radius = -piece.radius;
    std::copy_n(to.begin(), 3, piece.end.begin());
    ProgramOtherAxes others{};
    std::copy_n(to.begin() + 3, others.size(), others.begin());
    if (out_.others[piece.others] != others) {
      out_.others.push_back(others);
      piece.others = static_cast<std::uint32_t>(out_.others.size() - 1);
    }
    out_.items.push_back(piece);
  }

  const ArcRules& rules_;
  Program out_;
  ProgramPosition at_{};
};

}  // namespace

Result<Program> split_arcs(const Program& program, const ArcRules& rules) {
  if (!(rules.max_sweep_degrees >= 1)) {
    return Error{ErrorCode::out_of_range, "arcs are split at 1 degree or more"};
  }
  try {
    return Split(program, rules).take();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the program"};
  }
}

}  // namespace unstep
