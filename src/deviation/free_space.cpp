#include "deviation/free_space.h"

#include <utility>

namespace unstep::deviation {
namespace {

/// Coordinates on an edge are along the unit step, so they lack its length.
Vector64 unit_step(const ChainWalk& chain, std::size_t edge,
                   const Bound& bound) {
  const Vector64 move = chain.move(edge);
  return {move.x / bound.unit, move.y / bound.unit};
}

Int128 along(const Bound& bound, Vector64 step, Vector64 offset) {
  return dot(step, offset) * bound.denominator;
}

}  // namespace

EdgeCut cut_edge(const Bound& bound, Vector64 from, Vector64 step,
                 Vector64 centre) {
  const Vector64 q = centre - from;
  const std::int64_t far = bound.reach + 2 * bound.unit;
  if (q.x > far || q.x < -far || q.y > far || q.y < -far) return {};
  const std::int64_t length2 = step.x * step.x + step.y * step.y;
  const std::int64_t p = step.x * q.x + step.y * q.y;
  const auto c = Int128{step.x * q.y - step.y * q.x} * bound.denominator;
  const auto widest = Int128{bound.numerator} * bound.numerator * length2;
  const Int128 rest = widest - c * c;
  if (rest < 0) return {};
  if (p < 0 && !bound.within(centre, from)) return {};
  const Vector64 to{from.x + step.x * bound.unit, from.y + step.y * bound.unit};
  if (p > length2 * bound.unit && !bound.within(centre, to)) return {};
  return {true, Int128{p} * bound.denominator, static_cast<UInt128>(rest)};
}

bool Front::start(Vector64 vertex) {
  corner = bound.within(first, vertex);
  if (!corner) return false;
  // Along the bottom: the chain goes on while the path waits.
  chain.seek(0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    entries.push_back({i, {0, 0}});
    chain.seek(i + 1);
    if (!bound.within(chain.at(), vertex)) return true;
  }
  last = true;
  return true;
}

bool Front::start_on_edge(Vector64 vertex, Vector64 place) {
  if (!bound.within(place, vertex)) return false;
  chain.seek(0);
  entries.push_back(
      {0, {along(bound, unit_step(chain, 0, bound), place - chain.at()), 0}});
  for (std::size_t i = 1; i < chain.size(); ++i) {
    chain.seek(i);
    if (!bound.within(chain.at(), vertex)) break;
    entries.push_back({i, {0, 0}});
  }
  return true;
}

bool Front::ends_on_edge(Vector64 place) {
  if (entries.empty() || entries.back().edge + 1 != chain.size()) return false;
  const std::size_t edge = chain.size() - 1;
  chain.seek(edge);
  const Vector64 step = unit_step(chain, edge, bound);
  const LowEnd there{along(bound, step, place - chain.at()), 0};
  return at_most(entries.back().low, there);
}

}  // namespace unstep::deviation
