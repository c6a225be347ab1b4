#include <string>

#include "render/parity.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

Error chain_error(ErrorCode code, std::size_t chain,
                  const std::string& reason) {
  return {code, "chain " + std::to_string(chain + 1) + ": " + reason};
}

/// Flips every vertical crack of a contour in `cracks`: pixel (x, y) stands
/// for the crack on its left.
Status flip_cracks(const Chain& contour, std::size_t index, Bitmap& cracks) {
  if (!contour.closed) {
    return chain_error(ErrorCode::invalid_argument, index, "is not closed");
  }
  Point at = contour.origin;
  const auto inside = [&] {
    return at.x >= 0 && at.y >= 0 && at.x <= cracks.width() &&
           at.y <= cracks.height();
  };
  if (!inside()) {
    return chain_error(ErrorCode::out_of_range, index,
                       "starts outside the raster");
  }
  for (std::size_t i = 0; i < contour.steps.size(); ++i) {
    const Step step = contour.steps[i];
    if (step > 6 || step % 2 != 0) {
      return chain_error(ErrorCode::invalid_argument, index,
                         "step " + std::to_string(i + 1) + " is " +
                             std::to_string(step) + ", not 0, 2, 4 or 6");
    }
    const Point move = step_delta(step, YAxis::down);
    const std::int32_t y = move.y < 0 ? at.y - 1 : at.y;
    at = {at.x + move.x, at.y + move.y};
    if (!inside()) {
      return chain_error(ErrorCode::out_of_range, index,
                         "leaves the raster at step " + std::to_string(i + 1));
    }
    // Nothing is right of the cracks at x = width.
    if (move.y != 0 && at.x < cracks.width()) {
      cracks.set(at.x, y, !cracks.get(at.x, y));
    }
  }
  if (at != contour.origin) {
    return chain_error(ErrorCode::invalid_argument, index,
                       "does not return to its origin");
  }
  return {};
}

}  // namespace

Result<Bitmap> fill_contours(std::span<const Chain> contours,
                             std::int32_t width, std::int32_t height) {
  Result<Bitmap> ink = Bitmap::create(width, height);
  if (!ink) return ink;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Status flipped = flip_cracks(contours[i], i, *ink);
    if (!flipped) return flipped.error();
  }
  for (std::int32_t y = 0; y < height; ++y) {
    render::fill_row(ink->row(y), ink->last_word_mask());
  }
  return ink;
}

}  // namespace unstep
