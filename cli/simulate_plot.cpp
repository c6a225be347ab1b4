#include "cli/simulate_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace unstep::cli {
namespace {

/// The least box of integer points around all that is plotted.
struct Frame {
  std::int64_t left = INT32_MAX;
  std::int64_t top = INT32_MAX;
  std::int64_t right = INT32_MIN;
  std::int64_t bottom = INT32_MIN;

  void take(std::int64_t x, std::int64_t y) {
    left = std::min(left, x);
    top = std::min(top, y);
    right = std::max(right, x);
    bottom = std::max(bottom, y);
  }
};

void add_chain(const Chain& chain, YAxis axis, Frame& frame,
               std::string& data) {
  Point at = chain.origin;
  frame.take(at.x, at.y);
  fmt::format_to(std::back_inserter(data), "M{} {}", at.x, at.y);
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    const Point move = step_delta(chain.steps[i], axis);
    at.x += move.x;
    at.y += move.y;
    // A run in one direction is one line.
    if (i + 1 < chain.steps.size() && chain.steps[i + 1] == chain.steps[i])
      continue;
    frame.take(at.x, at.y);
    fmt::format_to(std::back_inserter(data), "L{} {}", at.x, at.y);
  }
  data += '\n';
}

void add_path(const Path& path, double scale, Frame& frame, std::string& data) {
  std::int64_t x = path.origin.x;
  std::int64_t y = path.origin.y;
  const auto put = [&](char letter) {
    const double px = static_cast<double>(x) / scale;
    const double py = static_cast<double>(y) / scale;
    frame.take(static_cast<std::int64_t>(px), static_cast<std::int64_t>(py));
    fmt::format_to(std::back_inserter(data), "{}{:.2f} {:.2f}", letter, px, py);
  };
  put('M');
  for (const Path::Element& element : path.elements) {
    x += element.segment.dx;
    y += element.segment.dy;
    put('L');
  }
  data += '\n';
}

}  // namespace

std::string plot_svg(const Drawing& commanded, const Drawing& followed) {
  Frame frame;
  std::string grey;
  std::string red;
  for (const Chain& chain : commanded.chains)
    add_chain(chain, commanded.canvas.y_axis, frame, grey);
  for (const Chain& chain : followed.chains)
    add_chain(chain, followed.canvas.y_axis, frame, red);
  for (const Path& path : followed.paths)
    add_path(path, followed.scale, frame, red);
  if (frame.left > frame.right) {
    frame.take(0, 0);
    frame.take(commanded.canvas.width, commanded.canvas.height);
  }
  const std::int64_t width = frame.right - frame.left + 4;
  const std::int64_t height = frame.bottom - frame.top + 4;
  // With y up the picture is turned over.
  const bool up = commanded.canvas.y_axis == YAxis::up;
  const std::int64_t top = up ? -frame.bottom - 2 : frame.top - 2;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"{2} {3} {0} {1}\" fill=\"none\">\n"
      "<g{4}>\n"
      "<path stroke=\"#999\" stroke-width=\"0.3\" d=\"{5}\"/>\n"
      "<path stroke=\"#d00\" stroke-width=\"0.2\" d=\"{6}\"/>\n"
      "</g>\n</svg>\n",
      width, height, frame.left - 2, top,
      up ? " transform=\"scale(1 -1)\"" : "", grey, red);
}

}  // namespace unstep::cli
