#include "codec/path_model.h"

namespace unstep::codec {

PathModel::PathModel()
    : starts_(kPathTableBits), vectors_(kPathTableBits, vertices_) {
  starts_.expect_rows();
}

void PathModel::begin(const PathHead& head) {
  head_ = head;
  vectors_.begin();
  first_vertex_ = vertices_.add(head.origin, VertexMemory::kNone);
  density_.add(head.origin);
  place_ = {};
  last_ = {};
  place_.vertex = first_vertex_;
  place_.closed = head.closed;
  place_.left = head.elements;
}

void PathModel::end() {
  if (head_.closed && place_.vertex != first_vertex_) {
    vertices_.close(place_.vertex, first_vertex_);
  }
}

void PathModel::follow(const Path::Element& element) {
  place_.arc = element.kind == Path::Kind::arc;
  const Arc& arc = element.arc;
  advance(place_.arc ? Vec{arc.end.x, arc.end.y}
                     : Vec{element.segment.dx, element.segment.dy},
          {arc.centre.x, arc.centre.y}, arc.clockwise);
}

void PathModel::restart() {
  vertices_ = {};
  density_ = {};
  starts_.restart();
}

bool PathModel::in_range(const Vec& move) const {
  const Point at = vertices_[place_.vertex].at;
  const auto inside = [](std::int64_t v) {
    return v >= -kMaxCoord && v <= kMaxCoord;
  };
  return inside(at.x + move.x) && inside(at.y + move.y);
}

Path::Element PathModel::made(bool arc, const Vec& move, const Vec& centre,
                              bool clockwise) {
  const auto point = [](const Vec& v) {
    return Point{static_cast<std::int32_t>(v.x),
                 static_cast<std::int32_t>(v.y)};
  };
  if (arc) {
    return {Path::Kind::arc, {}, {point(centre), point(move), clockwise}};
  }
  const Point p = point(move);
  return {Path::Kind::segment, {p.x, p.y}, {}};
}

void PathModel::advance(const Vec& move, const Vec& centre, bool clockwise) {
  ++place_.index;
  --place_.left;
  // Seen with y down, a clockwise arc leaves its end towards (-y, x) of the
  // radius there.
  const Vec radius{move.x - centre.x, move.y - centre.y};
  if (!place_.arc) {
    place_.tangent = {};
  } else {
    place_.tangent =
        clockwise ? Vec{-radius.y, radius.x} : Vec{radius.y, -radius.x};
  }
  last_ = place_.arc ? place_.tangent : move;
  if (head_.closed && place_.left == 0) return;
  const Point from = vertices_[place_.vertex].at;
  const Point at{static_cast<std::int32_t>(from.x + move.x),
                 static_cast<std::int32_t>(from.y + move.y)};
  place_.vertex = vertices_.add(at, place_.vertex);
  density_.add(at);
  place_.home = head_.origin - at;
}

}  // namespace unstep::codec
