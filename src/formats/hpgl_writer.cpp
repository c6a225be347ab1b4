#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "formats/decimal.h"
#include "formats/outline_writer.h"
#include "formats/resolution.h"

/// HPGL, docs/vectors.md: plotter units of 1/40 mm, 1016 per inch.
namespace unstep {
namespace {

constexpr double kUnitsPerInch = 1016;

/// Plotter units of a grid unit whose size is not known: 0.25 mm.
constexpr double kDefaultUnits = 10;

/// Older plotters keep coordinates in 16 bits.
constexpr std::int64_t kFarthest = 32767;

/// Where arcs must become lines: their distance in plotter units.
constexpr double kFlatUnits = 0.25;

class HpglWriter : public OutlineWriter {
 public:
  explicit HpglWriter(VectorOutput& output)
      : OutlineWriter(YAxis::up), output_(output) {}

  Status begin(const PageHead& head) override;
  Status draw(const Outline& outline) override;
  Status end_page() override;
  Status finish() override;

 private:
  void choose_unit(const PageInfo& info);
  WidePoint plotted(double x, double y);
  WidePoint plotted(WidePoint at) {
    return plotted(static_cast<double>(at.x), static_cast<double>(at.y));
  }
  void append(WidePoint at);
  void line_to(WidePoint at);
  void end_lines();
  void set_pen(std::int64_t width);
  void draw_arc(WidePoint from, const Piece& arc);

  VectorOutput& output_;
  std::size_t pages_ = 0;
  GridUnit unit_;  ///< plotter units that a path unit takes
  std::int32_t scale_ = 1;
  bool in_lines_ = false;   ///< a PD that takes more points is open
  WidePoint at_;            ///< where the pen is
  std::int64_t width_ = 0;  ///< of the pen
};

void HpglWriter::choose_unit(const PageInfo& info) {
  unit_ = {kDefaultUnits, kDefaultUnits};
  std::optional<GridUnit> known;
  if (is_usable(info.resolution)) {
    known = grid_unit(info.resolution, kUnitsPerInch);
  }
  if (known) {
    unit_ = *known;
  } else {
    output_.note("no resolution: a grid unit is 0.25 mm");
  }
  if (unit_.x != unit_.y) {
    output_.note("pixels are not square: arcs become lines in the HPGL");
  }
}

Status HpglWriter::begin(const PageHead& head) {
  output_.text += pages_ == 0 ? "IN;SP1;\n" : "PG;\n";
  ++pages_;
  if (head.paint == Paint::fill) {
    output_.note("HPGL has no even-odd fill: filled areas are outlines");
  }
  if (!head.info.name.empty())
    output_.note("the page's name is not in the HPGL");
  if (!head.info.metadata.empty()) output_.note("metadata is not in the HPGL");
  choose_unit(head.info);
  scale_ = head.scale;
  unit_ = {unit_.x / head.scale, unit_.y / head.scale};
  width_ = 0;
  at_ = {-1, -1};
  return {};
}

WidePoint HpglWriter::plotted(double x, double y) {
  const double px = x * unit_.x;
  const double py = y * unit_.y;
  const WidePoint at{std::llround(px), std::llround(py)};
  if (std::fabs(px - static_cast<double>(at.x)) > 1e-6 ||
      std::fabs(py - static_cast<double>(at.y)) > 1e-6) {
    output_.note("coordinates are rounded to 1/40 mm");
  }
  if (std::abs(at.x) > kFarthest || std::abs(at.y) > kFarthest) {
    output_.note("coordinates above 32767, too large for some plotters");
  }
  return at;
}

void HpglWriter::append(WidePoint at) {
  append_integer(output_.text, at.x);
  output_.text += ',';
  append_integer(output_.text, at.y);
  at_ = at;
}

void HpglWriter::line_to(WidePoint at) {
  output_.text += in_lines_ ? "," : "PD";
  in_lines_ = true;
  append(at);
}

void HpglWriter::end_lines() {
  if (in_lines_) output_.text += ';';
  in_lines_ = false;
}

void HpglWriter::set_pen(std::int64_t width) {
  if (width == width_) return;
  width_ = width;
  output_.text += "PW";
  append_fixed(output_.text, static_cast<double>(width) * unit_.x / 40, 4);
  output_.text += ';';
}

/// AA draws around a centre from where the pen is, so the end is reached but
/// for the rounding of the centre; a last line goes there.
void HpglWriter::draw_arc(WidePoint from, const Piece& arc) {
  const auto fx = static_cast<double>(from.x);
  const auto fy = static_cast<double>(from.y);
  if (unit_.x != unit_.y) {
    flatten(arc, kFlatUnits / std::max(unit_.x, unit_.y),
            [&](double x, double y) { line_to(plotted(fx + x, fy + y)); });
    return;
  }
  const RealCircle circle = circle_of(arc);
  const WidePoint begin = at_;
  const WidePoint end = plotted(from + arc.end);
  const WidePoint centre = plotted(fx + circle.x, fy + circle.y);
  const WidePoint to_begin = begin - centre;
  const WidePoint to_end = end - centre;
  if (to_begin == WidePoint{} || to_end == WidePoint{}) {
    line_to(end);
    return;
  }
  const auto angle = [](WidePoint p) {
    return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
  };
  double sweep = sweep_of(arc);
  if (!arc.is_circle()) {
    // As seen from the rounded centre, the turn that is nearest to the exact.
    double turn = angle(to_end) - angle(to_begin);
    if (!arc.ascending) turn = -turn;
    constexpr double kTurn = 2 * std::numbers::pi;
    sweep = turn + kTurn * std::round((sweep - turn) / kTurn);
  }
  if (!in_lines_) output_.text += "PD";
  output_.text += ";AA";
  in_lines_ = false;
  append(centre);
  output_.text += ',';
  append_fixed(output_.text,
               (arc.ascending ? sweep : -sweep) * 180 / std::numbers::pi, 6);
  output_.text += ';';
  at_ = end;
  const double off =
      std::hypot(static_cast<double>(to_end.x), static_cast<double>(to_end.y)) -
      std::hypot(static_cast<double>(to_begin.x),
                 static_cast<double>(to_begin.y));
  if (!arc.is_circle() && std::fabs(off) > 0.05) line_to(end);
}

Status HpglWriter::draw(const Outline& outline) {
  set_pen(outline.width);
  const WidePoint start = plotted(outline.origin);
  output_.text += "PU";
  append(start);
  output_.text += ';';
  WidePoint at = outline.origin;
  for (const Piece& piece : outline.pieces) {
    if (piece.is_arc) {
      draw_arc(at, piece);
    } else {
      line_to(plotted(at + piece.end));
    }
    at = at + piece.end;
  }
  if (outline.pieces.empty()) line_to(start);
  end_lines();
  output_.text += '\n';
  return {};
}

Status HpglWriter::end_page() {
  output_.text += "PU;\n";
  return {};
}

Status HpglWriter::finish() {
  if (pages_ == 0) {
    return Error{ErrorCode::invalid_argument, "an HPGL file has a page"};
  }
  output_.text += "SP0;\n";
  return {};
}

}  // namespace

std::unique_ptr<FormatWriter> make_hpgl_writer(VectorOutput& output) {
  return std::make_unique<HpglWriter>(output);
}

}  // namespace unstep
