#include "formats/svg_shapes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "formats/svg_path_parser.h"
#include "formats/svg_style.h"
#include "formats/text_scanner.h"

namespace unstep {
namespace {

constexpr std::array<std::string_view, 7> kShapes{
    "path", "line", "polyline", "polygon", "rect", "circle", "ellipse"};

class ShapePen {
 public:
  ShapePen(const pugi::xml_node& node, const SvgViewport& viewport,
           FigurePen& pen)
      : node_(node), viewport_(viewport), pen_(pen) {}

  void line() {
    pen_.move_to({x("x1"), y("y1")});
    pen_.line_to({x("x2"), y("y2")});
  }
  Status poly(bool closed);
  void rect();
  void ellipse(double rx, double ry);

  double x(const char* name) { return length(name, viewport_.width); }
  double y(const char* name) { return length(name, viewport_.height); }
  double r(const char* name) { return length(name, viewport_.diagonal()); }
  [[nodiscard]] const Status& status() const { return status_; }

 private:
  double length(const char* name, double whole);
  void corner(RealPoint centre, RealPoint radii, RealPoint end);

  const pugi::xml_node& node_;
  const SvgViewport& viewport_;
  FigurePen& pen_;
  Status status_;
};

double ShapePen::length(const char* name, double whole) {
  const pugi::xml_attribute attribute = node_.attribute(name);
  const std::string_view text = attribute.value();
  if (text.empty() || text == "auto") return 0;
  const std::optional<double> value = svg_length(text, whole);
  if (!value && status_) {
    status_ = Error{ErrorCode::corrupt, std::string(name) + " is not a length"};
  }
  return value.value_or(0);
}

Status ShapePen::poly(bool closed) {
  TextScanner scanner(node_.attribute("points").value());
  scanner.skip_blanks();
  for (bool first = true; !scanner.at_end(); first = false) {
    const std::optional<double> px = scanner.number();
    scanner.skip_separator();
    const std::optional<double> py = px ? scanner.number() : std::nullopt;
    if (!py) {
      return Error{ErrorCode::corrupt,
                   "points, character " +
                       std::to_string(scanner.position() + 1) +
                       ": expected a number"};
    }
    if (first) {
      pen_.move_to({*px, *py});
    } else {
      pen_.line_to({*px, *py});
    }
    scanner.skip_separator();
  }
  if (closed) pen_.close();
  return {};
}

void ShapePen::corner(RealPoint centre, RealPoint radii, RealPoint end) {
  if (radii.x == radii.y) {
    pen_.arc_to(centre, end, true);
  } else {
    pen_.ellipse_to(centre, radii, 0, end, true, false);
  }
}

void ShapePen::rect() {
  const double left = x("x");
  const double top = y("y");
  const double width = x("width");
  const double height = y("height");
  if (width <= 0 || height <= 0) return;
  const auto is_given = [this](const char* name) {
    const std::string_view text = node_.attribute(name).value();
    return !text.empty() && text != "auto";
  };
  RealPoint radii{x("rx"), y("ry")};
  if (!is_given("ry")) radii.y = radii.x;
  if (!is_given("rx")) radii.x = radii.y;
  radii = {std::clamp(radii.x, 0.0, width / 2),
           std::clamp(radii.y, 0.0, height / 2)};
  const double right = left + width;
  const double bottom = top + height;
  if (radii.x == 0 || radii.y == 0) {
    pen_.move_to({left, top});
    pen_.line_to({right, top});
    pen_.line_to({right, bottom});
    pen_.line_to({left, bottom});
    pen_.close();
    return;
  }
  const auto [rx, ry] = radii;
  // Sides that the corners leave nothing of are not drawn.
  const auto side = [this](RealPoint to) {
    if (pen_.at() != to) pen_.line_to(to);
  };
  pen_.move_to({left + rx, top});
  side({right - rx, top});
  corner({right - rx, top + ry}, radii, {right, top + ry});
  side({right, bottom - ry});
  corner({right - rx, bottom - ry}, radii, {right - rx, bottom});
  side({left + rx, bottom});
  corner({left + rx, bottom - ry}, radii, {left, bottom - ry});
  side({left, top + ry});
  corner({left + rx, top + ry}, radii, {left + rx, top});
  pen_.close();
}

void ShapePen::ellipse(double rx, double ry) {
  if (rx <= 0 || ry <= 0) return;
  const RealPoint centre{x("cx"), y("cy")};
  pen_.move_to({centre.x + rx, centre.y});
  if (rx == ry) {
    pen_.circle(centre, true);
  } else {
    pen_.ellipse_to(centre, {rx, ry}, 0, pen_.at(), true, true);
  }
  pen_.close();
}

}  // namespace

bool is_svg_shape(std::string_view name) {
  return std::find(kShapes.begin(), kShapes.end(), name) != kShapes.end();
}

Status draw_svg_shape(const pugi::xml_node& node, std::string_view name,
                      const SvgViewport& viewport, FigurePen& pen) {
  if (name == "path") return draw_svg_path(node.attribute("d").value(), pen);
  ShapePen shape(node, viewport, pen);
  Status drawn;
  if (name == "line") {
    shape.line();
  } else if (name == "polyline" || name == "polygon") {
    drawn = shape.poly(name == "polygon");
  } else if (name == "rect") {
    shape.rect();
  } else if (name == "circle") {
    const double radius = shape.r("r");
    shape.ellipse(radius, radius);
  } else {
    shape.ellipse(shape.x("rx"), shape.y("ry"));
  }
  if (!drawn) return drawn;
  return shape.status();
}

}  // namespace unstep
