#include "formats/svg_path_parser.h"

#include <array>
#include <cmath>
#include <string>

#include "formats/text_scanner.h"

namespace unstep {
namespace {

/// Sums of relative moves gather rounding errors; a value this close to a
/// decimal of 9 places is one.
double snapped(double value) {
  const double scaled = value * 1e9;
  const double whole = std::nearbyint(scaled);
  return std::fabs(scaled - whole) < 0.01 ? whole / 1e9 : value;
}
RealPoint snapped(RealPoint p) { return {snapped(p.x), snapped(p.y)}; }

class PathParser {
 public:
  PathParser(std::string_view data, FigurePen& pen)
      : scanner_(data), pen_(pen) {}

  Status parse();

 private:
  [[nodiscard]] Status fault(const char* reason) const {
    return Error{ErrorCode::corrupt,
                 "path data, character " +
                     std::to_string(scanner_.position() + 1) + ": " + reason};
  }
  bool read(double& value);
  bool read_flag(bool& value);
  bool read_point(RealPoint& p);
  bool draw(char command);
  bool draw_line(char command);
  bool draw_curve(char command);
  bool draw_arc();
  void begin_if_closed();

  TextScanner scanner_;
  FigurePen& pen_;
  bool relative_ = false;
  bool closed_ = false;  ///< a z came last: a line starts a path anew
  RealPoint start_;      ///< of the subpath
  RealPoint at_;
  RealPoint control_;  ///< the last one of the last curve
  char last_ = 0;      ///< the last command, upper case
};

bool PathParser::read(double& value) {
  scanner_.skip_separator();
  const std::optional<double> number = scanner_.number();
  if (number) value = *number;
  return number.has_value();
}

/// Flags may stand without separators: "a5 5 0 013 4".
bool PathParser::read_flag(bool& value) {
  scanner_.skip_separator();
  const char c = scanner_.peek();
  if (c != '0' && c != '1') return false;
  scanner_.skip(1);
  value = c == '1';
  return true;
}

bool PathParser::read_point(RealPoint& p) {
  if (!read(p.x) || !read(p.y)) return false;
  if (relative_) p = snapped(p + at_);
  return true;
}

void PathParser::begin_if_closed() {
  if (closed_) pen_.move_to(start_);
  closed_ = false;
}

bool PathParser::draw_line(char command) {
  RealPoint to = at_;
  if (command == 'H' || command == 'V') {
    double& side = command == 'H' ? to.x : to.y;
    double value = 0;
    if (!read(value)) return false;
    side = relative_ ? snapped(side + value) : value;
  } else if (!read_point(to)) {
    return false;
  }
  begin_if_closed();
  pen_.line_to(to);
  at_ = to;
  return true;
}

bool PathParser::draw_curve(char command) {
  const bool cubic = command == 'C' || command == 'S';
  const bool smooth = command == 'S' || command == 'T';
  const bool follows =
      cubic ? last_ == 'C' || last_ == 'S' : last_ == 'Q' || last_ == 'T';
  const RealPoint mirrored = follows ? at_ + at_ - control_ : at_;
  RealPoint first = mirrored;
  RealPoint second;
  RealPoint end;
  if (!smooth && !read_point(first)) return false;
  if (cubic && !read_point(second)) return false;
  if (!read_point(end)) return false;
  begin_if_closed();
  if (cubic) {
    pen_.cubic_to(first, second, end);
    control_ = second;
  } else {  // the cubic that is the same curve
    pen_.cubic_to(at_ + (2.0 / 3) * (first - at_),
                  end + (2.0 / 3) * (first - end), end);
    control_ = first;
  }
  at_ = end;
  return true;
}

/// SVG 1.1, appendix F.6: from both ends to the centre.
bool PathParser::draw_arc() {
  RealPoint radii;
  double degrees = 0;
  bool large = false;
  bool sweep = false;
  RealPoint end;
  if (!read(radii.x) || !read(radii.y) || !read(degrees) || !read_flag(large) ||
      !read_flag(sweep) || !read_point(end)) {
    return false;
  }
  begin_if_closed();
  radii = {std::fabs(radii.x), std::fabs(radii.y)};
  if (end == at_) return true;
  if (radii.x == 0 || radii.y == 0) {
    pen_.line_to(end);
    at_ = end;
    return true;
  }
  const double angle = degrees * 3.14159265358979323846 / 180;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  // Half the chord, in the frame where the ellipse is a circle of radius 1.
  const RealPoint half = 0.5 * (at_ - end);
  const RealPoint turned{(cosine * half.x + sine * half.y) / radii.x,
                         (cosine * half.y - sine * half.x) / radii.y};
  const double length2 = turned.x * turned.x + turned.y * turned.y;
  // Radii that are too small to reach grow; the centre is then in the middle.
  double height = length2 >= 1 ? 0 : std::sqrt((1 - length2) / length2);
  if (large == sweep) height = -height;
  const RealPoint off{height * turned.y * radii.x,
                      -height * turned.x * radii.y};
  if (length2 > 1) radii = std::sqrt(length2) * radii;
  const RealPoint centre =
      0.5 * (at_ + end) +
      RealPoint{cosine * off.x - sine * off.y, sine * off.x + cosine * off.y};
  if (radii.x == radii.y) {
    pen_.arc_to(snapped(centre), end, sweep);
  } else {
    pen_.ellipse_to(centre, radii, angle, end, sweep, false);
  }
  at_ = end;
  return true;
}

bool PathParser::draw(char command) {
  switch (command) {
    case 'M': {
      RealPoint to;
      if (!read_point(to)) return false;
      pen_.move_to(to);
      closed_ = false;
      at_ = start_ = to;
      return true;
    }
    case 'L':
    case 'H':
    case 'V': return draw_line(command);
    case 'C':
    case 'S':
    case 'Q':
    case 'T': return draw_curve(command);
    default: return draw_arc();
  }
}

Status PathParser::parse() {
  constexpr std::string_view kCommands = "MLHVCSQTAZ";
  scanner_.skip_blanks();
  if (scanner_.rest() == "none") return {};
  char command = 0;
  while (scanner_.skip_blanks(), !scanner_.at_end()) {
    const char c = scanner_.peek();
    if (is_letter(c)) {
      const char upper = c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
      if (kCommands.find(upper) == std::string_view::npos) {
        return fault("unknown command");
      }
      if (command == 0 && upper != 'M') return fault("expected a move first");
      scanner_.skip(1);
      command = upper;
      relative_ = c != upper;
    } else if (command == 0 || command == 'Z') {
      return fault("expected a command");
    } else if (command == 'M') {
      command = 'L';
    }
    if (command == 'Z') {
      pen_.close();
      at_ = start_;
      closed_ = true;
    } else if (!draw(command)) {
      return fault("expected a number");
    }
    last_ = command;
    if (command != 'Z') {
      scanner_.skip_blanks();
      if (scanner_.peek() == ',') scanner_.skip(1);
    }
  }
  return {};
}

}  // namespace

Status draw_svg_path(std::string_view data, FigurePen& pen) {
  return PathParser(data, pen).parse();
}

}  // namespace unstep
