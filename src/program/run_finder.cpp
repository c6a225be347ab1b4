#include "program/run_finder.h"

#include <algorithm>
#include <cmath>

#include "program/units.h"

namespace unstep {
namespace {

using Kind = ProgramItem::Kind;

}  // namespace

const ProgramItem& RunFinder::before(std::size_t index) const {
  return index == 0 ? in_.start : in_.items[index - 1];
}

/// Only x, y and z move, and extrusion.
bool RunFinder::others_rest(const ProgramItem& from,
                            const ProgramItem& to) const {
  if (from.others == to.others) return true;
  const ProgramOtherAxes& a = in_.others[from.others];
  const ProgramOtherAxes& b = in_.others[to.others];
  return std::equal(a.begin(), a.end() - 1, b.begin());
}

std::int64_t RunFinder::extruded(const ProgramItem& from,
                                 const ProgramItem& to) const {
  return in_.others[to.others][kAxisE - 3] -
         in_.others[from.others][kAxisE - 3];
}

/// A line that may be merged with its neighbours.
bool RunFinder::is_mergeable(std::size_t index) const {
  const ProgramItem& item = in_.items[index];
  const ProgramItem& from = before(index);
  return item.kind == Kind::line && !item.keep_text &&
         item.known == from.known && item.modes == from.modes &&
         others_rest(from, item);
}

std::size_t RunFinder::run_end(std::size_t begin) const {
  if (!is_mergeable(begin)) return begin;
  const ProgramItem& first = in_.items[begin];
  Extrusion extrusion;
  std::size_t end = begin;
  while (end < in_.items.size() && is_mergeable(end) &&
         in_.items[end].feed == first.feed &&
         in_.items[end].spindle == first.spindle && continues(extrusion, end)) {
    ++end;
  }
  return std::max(end, begin + 1);
}

bool RunFinder::continues(Extrusion& so_far, std::size_t index) const {
  const ProgramItem& from = before(index);
  const ProgramItem& to = in_.items[index];
  const auto amount = static_cast<double>(extruded(from, to));
  const double length =
      std::hypot(static_cast<double>(to.end[0] - from.end[0]),
                 static_cast<double>(to.end[1] - from.end[1]),
                 static_cast<double>(to.end[2] - from.end[2]));
  // Where nothing moves but the filament, that is a motion of its own.
  if (length == 0 && amount != 0) return false;
  if (so_far.any) {
    // Five decimals are what slicers write.
    constexpr double kRounding = 1e-5 * kPerMm;
    const double expected =
        so_far.length > 0 ? so_far.amount / so_far.length * length : 0;
    if (so_far.length > 0 && (amount == 0) != (so_far.amount == 0) &&
        length > 0) {
      return false;
    }
    if (so_far.length > 0 &&
        std::abs(amount - expected) >
            extrusion_tolerance_ * std::abs(expected) + kRounding) {
      return false;
    }
  }
  so_far.any = true;
  so_far.length += length;
  so_far.amount += amount;
  return true;
}

}  // namespace unstep
