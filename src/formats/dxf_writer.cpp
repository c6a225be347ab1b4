#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "formats/decimal.h"
#include "formats/outline_writer.h"
#include "formats/resolution.h"

/// DXF of release 12, ASCII, docs/vectors.md.
namespace unstep {
namespace {

constexpr double kMillimetresPerInch = 25.4;

/// Positions in grid units have that many decimals more than their unit needs.
constexpr int kDecimalsOfGrid = 4;

/// Where arcs must become lines: their distance in grid units.
constexpr double kFlatLimit = 1.0 / 64;

enum class Unit : std::uint8_t { none = 0, inch = 1, millimetre = 4 };

class DxfWriter : public OutlineWriter {
 public:
  explicit DxfWriter(VectorOutput& output)
      : OutlineWriter(YAxis::up), output_(output) {}

  Status begin(const PageHead& head) override;
  Status draw(const Outline& outline) override;
  Status end_page() override;
  Status finish() override;

 private:
  void pair(int code, std::string_view value);
  void pair(int code, std::int64_t value);
  void real(int code, double value);
  void shortest(int code, double value);
  void x(int code, double value);
  void y(int code, double value);
  void place(WidePoint at, int code = 10);
  void entity(const char* kind);
  Unit choose_unit(const PageInfo& info);
  void write_header(const PageHead& head, Unit unit);
  void write_tables();
  bool draw_alone(const Outline& outline);
  void draw_circle(WidePoint from, const Piece& piece);
  void draw_arc(WidePoint from, const Piece& piece);
  void draw_polyline(const Outline& outline);
  void draw_piece(WidePoint from, const Piece& piece);
  void vertex(double from_x, double from_y, double bulge);

  VectorOutput& output_;
  bool had_page_ = false;
  const char* layer_ = "OUTLINE";
  GridUnit unit_;  ///< DXF units that a path unit takes
  int decimals_ = 0;
  bool square_ = true;  ///< a circle is one in the DXF too
  std::int32_t scale_ = 1;
};

void DxfWriter::pair(int code, std::string_view value) {
  append_integer(output_.text, code);
  output_.text += '\n';
  output_.text += value;
  output_.text += '\n';
}

void DxfWriter::pair(int code, std::int64_t value) {
  append_integer(output_.text, code);
  output_.text += '\n';
  append_integer(output_.text, value);
  output_.text += '\n';
}

void DxfWriter::real(int code, double value) {
  append_integer(output_.text, code);
  output_.text += '\n';
  const std::size_t begin = output_.text.size();
  append_fixed(output_.text, value, decimals_);
  // Some programs take a number without a point for an integer.
  if (output_.text.find('.', begin) == std::string::npos) {
    output_.text += ".0";
  }
  output_.text += '\n';
}

void DxfWriter::shortest(int code, double value) {
  append_integer(output_.text, code);
  output_.text += '\n';
  append_shortest(output_.text, value);
  output_.text += '\n';
}

void DxfWriter::x(int code, double value) { real(code, value * unit_.x); }
void DxfWriter::y(int code, double value) { real(code, value * unit_.y); }

void DxfWriter::place(WidePoint at, int code) {
  x(code, static_cast<double>(at.x));
  y(code + 10, static_cast<double>(at.y));
}

void DxfWriter::entity(const char* kind) {
  pair(0, kind);
  pair(8, layer_);
}

Unit DxfWriter::choose_unit(const PageInfo& info) {
  unit_ = {1, 1};
  if (!is_usable(info.resolution)) return Unit::none;
  const bool inch = info.resolution.unit == Resolution::Unit::inch;
  const auto known = grid_unit(info.resolution, inch ? 1 : kMillimetresPerInch);
  if (!known) {
    output_.note("a resolution without a unit of length is not in the DXF");
    return Unit::none;
  }
  unit_ = *known;
  return inch ? Unit::inch : Unit::millimetre;
}

Status DxfWriter::begin(const PageHead& head) {
  if (had_page_) {
    return Error{ErrorCode::invalid_argument,
                 "DXF has one page; write a file for each"};
  }
  had_page_ = true;
  layer_ = head.paint == Paint::fill ? "OUTLINE" : "PEN";
  if (head.paint == Paint::fill) {
    output_.note("DXF has no even-odd fill: filled areas are outlines");
  }
  if (!head.info.name.empty())
    output_.note("the page's name is not in the DXF");
  if (!head.info.metadata.empty()) output_.note("metadata is not in the DXF");
  const Unit unit = choose_unit(head.info);
  scale_ = head.scale;
  decimals_ = decimals_for(head.scale);
  if (unit != Unit::none) {
    const double finer = -std::log10(std::min(unit_.x, unit_.y));
    decimals_ = std::max(
        0, kDecimalsOfGrid + decimals_ + static_cast<int>(std::ceil(finer)));
    square_ = unit_.x == unit_.y;
    if (!square_) {
      output_.note("pixels are not square: arcs become lines in the DXF");
    }
  }
  unit_ = {unit_.x / head.scale, unit_.y / head.scale};
  write_header(head, unit);
  write_tables();
  pair(0, "SECTION");
  pair(2, "ENTITIES");
  return {};
}

void DxfWriter::write_header(const PageHead& head, Unit unit) {
  pair(0, "SECTION");
  pair(2, "HEADER");
  pair(9, "$ACADVER");
  pair(1, "AC1009");
  pair(9, "$INSUNITS");
  pair(70, static_cast<std::int64_t>(unit));
  if (head.box) {
    for (const bool limits : {false, true}) {
      pair(9, limits ? "$LIMMIN" : "$EXTMIN");
      place(head.box->low);
      if (!limits) real(30, 0);
      pair(9, limits ? "$LIMMAX" : "$EXTMAX");
      place(head.box->high);
      if (!limits) real(30, 0);
    }
  }
  pair(0, "ENDSEC");
}

void DxfWriter::write_tables() {
  pair(0, "SECTION");
  pair(2, "TABLES");
  pair(0, "TABLE");
  pair(2, "LTYPE");
  pair(70, 1);
  pair(0, "LTYPE");
  pair(2, "CONTINUOUS");
  pair(70, std::int64_t{0});
  pair(3, "Solid line");
  pair(72, 65);
  pair(73, std::int64_t{0});
  pair(40, "0.0");
  pair(0, "ENDTAB");
  pair(0, "TABLE");
  pair(2, "LAYER");
  pair(70, 2);
  for (const char* layer : {"0", layer_}) {
    pair(0, "LAYER");
    pair(2, layer);
    pair(70, std::int64_t{0});
    pair(62, 7);
    pair(6, "CONTINUOUS");
  }
  pair(0, "ENDTAB");
  pair(0, "ENDSEC");
}

void DxfWriter::draw_circle(WidePoint from, const Piece& piece) {
  entity("CIRCLE");
  place(from + piece.centre);
  x(40, std::hypot(static_cast<double>(piece.centre.x),
                   static_cast<double>(piece.centre.y)));
}

void DxfWriter::draw_arc(WidePoint from, const Piece& piece) {
  const RealCircle circle = circle_of(piece);
  const double begin = std::atan2(-circle.y, -circle.x);
  const double end = std::atan2(static_cast<double>(piece.end.y) - circle.y,
                                static_cast<double>(piece.end.x) - circle.x);
  const auto degrees = [](double angle) {
    return (angle < 0 ? angle + 2 * std::numbers::pi : angle) * 180 /
           std::numbers::pi;
  };
  entity("ARC");
  x(10, static_cast<double>(from.x) + circle.x);
  y(20, static_cast<double>(from.y) + circle.y);
  x(40, circle.radius);
  // DXF arcs turn counter-clockwise.
  shortest(50, degrees(piece.ascending ? begin : end));
  shortest(51, degrees(piece.ascending ? end : begin));
}

/// A lone line, arc or circle without width is an entity of its own.
bool DxfWriter::draw_alone(const Outline& outline) {
  if (outline.width != 0 || outline.pieces.size() != 1) return false;
  const Piece& piece = outline.pieces.front();
  if (piece.is_arc && !square_) return false;
  if (piece.is_circle()) {
    draw_circle(outline.origin, piece);
  } else if (outline.closed) {
    return false;
  } else if (piece.is_arc) {
    draw_arc(outline.origin, piece);
  } else {
    entity("LINE");
    place(outline.origin);
    place(outline.origin + piece.end, 11);
  }
  return true;
}

void DxfWriter::vertex(double from_x, double from_y, double bulge) {
  entity("VERTEX");
  x(10, from_x);
  y(20, from_y);
  if (bulge != 0) shortest(42, bulge);
}

/// The vertices where `piece` begins and, inside of it, where it has some; the
/// next piece begins with its end. A bulge is the tangent of a quarter of the
/// angle, above 0 if it turns counter-clockwise.
void DxfWriter::draw_piece(WidePoint from, const Piece& piece) {
  const auto fx = static_cast<double>(from.x);
  const auto fy = static_cast<double>(from.y);
  if (!piece.is_arc) {
    vertex(fx, fy, 0);
  } else if (!square_) {
    double last_x = fx;
    double last_y = fy;
    flatten(piece, kFlatLimit * scale_, [&](double dx, double dy) {
      vertex(last_x, last_y, 0);
      last_x = fx + dx;
      last_y = fy + dy;
    });
  } else if (piece.is_circle()) {
    const double bulge = piece.ascending ? 1 : -1;
    vertex(fx, fy, bulge);
    vertex(fx + 2 * static_cast<double>(piece.centre.x),
           fy + 2 * static_cast<double>(piece.centre.y), bulge);
  } else {
    const double bulge = std::tan(sweep_of(piece) / 4);
    vertex(fx, fy, piece.ascending ? bulge : -bulge);
  }
}

void DxfWriter::draw_polyline(const Outline& outline) {
  entity("POLYLINE");
  pair(66, 1);
  for (const int code : {10, 20, 30}) real(code, 0);
  if (outline.closed) pair(70, 1);
  if (outline.width != 0) {
    x(40, static_cast<double>(outline.width));
    x(41, static_cast<double>(outline.width));
  }
  WidePoint at = outline.origin;
  for (const Piece& piece : outline.pieces) {
    draw_piece(at, piece);
    at = at + piece.end;
  }
  if (!outline.closed) {
    vertex(static_cast<double>(at.x), static_cast<double>(at.y), 0);
  }
  entity("SEQEND");
}

Status DxfWriter::draw(const Outline& outline) {
  if (outline.pieces.empty()) {
    entity("POINT");
    place(outline.origin);
  } else if (!draw_alone(outline)) {
    draw_polyline(outline);
  }
  return {};
}

Status DxfWriter::end_page() {
  pair(0, "ENDSEC");
  pair(0, "EOF");
  return {};
}

Status DxfWriter::finish() {
  if (!had_page_) {
    return Error{ErrorCode::invalid_argument, "a DXF file has a page"};
  }
  return {};
}

}  // namespace

std::unique_ptr<FormatWriter> make_dxf_writer(VectorOutput& output) {
  return std::make_unique<DxfWriter>(output);
}

}  // namespace unstep
