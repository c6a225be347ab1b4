#include "formats/dxf_entities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "formats/format_reader.h"
#include "formats/text.h"

namespace unstep {
namespace {

constexpr int kMaxInserts = 32;  ///< blocks in blocks
constexpr std::uint64_t kEntityMemory = 256;
constexpr std::size_t kMaxDegree = 3;  ///< of splines

RealPoint point(const DxfRecord& record, int code) {
  return {record.real(code, 0), record.real(code + 10, 0)};
}

RealPoint on_circle(RealPoint centre, double radius, double degrees) {
  // Quarters are exact.
  const double quarters = degrees / 90;
  const double angle = degrees * std::numbers::pi / 180;
  double cosine = std::cos(angle);
  double sine = std::sin(angle);
  if (quarters == std::floor(quarters)) {
    cosine = std::round(cosine);
    sine = std::round(sine);
  }
  return {centre.x + radius * cosine, centre.y + radius * sine};
}

/// A chord with a bulge: the tangent of a quarter of the angle.
void bulge_to(FigurePen& pen, RealPoint end, double bulge) {
  const RealPoint chord = end - pen.at();
  if (bulge == 0 || chord == RealPoint{}) return pen.line_to(end);
  const double height = (1 - bulge * bulge) / (4 * bulge);
  const RealPoint centre =
      pen.at() + 0.5 * chord + height * RealPoint{-chord.y, chord.x};
  pen.arc_to(centre, end, bulge > 0);
}

void draw_arc(const DxfRecord& record, RealDrawing& drawing, FigurePen& pen) {
  const RealPoint centre = point(record, 10);
  const double radius = record.real(40, 0);
  const double begin = record.real(50, 0);
  const double end = record.real(51, 360);
  if (!(radius > 0)) return;
  drawing.set_computed(true);
  pen.move_to(on_circle(centre, radius, begin));
  pen.arc_to(centre, on_circle(centre, radius, end), true);
  drawing.set_computed(false);
}

void draw_ellipse(const DxfRecord& record, RealDrawing& drawing,
                  FigurePen& pen) {
  const RealPoint centre = point(record, 10);
  const RealPoint major = point(record, 11);
  constexpr double kTurn = 2 * std::numbers::pi;
  const double longer = std::hypot(major.x, major.y);
  const double shorter = longer * std::fabs(record.real(40, 1));
  const double begin = record.real(41, 0);
  const double end = record.real(42, kTurn);
  if (!(longer > 0 && shorter > 0)) return;
  const double angle = std::atan2(major.y, major.x);
  const auto place = [&](double parameter) {
    const double x = longer * std::cos(parameter);
    const double y = shorter * std::sin(parameter);
    return RealPoint{centre.x + x * std::cos(angle) - y * std::sin(angle),
                     centre.y + x * std::sin(angle) + y * std::cos(angle)};
  };
  const bool full = std::fabs(std::fabs(end - begin) - kTurn) < 1e-9;
  drawing.set_computed(true);
  pen.move_to(place(begin));
  pen.ellipse_to(centre, {longer, shorter}, angle, full ? pen.at() : place(end),
                 true, full);
  if (full) pen.close();
  drawing.set_computed(false);
}

/// A B-spline of a degree up to 3, its Bezier points by its polar form (L.
/// Ramshaw, Blossoms are polar forms, 1989).
struct Spline {
  std::size_t degree = 3;
  std::vector<double> knots;
  std::vector<RealPoint> points;

  [[nodiscard]] bool is_sound() const {
    return degree >= 1 && degree <= kMaxDegree && points.size() > degree &&
           knots.size() == points.size() + degree + 1 &&
           std::is_sorted(knots.begin(), knots.end());
  }

  /// The polar form of the span from knot `span`, degree - ends times at its
  /// begin and `ends` times at its end.
  [[nodiscard]] RealPoint blossom(std::size_t span, std::size_t ends) const {
    std::array<RealPoint, kMaxDegree + 1> d;
    for (std::size_t i = 0; i <= degree; ++i) d[i] = points[span - degree + i];
    for (std::size_t r = 1; r <= degree; ++r) {
      const double t = r <= ends ? knots[span + 1] : knots[span];
      for (std::size_t i = degree; i >= r; --i) {
        const double low = knots[span - degree + i];
        const double high = knots[span + 1 + i - r];
        const double part = high > low ? (t - low) / (high - low) : 0;
        d[i] = (1 - part) * d[i - 1] + part * d[i];
      }
    }
    return d[degree];
  }
};

void draw_spline(const Spline& spline, FigurePen& pen) {
  bool first = true;
  for (std::size_t span = spline.degree; span < spline.points.size(); ++span) {
    if (spline.knots[span] == spline.knots[span + 1]) continue;
    std::array<RealPoint, kMaxDegree + 1> b;
    for (std::size_t i = 0; i <= spline.degree; ++i) {
      b[i] = spline.blossom(span, i);
    }
    if (first) pen.move_to(b[0]);
    first = false;
    if (spline.degree == 1) {
      pen.line_to(b[1]);
    } else if (spline.degree == 2) {
      pen.cubic_to(b[0] + (2.0 / 3) * (b[1] - b[0]),
                   b[2] + (2.0 / 3) * (b[1] - b[2]), b[2]);
    } else {
      pen.cubic_to(b[1], b[2], b[3]);
    }
  }
}

}  // namespace

Error DxfEntities::at(const DxfRecord& record, Error error) const {
  error.message = "line " + std::to_string(record.line) + ": " + error.message;
  return error;
}

void DxfEntities::leave_out(std::string_view kind) {
  if (left_out_.size() >= kNamedKinds && !left_out_.contains(kind)) {
    kind = "other";
  }
  ++left_out_[std::string(kind)];
}

std::set<std::string> DxfEntities::notes() const {
  std::set<std::string> all = notes_;
  for (const auto& [kind, count] : left_out_) {
    std::string line =
        std::to_string(count) + " " + to_utf8(kind) + " left out";
    for (char& c : line) {
      if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    all.insert(line);
  }
  if (layers_.size() > 1) all.insert("layers are merged");
  return all;
}

/// The frame of an entity: mirrored if it is seen from behind.
Affine DxfEntities::placed(const DxfRecord& record, const Affine& transform) {
  const double z = record.real(230, 1);
  if (record.real(210, 0) != 0 || record.real(220, 0) != 0) {
    notes_.insert(
        "entities that are not in the plane are drawn as if they were");
  }
  return z < 0 ? transform * Affine{-1, 0, 0, 1, 0, 0} : transform;
}

Status DxfEntities::draw_until(std::string_view end, const Affine* transform,
                               int depth) {
  DxfRecord record;
  for (;;) {
    const std::size_t begin = records_.place().offset;
    if (Status read = records_.next(record); !read) return read;
    // A block is read again wherever it is inserted; that has its price.
    if (depth > 0) drawing_.use_memory(records_.place().offset - begin);
    if (record.kind == end) return {};
    if (record.kind == "EOF" || record.kind == "ENDSEC") {
      return at(record, {ErrorCode::corrupt, "expected " + std::string(end)});
    }
    if (transform == nullptr) continue;
    drawing_.use_memory(kEntityMemory);
    Status drawn = draw(record, *transform, depth);
    if (!drawn) return drawn;
    drawing_.end_path();
    if (!drawing_.status()) return at(record, drawing_.status().error());
  }
}

Status DxfEntities::draw(const DxfRecord& record, const Affine& transform,
                         int depth) {
  const std::string_view kind = record.kind;
  if (kind == "POLYLINE") return polyline(record, transform);
  if (record.integer(60, 0) == 1) return {};  // invisible
  if (record.integer(67, 0) == 1) {
    leave_out("entity of paper space");
    return {};
  }
  if (const auto layer = record.text(8); layer && layers_.size() < 2) {
    layers_.insert(std::string(*layer));
  }
  if (kind == "INSERT") return insert(record, transform, depth);
  drawing_.set_style(false, 0);
  const Affine frame = placed(record, transform);
  FigurePen pen(drawing_,
                kind == "LINE" || kind == "POINT" ? transform : frame);
  if (kind == "LINE") {
    pen.move_to(point(record, 10));
    pen.line_to(point(record, 11));
  } else if (kind == "POINT") {
    pen.move_to(point(record, 10));
    pen.line_to(point(record, 10));
  } else if (kind == "CIRCLE") {
    const RealPoint centre = point(record, 10);
    const double radius = record.real(40, 0);
    if (!(radius > 0)) return {};
    pen.move_to({centre.x + radius, centre.y});
    pen.circle(centre, true);
    pen.close();
  } else if (kind == "ARC") {
    draw_arc(record, drawing_, pen);
  } else if (kind == "ELLIPSE") {
    draw_ellipse(record, drawing_, pen);
  } else if (kind == "LWPOLYLINE") {
    light_polyline(record, frame);
  } else if (kind == "SPLINE") {
    spline(record, transform);
  } else if (kind != "SEQEND" && kind != "ATTRIB" && kind != "ENDBLK") {
    leave_out(kind);
  }
  return {};
}

void DxfEntities::spline(const DxfRecord& record, const Affine& transform) {
  Spline spline;
  const int degree = record.integer(71, 3);
  spline.degree = degree < 1 ? 0 : static_cast<std::size_t>(degree);
  bool rational = false;
  double weight = -1;
  for (const DxfPair& pair : record.pairs) {
    const std::optional<double> value = dxf_number(pair.value);
    if (!value) continue;
    if (pair.code == 40) spline.knots.push_back(*value);
    if (pair.code == 10) spline.points.push_back({*value, 0});
    if (pair.code == 20 && !spline.points.empty()) {
      spline.points.back().y = *value;
    }
    if (pair.code == 41) {
      rational = rational || (weight >= 0 && *value != weight);
      weight = *value;
    }
  }
  drawing_.use_memory(64 * record.pairs.size());
  if (!drawing_.status()) return;
  if (!spline.is_sound() || rational) return leave_out("SPLINE");
  FigurePen pen(drawing_, transform);
  drawing_.set_computed(true);
  draw_spline(spline, pen);
  drawing_.set_computed(false);
  if ((record.integer(70, 0) & 1) != 0) pen.close();
}

void DxfEntities::draw_vertices(const std::vector<Vertex>& vertices,
                                bool closed, const Affine& transform) {
  if (vertices.empty()) return;
  const double width = vertices.front().begin_width;
  for (const Vertex& vertex : vertices) {
    if (vertex.begin_width != width || vertex.end_width != width) {
      notes_.insert("polylines of changing width have that of their start");
      break;
    }
  }
  drawing_.set_style(false, std::max(0.0, width) * transform.factor());
  FigurePen pen(drawing_, transform);
  pen.move_to(vertices.front().at);
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    bulge_to(pen, vertices[i].at, vertices[i - 1].bulge);
  }
  if (closed) {
    if (pen.at() != vertices.front().at) {
      bulge_to(pen, vertices.front().at, vertices.back().bulge);
    }
    pen.close();
  }
}

void DxfEntities::light_polyline(const DxfRecord& record,
                                 const Affine& transform) {
  std::vector<Vertex> vertices;
  const double width = record.real(43, 0);
  for (const DxfPair& pair : record.pairs) {
    const double value = dxf_number(pair.value).value_or(0);
    if (pair.code == 10) vertices.push_back({{value, 0}, 0, width, width});
    if (vertices.empty()) continue;
    Vertex& last = vertices.back();
    if (pair.code == 20) last.at.y = value;
    if (pair.code == 40) last.begin_width = value;
    if (pair.code == 41) last.end_width = value;
    if (pair.code == 42) last.bulge = value;
  }
  drawing_.use_memory(sizeof(Vertex) * vertices.size());
  draw_vertices(vertices, (record.integer(70, 0) & 1) != 0, transform);
}

Status DxfEntities::polyline(const DxfRecord& head, const Affine& transform) {
  constexpr int kClosed = 1;
  constexpr int kNotPlane = 8 | 16 | 64;  // in space, a mesh, faces
  constexpr int kFrame = 16;              // a vertex that a spline only nears
  const DxfRecord own = head;
  const int flags = own.integer(70, 0);
  const double begin_width = own.real(40, 0);
  const double end_width = own.real(41, begin_width);
  std::vector<Vertex> vertices;
  DxfRecord record;
  for (;;) {
    if (Status read = records_.next(record); !read) return read;
    if (record.kind == "SEQEND") break;
    if (record.kind != "VERTEX") {
      return at(record, {ErrorCode::corrupt, "expected VERTEX or SEQEND"});
    }
    drawing_.use_memory(2 * sizeof(Vertex));
    if (!drawing_.status()) return at(record, drawing_.status().error());
    if ((record.integer(70, 0) & kFrame) != 0) continue;
    vertices.push_back({point(record, 10), record.real(42, 0),
                        record.real(40, begin_width),
                        record.real(41, end_width)});
  }
  if (own.integer(60, 0) == 1) return {};
  if (own.integer(67, 0) == 1) {
    leave_out("entity of paper space");
    return {};
  }
  if ((flags & kNotPlane) != 0) {
    leave_out("POLYLINE in space");
    return {};
  }
  if (const auto layer = own.text(8); layer && layers_.size() < 2) {
    layers_.insert(std::string(*layer));
  }
  draw_vertices(vertices, (flags & kClosed) != 0, placed(own, transform));
  return {};
}

Status DxfEntities::insert(const DxfRecord& record, const Affine& transform,
                           int depth) {
  const auto block = blocks_.find(std::string(record.text(2).value_or("")));
  if (block == blocks_.end()) {
    leave_out("INSERT of an unknown block");
    return {};
  }
  if (depth >= kMaxInserts) {
    return at(record, {ErrorCode::limit_exceeded,
                       "blocks in blocks more than " +
                           std::to_string(kMaxInserts) + " deep"});
  }
  const RealPoint where = point(record, 10);
  const RealPoint turn = on_circle({}, 1, record.real(50, 0));
  const Affine rotation{turn.x, turn.y, -turn.y, turn.x, 0, 0};
  const RealPoint base = block->second.base;
  const Affine inner =
      Affine{record.real(41, 1), 0, 0, record.real(42, 1), 0, 0} *
      Affine{1, 0, 0, 1, -base.x, -base.y};
  const Affine outer = placed(record, transform);
  const int columns = std::max(1, record.integer(70, 1));
  const int rows = std::max(1, record.integer(71, 1));
  const double across = record.real(44, 0);
  const double up = record.real(45, 0);
  const DxfRecords::Place back = records_.place();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Affine all = outer * Affine{1, 0, 0, 1, where.x, where.y} *
                         rotation *
                         Affine{1, 0, 0, 1, column * across, row * up} * inner;
      drawing_.use_memory(kEntityMemory);
      records_.go_to(block->second.place);
      Status drawn = draw_until("ENDBLK", &all, depth + 1);
      if (!drawn) return drawn;
      if (!drawing_.status()) return drawing_.status();
    }
  }
  records_.go_to(back);
  return {};
}

}  // namespace unstep
