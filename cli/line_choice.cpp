#include "cli/line_choice.h"

#include <algorithm>
#include <cstddef>
#include <utility>

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

/// Lines of a search; of a small drawing with arcs if that is smaller,
/// and the page itself if nothing is, as it is with noise.
Result<Page> cheapest_lines(Page page, const Drawing& chains,
                            ToleranceOptions options) {
  const bool arcs = options.arcs;
  options.aim = LineAim::few_bytes;
  options.arcs = false;
  Result<Drawing> lines = reverse_tolerance(chains, options);
  if (!lines) return lines.error();
  const bool few = count_elements(*lines) <= kFewElements;
  Page best = page_of_lines(page.info, options.tolerance, *std::move(lines));
  Result<std::size_t> least = stored_size(best, options.effort);
  if (!least) return least.error();
  if (arcs && few) {
    options.arcs = true;
    Result<Drawing> mixed = reverse_tolerance(chains, options);
    if (!mixed) return mixed.error();
    Page other = page_of_lines(page.info, options.tolerance, *std::move(mixed));
    const Result<std::size_t> size = stored_size(other, options.effort);
    if (!size) return size.error();
    if (*size <= *least) {
      best = std::move(other);
      least = *size;
    }
  }
  const Result<std::size_t> exact = stored_size(page, options.effort);
  if (!exact) return exact.error();
  return *exact <= *least ? std::move(page) : std::move(best);
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
