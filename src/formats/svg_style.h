#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unstep {

/// What an SVG element is drawn with: its own properties and those it has from
/// the elements around it.
struct SvgStyle {
  enum class Colour : std::uint8_t { none, ink, paper };
  Colour fill = Colour::ink;
  Colour stroke = Colour::none;
  double stroke_width = 1;
  bool hairline = false;  ///< vector-effect: non-scaling-stroke
  bool even_odd = false;
  bool visible = true;
  bool displayed =
      true;  ///< display: none is not inherited but hides all inside
  bool fill_is_clear = false;
  bool stroke_is_clear = false;
};

/// Rules of <style> elements with plain selectors (tag, .class, #id, *), and
/// what of the properties was met that a drawing does not keep.
class SvgStyles {
 public:
  void add_sheet(std::string_view text);

  /// `style` is what the parent has; attributes, then rules, then the style
  /// attribute change it.
  void apply(const pugi::xml_node& node, std::string_view name,
             SvgStyle& style);

  /// One line each.
  [[nodiscard]] const std::set<std::string>& notes() const { return notes_; }

 private:
  void apply_declarations(std::string_view text, SvgStyle& style);
  void apply_property(std::string_view name, std::string_view value,
                      SvgStyle& style);
  void apply_rule(const std::string& selector, SvgStyle& style);
  SvgStyle::Colour colour_of(std::string_view value, double paper_from);

  std::map<std::string, std::string> rules_;  ///< selector, declarations
  std::set<std::string> notes_;
};

/// A length with its unit in user units of 1/96 inch; percentages of `whole`.
/// Nothing if it is none.
[[nodiscard]] std::optional<double> svg_length(std::string_view text,
                                               double whole);

}  // namespace unstep
