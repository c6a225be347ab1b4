#include "formats/real_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace unstep {
namespace {

/// Bytes that a piece and a path take here and on the grid, vectors that grow
/// to twice their need included.
constexpr std::uint64_t kPieceMemory =
    2 * (sizeof(RealPiece) + sizeof(Path::Element));
constexpr std::uint64_t kPathMemory = 2 * (sizeof(RealPath) + sizeof(Path));

/// Equal but for the rounding of a few operations.
bool near(RealPoint p, RealPoint q, double size) {
  return std::hypot(p.x - q.x, p.y - q.y) <= 1e-9 * size;
}

}  // namespace

void RealDrawing::fail(Error error) {
  if (status_) status_ = std::move(error);
}

void RealDrawing::use_memory(std::uint64_t bytes) {
  memory_ += bytes;
  if (memory_ > limits_.max_memory) {
    fail({ErrorCode::limit_exceeded, "more than the memory limit of " +
                                         std::to_string(limits_.max_memory) +
                                         " bytes"});
  }
}

bool RealDrawing::check(RealPoint point) {
  constexpr double kMax = kMaxCoord;
  // Written so that what is no number fails.
  if (!(std::fabs(point.x) <= kMax && std::fabs(point.y) <= kMax)) {
    fail({ErrorCode::out_of_range, "a coordinate beyond -" +
                                       std::to_string(kMaxCoord) + " to " +
                                       std::to_string(kMaxCoord)});
  }
  return static_cast<bool>(status_);
}

void RealDrawing::move_to(RealPoint at) {
  end_path();
  if (!check(at)) return;
  use_memory(kPathMemory);
  if (!status_) return;
  paths_.push_back({at, false, filled_, computed_, width_, {}});
  at_ = at;
  in_path_ = true;
}

void RealDrawing::add(const RealPiece& piece) {
  if (!in_path_ || !check(piece.end)) return;
  use_memory(kPieceMemory);
  if (!status_) return;
  paths_.back().pieces.push_back(piece);
  paths_.back().pieces.back().computed = computed_;
  at_ = piece.end;
}

void RealDrawing::line_to(RealPoint at) {
  add({RealPiece::Kind::line, false, false, at, {}, {}});
}

void RealDrawing::cubic_to(RealPoint a, RealPoint b, RealPoint end) {
  if (check(a) && check(b)) {
    add({RealPiece::Kind::cubic, false, false, end, a, b});
  }
}

void RealDrawing::circle(RealPoint centre, bool ascending) {
  if (centre == at_) return line_to(at_);
  if (check(centre)) {
    add({RealPiece::Kind::circle, ascending, false, at_, centre, {}});
  }
}

void RealDrawing::arc_to(RealPoint centre, RealPoint end, bool ascending) {
  if (!in_path_ || !status_) return;
  std::vector<RealPiece>& pieces = paths_.back().pieces;
  const double radius = std::hypot(at_.x - centre.x, at_.y - centre.y);
  if (!pieces.empty() && pieces.back().kind == RealPiece::Kind::arc) {
    RealPiece& last = pieces.back();
    const RealPoint start = pieces.size() > 1 ? pieces[pieces.size() - 2].end
                                              : paths_.back().origin;
    if (last.ascending == ascending && near(last.a, centre, radius) &&
        near(start, end, radius)) {
      last.kind = RealPiece::Kind::circle;
      last.end = start;
      at_ = start;
      return;
    }
  }
  // A centre so far away makes a line of anything that fits the grid.
  constexpr double kMax = kMaxCoord;
  if (!(std::fabs(centre.x) <= kMax && std::fabs(centre.y) <= kMax) ||
      radius == 0) {
    return line_to(end);
  }
  add({RealPiece::Kind::arc, ascending, false, end, centre, {}});
}

void RealDrawing::ellipse_to(RealPoint centre, RealPoint to_x, RealPoint to_y,
                             double begin, double sweep, RealPoint end) {
  constexpr double kPart = std::numbers::pi / 8;  // error 7e-8 of the radius
  // Written so that what is no number fails.
  if (!(std::fabs(sweep) <= 2 * std::numbers::pi + kPart)) {
    return fail({ErrorCode::out_of_range, "an ellipse of impossible size"});
  }
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::fabs(sweep) / kPart)));
  const double turn = sweep / count;
  const double handle = 4.0 / 3 * std::tan(turn / 4);
  const auto place = [&](double x, double y) {
    return centre + x * to_x + y * to_y;
  };
  for (int i = 0; i < count; ++i) {
    const double from = begin + turn * i;
    const double to = begin + turn * (i + 1);
    const double ax = std::cos(from);
    const double ay = std::sin(from);
    const double bx = std::cos(to);
    const double by = std::sin(to);
    cubic_to(place(ax - handle * ay, ay + handle * ax),
             place(bx + handle * by, by - handle * bx),
             i + 1 < count ? place(bx, by) : end);
  }
}

void RealDrawing::close() {
  if (!in_path_ || !status_) return;
  RealPath& path = paths_.back();
  const RealPoint origin = path.origin;
  const double size = std::fabs(origin.x) + std::fabs(origin.y);
  if (at_ != origin && !path.pieces.empty() && near(at_, origin, 1e-3 * size)) {
    path.pieces.back().end = origin;
  } else if (at_ != origin) {
    line_to(origin);
  }
  path.closed = true;
  at_ = origin;
  in_path_ = false;
}

void RealDrawing::end_path() {
  if (in_path_ && status_) {
    RealPath& path = paths_.back();
    if (path.pieces.empty()) {
      paths_.pop_back();  // a move without a line
    } else if (path.filled) {
      close();
    } else if (path.pieces.size() == 1 && at_ == path.origin &&
               path.pieces.front().kind == RealPiece::Kind::line) {
      path.pieces.clear();  // a point
    }
  }
  in_path_ = false;
}

}  // namespace unstep
