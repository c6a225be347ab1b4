#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "formats/affine.h"
#include "formats/format_reader.h"
#include "formats/grid_fit.h"
#include "formats/hpgl_encoded.h"
#include "formats/hpgl_scanner.h"
#include "formats/real_resolution.h"

/// HPGL, docs/vectors.md.
namespace unstep {
namespace {

constexpr double kUnitsPerInch = 1016;
constexpr double kUnitsPerMillimetre = 40;

/// P1 and P2 of an HP 7475A with A4 paper, where IP says nothing.
constexpr std::array<double, 4> kDefaultCorners{603, 521, 10603, 7721};

/// Instructions that change nothing of what a drawing keeps.
constexpr std::array<std::string_view, 33> kHarmless{
    "VS", "FS", "AS", "PT", "FT", "AC", "PS", "NP", "PC", "SD", "SI",
    "SR", "DI", "DR", "CS", "SA", "SS", "SL", "ES", "WU", "QL", "MC",
    "LA", "BP", "EC", "NR", "SO", "CR", "CT", "DT", "CO", "OP", "UL"};

class HpglReader {
 public:
  HpglReader(std::string_view bytes, const VectorReadOptions& options)
      : options_(options), scanner_(bytes), drawing_(options.limits) {}

  Result<std::vector<VectorPage>> read();

 private:
  using Values = std::vector<double>;

  Status run(std::string_view name);
  Status set_up(std::string_view name);
  Status move(bool down);
  Status arc(bool relative);
  Status circle();
  Status rectangle(bool relative, bool filled);
  Status polygon();
  Status encoded_lines();
  Status finish_page();
  Status count(const Values& values, std::size_t least) const;
  void reset();
  void pen_up();
  void begin_path();
  void go_to(RealPoint to);
  [[nodiscard]] Affine user_units() const;
  void use_units();
  void leave_out(std::string_view name);
  [[nodiscard]] Error at(const std::string& reason, ErrorCode code) const;

  const VectorReadOptions& options_;
  HpglScanner scanner_;
  RealDrawing drawing_;
  std::vector<VectorPage> pages_;
  Values values_;  ///< of the instruction
  RealPoint at_;
  bool down_ = false;
  bool relative_ = false;
  bool dot_ = false;  ///< the pen went down and has not moved
  bool in_path_ = false;
  double width_ = 0;  ///< millimetres
  std::array<double, 4> corners_ = kDefaultCorners;
  bool has_corners_ = false;
  std::optional<std::array<double, 4>> scaling_;  ///< xmin, xmax, ymin, ymax
  /// The units of the page are those of its first line; later ones are turned
  /// into them.
  std::optional<Affine> page_units_;
  Affine to_page_;
  std::map<std::string, std::uint64_t, std::less<>> left_out_;
  std::set<std::string> notes_;
  std::set<int> pens_;
};

Error HpglReader::at(const std::string& reason, ErrorCode code) const {
  return {code, "byte " + std::to_string(scanner_.instruction_offset()) + ": " +
                    reason};
}

Status HpglReader::count(const Values& values, std::size_t least) const {
  if (values.size() >= least) return {};
  return at("expected " + std::to_string(least) + " numbers",
            ErrorCode::corrupt);
}

void HpglReader::leave_out(std::string_view name) {
  if (left_out_.size() >= kNamedKinds && !left_out_.contains(name)) {
    name = "other";
  }
  ++left_out_[std::string(name)];
}

void HpglReader::reset() {
  pen_up();
  relative_ = false;
  scaling_.reset();
  corners_ = kDefaultCorners;
  has_corners_ = false;
  width_ = 0;
  use_units();
}

/// From user units to plotter units.
Affine HpglReader::user_units() const {
  if (!scaling_) return {};
  const auto& [left, right, bottom, top] = *scaling_;
  const double sx = (corners_[2] - corners_[0]) / (right - left);
  const double sy = (corners_[3] - corners_[1]) / (top - bottom);
  return {sx, 0, 0, sy, corners_[0] - sx * left, corners_[1] - sy * bottom};
}

void HpglReader::use_units() {
  const Affine now = user_units();
  if (!page_units_) {
    to_page_ = {};
    return;
  }
  const Affine& page = *page_units_;
  to_page_ = {
      now.a / page.a,           0, 0, now.d / page.d, (now.e - page.e) / page.a,
      (now.f - page.f) / page.d};
}

void HpglReader::begin_path() {
  if (in_path_) return;
  if (!page_units_) page_units_ = user_units();
  const Affine units = user_units();
  drawing_.set_style(false, width_ * kUnitsPerMillimetre / units.factor());
  drawing_.move_to(to_page_(at_));
  in_path_ = true;
  dot_ = false;
}

/// Lines that return to their start are closed.
void HpglReader::pen_up() {
  if (dot_) {
    begin_path();
    drawing_.line_to(to_page_(at_));
  }
  if (in_path_ && drawing_.status()) {
    const RealPath& path = drawing_.paths().back();
    const bool is_circle = path.pieces.size() == 1 &&
                           path.pieces.front().kind == RealPiece::Kind::circle;
    if (drawing_.at() == path.origin && (path.pieces.size() > 1 || is_circle)) {
      drawing_.close();
    }
    drawing_.end_path();
  }
  in_path_ = false;
  dot_ = false;
  down_ = false;
}

void HpglReader::go_to(RealPoint to) {
  if (down_) {
    begin_path();
    drawing_.line_to(to_page_(to));
  }
  at_ = to;
}

Status HpglReader::move(bool down) {
  if (values_.size() % 2 != 0) {
    return at("a coordinate without its pair", ErrorCode::corrupt);
  }
  for (std::size_t i = 0; i < values_.size(); i += 2) {
    const RealPoint value{values_[i], values_[i + 1]};
    const RealPoint to = relative_ ? at_ + value : value;
    if (down) {
      down_ = true;
      go_to(to);
    } else {
      at_ = to;
    }
  }
  return {};
}

Status HpglReader::arc(bool relative) {
  if (Status enough = count(values_, 3); !enough) return enough;
  RealPoint centre{values_[0], values_[1]};
  if (relative) centre = centre + at_;
  const double degrees = std::clamp(values_[2], -360.0, 360.0);
  const RealPoint from = at_ - centre;
  if (degrees == 0 || from == RealPoint{}) return {};
  const double angle = degrees * std::numbers::pi / 180;
  RealPoint end{centre.x + from.x * std::cos(angle) - from.y * std::sin(angle),
                centre.y + from.x * std::sin(angle) + from.y * std::cos(angle)};
  // Angles have few decimals; the end was a whole unit.
  const auto near = [](double value) {
    const double whole = std::round(value);
    return std::fabs(value - whole) < 0.05 ? whole : value;
  };
  end = {near(end.x), near(end.y)};
  const bool full = std::fabs(degrees) == 360;
  if (down_) {
    begin_path();
    FigurePen pen(drawing_, to_page_);
    pen.start_at(at_);
    drawing_.set_computed(true);
    if (full) {
      pen.circle(centre, degrees > 0);
    } else {
      pen.arc_to(centre, end, degrees > 0);
    }
    drawing_.set_computed(false);
  }
  if (!full) at_ = end;
  return {};
}

Status HpglReader::circle() {
  if (Status enough = count(values_, 1); !enough) return enough;
  const double radius = std::fabs(values_[0]);
  const bool was_down = down_;
  const RealPoint centre = at_;
  dot_ = false;
  pen_up();
  if (radius > 0) {
    at_ = {centre.x + radius, centre.y};
    begin_path();
    FigurePen pen(drawing_, to_page_);
    pen.start_at(at_);
    pen.circle(centre, true);
    pen_up();
  }
  at_ = centre;
  down_ = was_down;
  return {};
}

Status HpglReader::rectangle(bool relative, bool filled) {
  if (Status enough = count(values_, 2); !enough) return enough;
  if (filled) notes_.insert("fills are outlines");
  const bool was_down = down_;
  const RealPoint from = at_;
  RealPoint to{values_[0], values_[1]};
  if (relative) to = to + from;
  dot_ = false;
  pen_up();
  down_ = true;
  for (const RealPoint p :
       {RealPoint{to.x, from.y}, to, RealPoint{from.x, to.y}, from}) {
    go_to(p);
  }
  pen_up();
  down_ = was_down;
  return {};
}

/// Moves are relative and draw unless they say otherwise.
Status HpglReader::encoded_lines() {
  HpglEncodedLines lines(scanner_.encoded());
  while (const std::optional<HpglEncodedLines::Move> move = lines.next()) {
    const RealPoint value{move->x, move->y};
    const RealPoint to = move->absolute ? value : at_ + value;
    if (move->up) {
      pen_up();
      at_ = to;
    } else {
      down_ = true;
      go_to(to);
    }
    if (!drawing_.status()) break;
  }
  if (lines.faulty()) return at("a fault in encoded lines", ErrorCode::corrupt);
  return {};
}

/// The polygons that PM defines are drawn as they come.
Status HpglReader::polygon() {
  notes_.insert("polygons are outlines");
  const int mode =
      values_.empty() ? 0 : static_cast<int>(std::clamp(values_[0], -1.0, 9.0));
  if (mode > 0 && in_path_) {
    drawing_.close();
    in_path_ = false;
  }
  return {};
}

Status HpglReader::set_up(std::string_view name) {
  if (name == "IP") {
    has_corners_ = values_.size() == 4;
    corners_ = kDefaultCorners;
    if (has_corners_) std::copy_n(values_.begin(), 4, corners_.begin());
    if (corners_[0] == corners_[2] || corners_[1] == corners_[3]) {
      return at("scaling points in one place", ErrorCode::corrupt);
    }
  } else {
    scaling_.reset();
    if (!values_.empty()) {
      if (Status enough = count(values_, 4); !enough) return enough;
      if (values_[0] == values_[1] || values_[2] == values_[3]) {
        return at("a scale of no length", ErrorCode::corrupt);
      }
      scaling_ = {values_[0], values_[1], values_[2], values_[3]};
    }
  }
  const bool was_down = down_;
  pen_up();
  down_ = was_down;
  use_units();
  return {};
}

Status HpglReader::run(std::string_view name) {
  if (name == "PA" || name == "PR") {
    relative_ = name == "PR";
    return move(down_);
  }
  if (name == "PU") {
    pen_up();
    return move(false);
  }
  if (name == "PD") {
    dot_ = !down_ && values_.empty();
    down_ = true;
    return move(true);
  }
  if (name == "AA" || name == "AR") return arc(name == "AR");
  if (name == "CI") return circle();
  if (name == "EA" || name == "RA") return rectangle(false, name == "RA");
  if (name == "ER" || name == "RR") return rectangle(true, name == "RR");
  if (name == "IP" || name == "SC") return set_up(name);
  if (name == "PM") return polygon();
  if (name == "PE") return encoded_lines();
  if (name == "IN" || name == "DF") {
    reset();
  } else if (name == "SP") {
    const bool was_down = down_;
    pen_up();
    down_ = was_down;
    const double pen = values_.empty() ? 0 : values_[0];
    if (pen > 0 && pen < 1000) pens_.insert(static_cast<int>(pen));
    if (pens_.size() > 1) notes_.insert("pens are merged");
  } else if (name == "PW") {
    const bool was_down = down_;
    pen_up();
    down_ = was_down;
    width_ = values_.empty() ? 0 : std::clamp(values_[0], 0.0, 1e6);
  } else if (name == "LT") {
    if (!values_.empty()) notes_.insert("dashes are drawn as whole lines");
  } else if (name == "IW") {
    if (!values_.empty()) notes_.insert("clipping is not applied");
  } else if (name == "RO") {
    if (!values_.empty() && values_[0] != 0) {
      notes_.insert("the page is not turned");
    }
  } else if (name == "PG" || name == "AF" || name == "AH") {
    return finish_page();
  } else if (name != "EP" && name != "FP" &&
             std::find(kHarmless.begin(), kHarmless.end(), name) ==
                 kHarmless.end()) {
    leave_out(name);
  }
  return {};
}

Status HpglReader::finish_page() {
  pen_up();
  if (!drawing_.status()) {
    return at(drawing_.status().error().message,
              drawing_.status().error().code);
  }
  VectorPage& page = pages_.emplace_back();
  Result<Drawing> drawing =
      fit_to_grid(drawing_, {0, 0, YAxis::up}, Paint::stroke,
                  options_.curve_tolerance, page.notes);
  if (!drawing) return drawing.error();
  page.drawing = std::move(*drawing);
  const Affine units = page_units_.value_or(Affine{});
  if (!scaling_ || has_corners_) {
    page.info.resolution = {density(kUnitsPerInch, std::fabs(units.a), 0),
                            density(kUnitsPerInch, std::fabs(units.d), 0),
                            Resolution::Unit::inch};
    if (page.info.resolution.x.numerator == 0 ||
        page.info.resolution.y.numerator == 0) {
      page.info.resolution = {};
    }
  } else {
    page.notes.push_back("a scale without scaling points has no size");
  }
  if (units.a < 0 || units.d < 0) {
    page.notes.push_back("a mirrored scale is not mirrored back");
  }
  for (const auto& [name, number] : left_out_) {
    page.notes.push_back(std::to_string(number) + " " + name + " left out");
  }
  page.notes.insert(page.notes.end(), notes_.begin(), notes_.end());
  left_out_.clear();
  notes_.clear();
  page_units_.reset();
  use_units();
  const std::uint64_t used = drawing_.memory();
  drawing_ = RealDrawing(options_.limits);
  drawing_.use_memory(used);
  return {};
}

Result<std::vector<VectorPage>> HpglReader::read() {
  for (;;) {
    const Result<std::string_view> name = scanner_.next(values_);
    if (!name) return name.error();
    if (name->empty()) break;
    if (*name == "LB") {
      leave_out("LB");
    } else if (Status done = run(*name); !done) {
      return done.error();
    }
    drawing_.use_memory(0);
    if (!drawing_.status()) {
      return at(drawing_.status().error().message,
                drawing_.status().error().code);
    }
  }
  if (!scanner_.any()) {
    return Error{ErrorCode::bad_magic, "no HPGL instruction"};
  }
  pen_up();
  if (pages_.empty() || !drawing_.paths().empty()) {
    if (Status done = finish_page(); !done) return done.error();
  }
  return std::move(pages_);
}

}  // namespace

Result<std::vector<VectorPage>> read_hpgl(std::string_view bytes,
                                          const VectorReadOptions& options) {
  return HpglReader(bytes, options).read();
}

}  // namespace unstep
