#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reverse/arcs.h"
#include "reverse/chain_check.h"
#include "reverse/chain_walk.h"
#include "reverse/refine.h"
#include "reverse/tolerance_cheap.h"
#include "reverse/tolerance_free.h"
#include "reverse/tolerance_lines.h"
#include "reverse/tolerance_optimum.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

using reverse::ArcPath;
using reverse::ChainWalk;
using reverse::LineVertices;
using reverse::LookMemory;
using reverse::NearDirections;
using reverse::PathTolerance;
using reverse::VerticesAt;

/// Places for a vertex on each side of the chain, at standard and max effort.
constexpr int kBeam = 1;
constexpr int kWideBeam = 2;

/// The tolerance in path units, rounded down to the fraction that the
/// decisions use. The numerator times the scale is below 2^34, so that
/// all fits 64 bits.
PathTolerance in_path_units(const Rational& tolerance) {
  const auto scale = static_cast<std::uint64_t>(path_scale(tolerance));
  return {static_cast<std::int64_t>(
      (tolerance.numerator * scale << PathTolerance::kBits) /
      tolerance.denominator)};
}

Status check_tolerance(const Rational& e) {
  const std::uint64_t n = e.numerator;
  const std::uint64_t d = e.denominator;
  if (d != 0 && n * 256 >= d && n <= d << 20) return {};
  return Error{ErrorCode::out_of_range,
               "tolerance " + std::to_string(n) + "/" + std::to_string(d) +
                   " is not within 1/256 and 2^20 grid units"};
}

std::size_t count_steps(std::span<const ChainWalk> chains) {
  std::size_t steps = 0;
  for (const ChainWalk& chain : chains) steps += chain.size();
  return steps;
}

/// Chains of fewer steps are done before the table of near points is made; that
/// of the usual tolerance 1 is made once, when all drawings so far have enough.
constexpr std::size_t kManySteps = std::size_t{1} << 16;
constexpr std::size_t kSomeSteps = std::size_t{1} << 12;

std::shared_ptr<const NearDirections> near_directions(
    std::span<const ChainWalk> chains, const ToleranceOptions& options) {
  const PathTolerance tolerance = in_path_units(options.tolerance);
  if (path_scale(options.tolerance) > 1 ||
      tolerance.fixed > NearDirections::kMaxTolerance) {
    return nullptr;
  }
  const std::size_t steps = count_steps(chains);
  constexpr PathTolerance kOne;
  if (tolerance.fixed == kOne.fixed) {
    static std::atomic<std::size_t> of_all_drawings{0};
    if (of_all_drawings.load() < kSomeSteps) of_all_drawings += steps;
    if (of_all_drawings.load() >= kSomeSteps) {
      static const auto of_one = std::make_shared<const NearDirections>(kOne);
      return of_one;
    }
  }
  if (steps < kManySteps) return nullptr;
  return std::make_shared<const NearDirections>(tolerance);
}

LineVertices fit(const ChainWalk& chain, const ToleranceOptions& options,
                 const NearDirections* near, LookMemory* memory) {
  const PathTolerance tolerance = in_path_units(options.tolerance);
  const bool sub_grid = path_scale(options.tolerance) > 1;
  if (options.effort != Effort::max) {
    return sub_grid ? reverse::fit_free_lines(chain, tolerance, kBeam)
                    : reverse::fit_lines(chain, tolerance, near, memory);
  }
  LineVertices fewest = reverse::fit_fewest_lines(chain, tolerance);
  LineVertices free = reverse::fit_free_lines(chain, tolerance, kWideBeam);
  return free.size() < fewest.size() ? free : fewest;
}

bool stay_apart(const ToleranceOptions& options) {
  return !options.may_cross &&
         options.tolerance.numerator <= options.tolerance.denominator;
}

bool is_cheap(const ToleranceOptions& options) {
  return options.aim == LineAim::few_bytes && options.effort != Effort::fast;
}

/// Starts of rings that are tried.
constexpr std::size_t kStarts = 2;
constexpr std::size_t kWideStarts = 6;
/// Of drawings of fewer steps one pass says enough.
constexpr std::size_t kFewSteps = 10000;
/// Prices are learned from one chain of so many at least, and from about so
/// many steps at most.
constexpr std::size_t kLeastApart = 8;
constexpr std::size_t kLearnedSteps = 1 << 16;

/// Prices of what lines usually are and what they are here. Some of the chains
/// are searched for that, and some again by these prices.
void learn_prices(std::span<const ChainWalk> chains, PathTolerance tolerance,
                  reverse::CheapSearch& search, reverse::LinePrice& price) {
  const std::size_t steps = count_steps(chains);
  if (steps < kFewSteps) {
    for (const ChainWalk& chain : chains) {
      if (chain.closed() && chain.size() <= reverse::kSpeckSteps) continue;
      price.count(reverse::fit_lines(chain, tolerance), chain.closed());
    }
    price.settle();
    return;
  }
  const std::size_t apart = std::max(kLeastApart, steps / kLearnedSteps);
  for (std::size_t round = 0; round < 2; ++round) {
    reverse::LinePrice learned;
    for (std::size_t i = round; i < chains.size(); i += apart) {
      const ChainWalk& chain = chains[i];
      learned.count(
          reverse::fit_cheap_lines(search, chain, tolerance, price, 1),
          chain.closed());
    }
    price = std::move(learned);
    price.settle();
  }
}

/// Lines that cost few bits.
std::vector<LineVertices> fit_cheap(std::span<const ChainWalk> chains,
                                    const ToleranceOptions& options,
                                    reverse::LinePrice& price) {
  const PathTolerance tolerance = in_path_units(options.tolerance);
  const bool wide = options.effort == Effort::max;
  reverse::CheapSearch search(tolerance);
  learn_prices(chains, tolerance, search, price);
  std::vector<LineVertices> lines;
  lines.reserve(chains.size());
  for (const ChainWalk& chain : chains) {
    lines.push_back(reverse::fit_cheap_lines(search, chain, tolerance, price,
                                             wide ? kWideStarts : kStarts));
    lines.back().shrink_to_fit();
  }
  return lines;
}

/// Lines of the chains, which are valid; at a tolerance of at most 1 such that
/// they do not cross where the chains do not.
std::vector<LineVertices> fit_all(std::span<const ChainWalk> chains,
                                  const ToleranceOptions& options,
                                  std::optional<reverse::LinePrice>& price,
                                  ToleranceReport& report) {
  std::vector<LineVertices> lines;
  if (is_cheap(options)) {
    lines = fit_cheap(chains, options, price.emplace());
  } else {
    const auto near = near_directions(chains, options);
    std::optional<LookMemory> memory;
    // Fewer steps are done before it has filled.
    const std::size_t steps = count_steps(chains);
    if (near != nullptr && steps >= kSomeSteps) memory.emplace(steps);
    lines.reserve(chains.size());
    for (const ChainWalk& chain : chains) {
      lines.push_back(
          fit(chain, options, near.get(), memory ? &*memory : nullptr));
      lines.back().shrink_to_fit();
    }
  }
  if (stay_apart(options)) {
    const bool on_chain = !is_cheap(options) && options.effort != Effort::max &&
                          path_scale(options.tolerance) == 1;
    report.refined = reverse::refine_crossings(
        chains, in_path_units(options.tolerance),
        on_chain ? VerticesAt::chain : VerticesAt::anywhere, lines);
  }
  return lines;
}

/// Arcs for lines where one replaces some; at a tolerance of at most 1 none
/// that crosses anything. `lines` are spent.
std::vector<ArcPath> add_arcs(std::span<const ChainWalk> chains,
                              const ToleranceOptions& options,
                              std::vector<LineVertices> lines,
                              const std::optional<reverse::LinePrice>& price,
                              ToleranceReport& report) {
  const std::int32_t scale = path_scale(options.tolerance);
  const reverse::ArcFitter fitter(in_path_units(options.tolerance), scale);
  std::vector<ArcPath> paths;
  std::vector<bool> closed;
  paths.reserve(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    closed.push_back(chains[i].closed());
    paths.push_back(reverse::fit_arcs(chains[i], fitter, std::move(lines[i])));
    lines[i] = {};
    if (price) reverse::drop_dear_arcs(paths.back(), *price);
  }
  if (stay_apart(options)) {
    report.refined += reverse::remove_crossing_arcs(paths, closed, scale);
  }
  return paths;
}

/// The lines as paths, with arcs where that is wanted. `lines` are spent.
std::vector<Path> make_paths(std::span<const ChainWalk> chains,
                             const ToleranceOptions& options,
                             std::vector<LineVertices> lines,
                             const std::optional<reverse::LinePrice>& price,
                             ToleranceReport& report) {
  std::vector<Path> paths;
  paths.reserve(lines.size());
  if (options.arcs) {
    std::vector<ArcPath> arcs =
        add_arcs(chains, options, std::move(lines), price, report);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      paths.push_back(reverse::path_of(arcs[i], chains[i].closed()));
      arcs[i] = {};
    }
  } else {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      paths.push_back(reverse::path_of(
          reverse::without_arcs(std::move(lines[i])), chains[i].closed()));
    }
  }
  return paths;
}

void count(const Path& path, ToleranceReport& report) {
  for (const Path::Element& element : path.elements)
    ++(element.kind == Path::Kind::arc ? report.arcs : report.segments);
}

}  // namespace

std::int32_t path_scale(const Rational& tolerance) {
  // The disc around a point of the chain then holds its neighbours on the
  // sub-grid, the diagonal ones too (e * scale >= sqrt 2) unless the others lie
  // exactly on its edge. Finer grids save few lines and cost bits each. sqrt 2
  // is 1 + 26.5 / 64.
  const std::uint64_t n = tolerance.numerator;
  const std::uint64_t d = tolerance.denominator;
  std::uint64_t scale = 1;
  while (n < d && n * scale != d && scale < Drawing::kMaxScale &&
         (n * scale < d || 64 * (n * scale - d) < 27 * d)) {
    scale *= 2;
  }
  return static_cast<std::int32_t>(scale);
}

Result<Path> reverse_tolerance(const Chain& chain, YAxis axis,
                               const ToleranceOptions& options) {
  if (Status s = check_tolerance(options.tolerance); !s) return s.error();
  const std::int32_t scale = path_scale(options.tolerance);
  if (Status s = reverse::check_chain(chain, axis, scale); !s) return s.error();
  const ChainWalk walk(chain, axis, scale);
  ToleranceReport report;
  std::optional<reverse::LinePrice> price;
  std::vector<LineVertices> lines = fit_all({&walk, 1}, options, price, report);
  return std::move(
      make_paths({&walk, 1}, options, std::move(lines), price, report).front());
}

Result<Drawing> reverse_tolerance(const Drawing& drawing,
                                  const ToleranceOptions& options,
                                  ToleranceReport* report) {
  if (Status s = check_tolerance(options.tolerance); !s) return s.error();
  if (!drawing.paths.empty()) {
    return Error{ErrorCode::invalid_argument,
                 "the drawing has paths already, only chains can be reversed"};
  }
  Drawing result;
  result.canvas = drawing.canvas;
  result.scale = path_scale(options.tolerance);
  const YAxis axis = drawing.canvas.y_axis;
  std::vector<ChainWalk> walks;
  walks.reserve(drawing.chains.size());
  for (const Chain& chain : drawing.chains) {
    const Status valid = reverse::check_chain(chain, axis, result.scale);
    if (!valid) {
      return Error{valid.error().code, "chain " + std::to_string(walks.size()) +
                                           ": " + valid.error().message};
    }
    walks.emplace_back(chain, axis, result.scale);
  }
  ToleranceReport done;
  std::optional<reverse::LinePrice> price;
  std::vector<LineVertices> lines = fit_all(walks, options, price, done);
  result.paths = make_paths(walks, options, std::move(lines), price, done);
  for (const Path& path : result.paths) count(path, done);
  if (report != nullptr) *report = done;
  return result;
}

}  // namespace unstep
