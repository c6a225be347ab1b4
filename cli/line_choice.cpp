#include "cli/line_choice.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cli/stored_size.h"

namespace unstep::cli {
namespace {

/// Drawings of more lines keep to lines: there arcs cost more than they save,
/// and two searches take their time.
constexpr std::size_t kFewElements = 3'000;

std::size_t count_elements(const Drawing& drawing) {
  std::size_t count = 0;
  for (const Path& path : drawing.paths) count += path.elements.size();
  return count;
}

/// Beyond this tolerance, in pixels, the lines of a search for it may take more
/// bytes than those of this one: the prices that guide it are of finer lines.
constexpr Rational kCoarse{2, 1};

struct Choice {
  Page page;
  std::size_t size;
};

/// Lines within `options`, told as within `declared`, which may be more.
Result<Choice> searched_lines(const PageInfo& info, const Drawing& chains,
                              const ToleranceOptions& options,
                              const Rational& declared) {
  Result<Drawing> lines = reverse_tolerance(chains, options);
  if (!lines) return lines.error();
  Page page = page_of_lines(info, declared, *std::move(lines));
  const Result<std::size_t> size = stored_size(page, options.effort);
  if (!size) return size.error();
  return Choice{std::move(page), *size};
}

/// The other searches that may be worth their time on a small drawing.
std::vector<ToleranceOptions> other_searches(const ToleranceOptions& options) {
  std::vector<ToleranceOptions> others;
  const auto add = [&](bool arcs, const Rational& tolerance) {
    others.push_back(options);
    others.back().arcs = arcs;
    others.back().tolerance = tolerance;
  };
  const Rational& e = options.tolerance;
  const bool coarse = e.numerator > std::uint64_t{2} * e.denominator;
  if (coarse) add(false, kCoarse);
  if (options.arcs) add(true, e);
  if (options.arcs && coarse) add(true, kCoarse);
  return others;
}

/// Lines of a search; of a small drawing those of some, with arcs and finer;
/// and the page itself if nothing is smaller, as it is with noise.
Result<Page> cheapest_lines(Page page, const Drawing& chains,
                            ToleranceOptions options) {
  options.aim = LineAim::few_bytes;
  const std::vector<ToleranceOptions> others = other_searches(options);
  options.arcs = false;
  Result<Choice> best =
      searched_lines(page.info, chains, options, options.tolerance);
  if (!best) return best.error();
  if (count_elements(best->page.drawing) <= kFewElements) {
    for (const ToleranceOptions& other : others) {
      Result<Choice> found =
          searched_lines(page.info, chains, other, options.tolerance);
      if (!found) return found.error();
      if (found->size <= best->size) best = std::move(found);
    }
  }
  const Result<std::size_t> exact = stored_size(page, options.effort);
  if (!exact) return exact.error();
  return *exact <= best->size ? std::move(page) : std::move(best->page);
}

/// Of drawings of more elements a part is coded first.
constexpr std::size_t kManyElements = 100'000;
/// How much a part may mislead, in hundredths of its size.
constexpr std::size_t kMisleads = 10;

/// About the size of a page of many lines, from every eighth path or fewer.
Result<std::size_t> estimated_size(const Page& lines, Effort effort) {
  constexpr std::size_t kLeastApart = 8;
  constexpr std::size_t kPart = 200'000;
  const std::size_t all = count_elements(lines.drawing);
  const std::size_t apart = std::max(kLeastApart, all / kPart);
  Page part = page_of_lines(lines.info, lines.fidelity.tolerance, {});
  part.drawing.canvas = lines.drawing.canvas;
  part.drawing.scale = lines.drawing.scale;
  for (std::size_t i = 0; i < lines.drawing.paths.size(); i += apart) {
    part.drawing.paths.push_back(lines.drawing.paths[i]);
  }
  const Result<std::size_t> size = stored_size(part, effort);
  if (!size) return size.error();
  const std::size_t elements = count_elements(part.drawing);
  return *size * all / std::max<std::size_t>(elements, 1);
}

/// Whether the page takes no more bytes than its lines, which are coded only
/// if a part of them leaves doubt.
Result<bool> is_smaller(const Page& page, const Page& lines, Effort effort) {
  const Result<std::size_t> exact = stored_size(page, effort);
  if (!exact) return exact.error();
  if (count_elements(lines.drawing) > kManyElements) {
    const Result<std::size_t> about = estimated_size(lines, effort);
    if (!about) return about.error();
    if (*about + *about / 100 * kMisleads < *exact) return false;
  }
  const Result<std::size_t> size = stored_size(lines, effort);
  if (!size) return size.error();
  return *exact <= *size;
}

/// Lines of one pass, or the page itself if that is smaller.
Result<Page> quick_lines(Page page, const Drawing& chains,
                         const ToleranceOptions& options) {
  Result<Drawing> found = reverse_tolerance(chains, options);
  if (!found) return found.error();
  Page lines = page_of_lines(page.info, options.tolerance, *std::move(found));
  const Result<bool> smaller = is_smaller(page, lines, options.effort);
  if (!smaller) return smaller.error();
  return *smaller ? std::move(page) : std::move(lines);
}

}  // namespace

Page page_of_lines(const PageInfo& info, const Rational& tolerance,
                   Drawing lines) {
  Page page;
  page.kind = PageKind::paths;
  page.info = info;
  page.fidelity = {Fidelity::Kind::tolerance, tolerance};
  page.drawing = std::move(lines);
  return page;
}

Result<Page> lines_of_few_bytes(Page page, const Drawing& chains,
                                const ToleranceOptions& options) {
  return options.effort == Effort::fast
             ? quick_lines(std::move(page), chains, options)
             : cheapest_lines(std::move(page), chains, options);
}

}  // namespace unstep::cli
