#include <bit>
#include <cmath>
#include <span>

#include "grid/row_distances.h"
#include "unstep/deviation.h"

namespace unstep {
namespace {

/// The ink of `a` that is farthest from that of `b`, and how much of it is not
/// in `b`.
InkDistance::Worst farthest(const Bitmap& a, const Bitmap& b,
                            std::uint64_t& differing) {
  InkDistance::Worst worst;
  RowDistances distances(b, RowDistances::To::ink);
  for (std::int32_t y = 0; y < a.height(); ++y) {
    const auto in_a = a.row(y);
    const auto in_b = b.row(y);
    std::span<const std::int64_t> squares;
    for (std::size_t w = 0; w < in_a.size(); ++w) {
      std::uint64_t left = in_a[w] & ~in_b[w];
      if (left != 0 && squares.empty()) squares = distances.row(y);
      differing += static_cast<std::uint64_t>(std::popcount(left));
      while (left != 0) {
        const int bit = std::countl_zero(left);
        left &= ~(std::uint64_t{1} << (63 - bit));
        const std::size_t x = w * 64 + static_cast<std::size_t>(bit);
        if (squares[x] <= worst.square) continue;
        worst = {squares[x], {static_cast<std::int32_t>(x), y}};
      }
    }
  }
  return worst;
}

}  // namespace

double InkDistance::Worst::distance() const {
  return std::sqrt(static_cast<double>(square));
}

Result<InkDistance> measure_ink(const Bitmap& a, const Bitmap& b) {
  if (a.width() != b.width() || a.height() != b.height()) {
    return Error{ErrorCode::invalid_argument,
                 "the two rasters are not of the same size"};
  }
  InkDistance found;
  const std::uint64_t ink_a = a.ink();
  if ((ink_a == 0) != (b.ink() == 0)) {
    return Error{ErrorCode::invalid_argument, "one raster has no ink"};
  }
  found.ink = ink_a;
  found.of_a = farthest(a, b, found.only_a);
  found.of_b = farthest(b, a, found.only_b);
  return found;
}

}  // namespace unstep
