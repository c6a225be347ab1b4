#include "cli/reverse_lines.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "unstep/deviation.h"

namespace unstep::cli {
namespace {

/// Path units are grid units or 2^-k of them, so these are exact.
class Printer {
 public:
  explicit Printer(std::int32_t scale) : scale_(scale) {}

  void print(const Path& path, bool where) const {
    Point at = path.origin;
    for (const Path::Element& element : path.elements) {
      const bool arc = element.kind == Path::Kind::arc;
      const Point end =
          arc ? element.arc.end : Point{element.segment.dx, element.segment.dy};
      if (where) fmt::print("{} {} ", grid(at.x), grid(at.y));
      fmt::print("{} {}", grid(end.x), grid(end.y));
      if (arc) {
        fmt::print(" {} {} {}", grid(element.arc.centre.x),
                   grid(element.arc.centre.y),
                   element.arc.clockwise ? "cw" : "ccw");
      }
      fmt::print("\n");
      at = {at.x + end.x, at.y + end.y};
    }
  }

 private:
  [[nodiscard]] double grid(std::int32_t units) const {
    return static_cast<double>(units) / scale_;
  }

  std::int32_t scale_;
};

}  // namespace

Status print_lines(Chain chain, const ToleranceOptions& options, bool where) {
  Drawing chains;
  chains.canvas.y_axis = YAxis::up;
  chain.origin = {};
  chains.chains.push_back(std::move(chain));
  const Result<Drawing> lines = reverse_tolerance(chains, options);
  if (!lines) {
    const Error& error = lines.error();
    // The steps are codes: what is wrong is that they lead too far.
    return error.code == ErrorCode::invalid_argument
               ? Error{ErrorCode::limit_exceeded, error.message}
               : error;
  }
  const Status within = check_deviation(chains, *lines, options.tolerance);
  if (!within) {
    return Error{ErrorCode::internal,
                 "the lines break the bound: " + within.error().message};
  }
  Printer(lines->scale).print(lines->paths.front(), where);
  if (std::fflush(stdout) != 0) {
    return Error{ErrorCode::io_error, "cannot write"};
  }
  return {};
}

}  // namespace unstep::cli
