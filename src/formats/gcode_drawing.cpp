#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "formats/gcode_number.h"
#include "formats/gcode_tool.h"
#include "formats/outline.h"
#include "program/units.h"
#include "unstep/program.h"

/// Drawings to programs. docs/cnc.md, "From a drawing".
namespace unstep {
namespace {

/// Of lines that stand for an arc, mm.
constexpr double kFlatLimit = 0.002;

struct Place {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

bool is_printable(const std::string& lines) {
  return std::ranges::all_of(
      lines, [](char c) { return c == '\n' || (c >= ' ' && c != 127); });
}

/// Makes the text of the program, which the reader then understands.
class Drawer {
 public:
  Drawer(const Drawing& drawing, const DrawProgramOptions& options)
      : drawing_(drawing), options_(options), tool_(options, text_) {
    mm_x_ = options.unit_x / drawing.scale;
    mm_y_ = options.unit_y / drawing.scale;
    frame_.flip = drawing.canvas.y_axis == YAxis::down;
    frame_.height =
        frame_.flip ? std::int64_t{drawing.canvas.height} * drawing.scale : 0;
  }

  Status draw() {
    tool_.begin();
    Outline outline;
    for (const Chain& chain : drawing_.chains) {
      if (Status valid = check_chain(chain, drawing_.canvas.y_axis); !valid) {
        return valid;
      }
      to_outline(chain, drawing_.canvas.y_axis, drawing_.scale, frame_,
                 outline);
      if (Status done = draw(outline); !done) return done;
    }
    for (const Path& path : drawing_.paths) {
      if (Status valid = check_path(path); !valid) return valid;
      to_outline(path, frame_, outline);
      wide_ = wide_ || path.width > 0;
      if (Status done = draw(outline); !done) return done;
    }
    tool_.end();
    return {};
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool wide() const { return wide_; }
  [[nodiscard]] bool flattened() const { return flattened_; }
  [[nodiscard]] std::uint64_t vanished() const { return vanished_; }

 private:
  /// mm of a place in path units, in program units on the grid of decimals.
  [[nodiscard]] std::int64_t rounded(double mm) const {
    return round_number(std::llround(mm * kPerMm), options_.decimals);
  }
  [[nodiscard]] bool placed(double x, double y, Place& place) const {
    const double mm_x = x * mm_x_;
    const double mm_y = y * mm_y_;
    constexpr double kFar = static_cast<double>(kMaxProgramLength) / kPerMm;
    if (!(std::abs(mm_x) < kFar) || !(std::abs(mm_y) < kFar)) return false;
    place = {rounded(mm_x), rounded(mm_y)};
    return true;
  }
  static Error too_far() {
    return {ErrorCode::out_of_range, "a position beyond 100 km"};
  }

  void go(const char* word, Place to) {
    text_ += word;
    text_ += " X";
    append_number(text_, to.x);
    text_ += " Y";
    append_number(text_, to.y);
    at_ = to;
  }
  void feed() {
    append_gcode_number(text_, " F", options_.feed, 4);
    text_ += '\n';
  }
  void line_to(Place to) {
    if (to == at_) return;
    go("G1", to);
    feed();
    moved_ = true;
  }

  Status draw(const Outline& outline) {
    auto x = static_cast<double>(outline.origin.x);
    auto y = static_cast<double>(outline.origin.y);
    Place start;
    if (!placed(x, y, start)) return too_far();
    go("G0", start);
    text_ += '\n';
    tool_.on();
    moved_ = false;
    for (const Piece& piece : outline.pieces) {
      if (piece.is_arc) {
        if (Status done = draw_arc(x, y, piece); !done) return done;
      }
      x += static_cast<double>(piece.end.x);
      y += static_cast<double>(piece.end.y);
      Place end;
      if (!placed(x, y, end)) return too_far();
      line_to(end);
    }
    if (!moved_ && !outline.pieces.empty()) ++vanished_;
    tool_.off();
    return {};
  }

  Status draw_arc(double x, double y, const Piece& arc) {
    if (mm_x_ == mm_y_ && draw_round(x, y, arc)) return {};
    flattened_ = true;
    Status done;
    unstep::flatten(arc, kFlatLimit / std::max(mm_x_, mm_y_),
                    [&](double dx, double dy) {
                      Place to;
                      if (placed(x + dx, y + dy, to)) {
                        line_to(to);
                      } else {
                        done = too_far();
                      }
                    });
    return done;
  }

  /// Between the rounded ends, about the centre that they leave. False where a
  /// control might see another arc.
  bool draw_round(double x, double y, const Piece& arc) {
    const RealCircle circle = circle_of(arc);
    const double radius = circle.radius * mm_x_;
    const ArcRules& rules = options_.rules;
    if (radius < rules.min_radius_mm || radius > rules.max_radius_mm) {
      return false;
    }
    Place end = at_;
    Place centre;
    if (!placed(x + circle.x, y + circle.y, centre)) return false;
    if (!arc.is_circle()) {
      if (!placed(x + static_cast<double>(arc.end.x),
                  y + static_cast<double>(arc.end.y), end)) {
        return false;
      }
      const auto ex = static_cast<double>(end.x - at_.x);
      const auto ey = static_cast<double>(end.y - at_.y);
      const double step = std::pow(10.0, 7 - options_.decimals);
      const double sweep = sweep_of(arc);
      if (std::hypot(ex, ey) < 8 * step) return sweep < 3 && end == at_;
      // What a line does as well.
      if (radius * (1 - std::cos(sweep / 2)) * kPerMm < step / 2) return false;
      const auto px = static_cast<double>(arc.end.x);
      const auto py = static_cast<double>(arc.end.y);
      const double height = (px * static_cast<double>(arc.centre.y) -
                             py * static_cast<double>(arc.centre.x)) /
                            (px * px + py * py);
      centre = {at_.x + rounded((ex / 2 - height * ey) / kPerMm),
                at_.y + rounded((ey / 2 + height * ex) / kPerMm)};
    }
    if (!radii_agree(centre, end)) return false;
    const Place start = at_;
    go(arc.ascending ? "G3" : "G2", end);
    text_ += " I";
    append_number(text_, centre.x - start.x);
    text_ += " J";
    append_number(text_, centre.y - start.y);
    feed();
    moved_ = true;
    return true;
  }

  [[nodiscard]] bool radii_agree(Place centre, Place end) const {
    const auto radius = [&centre](Place p) {
      return std::hypot(static_cast<double>(p.x - centre.x),
                        static_cast<double>(p.y - centre.y)) /
             kPerMm;
    };
    const double first = radius(at_);
    const double last = radius(end);
    return first > 0 && last > 0 &&
           std::abs(first - last) <=
               std::max(options_.rules.radius_mm,
                        options_.rules.radius_relative * first);
  }

  const Drawing& drawing_;
  const DrawProgramOptions& options_;
  Frame frame_;
  double mm_x_ = 1;
  double mm_y_ = 1;
  std::string text_;
  GcodeTool tool_;
  Place at_;
  bool moved_ = false;
  bool wide_ = false;
  bool flattened_ = false;
  std::uint64_t vanished_ = 0;
};

Status check(const Drawing& drawing, const DrawProgramOptions& options) {
  const auto within = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  if (drawing.scale < 1 || drawing.scale > Drawing::kMaxScale) {
    return Error{ErrorCode::out_of_range, "a scale outside 1 to 1048576"};
  }
  if (!within(options.unit_x, 1e-7, 1e6) ||
      !within(options.unit_y, 1e-7, 1e6)) {
    return Error{ErrorCode::out_of_range,
                 "a grid unit is 0.0000001 mm to 1 km"};
  }
  if (!within(options.feed, 1e-3, 1e7) ||
      !within(options.plunge_feed, 1e-3, 1e7) ||
      !within(options.spindle, 0, 1e7) || !within(options.power, 0, 1e7)) {
    return Error{ErrorCode::out_of_range,
                 "feeds are 0.001 to 10,000,000 mm/min, speed and power 0 to "
                 "10,000,000"};
  }
  const bool z_given = options.cut_z > -1e9;
  if (!within(options.travel_z, -1e6, 1e6) ||
      (z_given && !within(options.cut_z, -1e6, 1e6)) || options.decimals < 0 ||
      options.decimals > 7) {
    return Error{ErrorCode::out_of_range,
                 "heights are within 1 km, decimals 0 to 7"};
  }
  if (!is_printable(options.tool_on) || !is_printable(options.tool_off)) {
    return Error{ErrorCode::invalid_argument,
                 "control characters in the lines for the tool"};
  }
  return {};
}

}  // namespace

Result<Program> draw_program(const Drawing& drawing,
                             const DrawProgramOptions& options,
                             std::vector<std::string>* notes) {
  if (Status valid = check(drawing, options); !valid) return valid.error();
  try {
    Drawer drawer(drawing, options);
    if (Status drawn = drawer.draw(); !drawn) return drawn.error();
    Result<Program> program = read_gcode(drawer.text(), {});
    if (!program || notes == nullptr) return program;
    if (drawing.paint == Paint::fill && drawing.chains.empty()) {
      notes->emplace_back("filled areas are outlines in the program");
    }
    if (drawer.wide()) notes->emplace_back("widths of pens are not kept");
    if (drawer.flattened()) {
      notes->emplace_back("arcs that the control would not take are lines");
    }
    if (drawer.vanished() > 0) {
      notes->push_back(std::to_string(drawer.vanished()) +
                       " paths are smaller than the last decimal");
    }
    return program;
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the program"};
  }
}

}  // namespace unstep
