#include "formats/svg_style.h"

#include <array>
#include <cstdint>
#include <optional>

#include "formats/characters.h"
#include "formats/text_scanner.h"

namespace unstep {
namespace {

/// Rules are read for every element that they fit: short ones keep the time
/// linear. Many selectors of one rule are as bounded.
constexpr std::size_t kMaxRule = 4096;

/// Calls visit(part) for the parts between separators, blanks removed.
template <class Visit>
void split(std::string_view text, char separator, const Visit& visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view part = trimmed(text.substr(0, end));
    if (!part.empty()) visit(part);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::string without_comments(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t begin = text.find("/*");
    plain += text.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const std::size_t end = text.find("*/", begin + 2);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
  }
  return plain;
}

bool is_plain_selector(std::string_view selector) {
  if (selector == "*") return true;
  if (selector.front() == '.' || selector.front() == '#') {
    selector.remove_prefix(1);
  }
  if (selector.empty()) return false;
  for (const char c : selector) {
    if (!is_letter(c) && !is_digit(c) && c != '-' && c != '_') {
      return false;
    }
  }
  return true;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Rec. 601 luminance from 0 to 1; nothing if the colour is not known.
std::optional<double> luminance(std::string_view value) {
  std::array<double, 3> rgb{};
  if (value.starts_with('#')) {
    value.remove_prefix(1);
    if (value.size() != 3 && value.size() != 6) return std::nullopt;
    const std::size_t digits = value.size() / 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const int high = hex_digit(value[i * digits]);
      const int low = hex_digit(value[i * digits + digits - 1]);
      if (high < 0 || low < 0) return std::nullopt;
      rgb[i] = (high * 16 + low) / 255.0;
    }
  } else if (value.starts_with("rgb(")) {
    TextScanner scanner(value.substr(4));
    for (double& part : rgb) {
      scanner.skip_separator();
      const std::optional<double> number = scanner.number();
      if (!number) return std::nullopt;
      part = *number / (scanner.take('%') ? 100 : 255);
    }
  } else {
    constexpr std::array kLight{"white",      "snow",       "ivory",
                                "whitesmoke", "ghostwhite", "floralwhite",
                                "lightgray",  "lightgrey",  "gainsboro",
                                "beige",      "linen",      "azure"};
    if (value == "black") return 0;
    for (const char* name : kLight) {
      if (value == name) return 1;
    }
    return std::nullopt;
  }
  return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
}

/// Presentation attributes that a drawing does not keep, and what is said.
struct Unkept {
  std::string_view name;
  std::string_view harmless;  ///< the value that changes nothing
  const char* note;
};
constexpr std::array kUnkept{
    Unkept{"stroke-dasharray", "none", "dashes are drawn as whole lines"},
    Unkept{"stroke-linecap", "round", "pens have round ends"},
    Unkept{"stroke-linejoin", "round", "pens have round joints"},
    Unkept{"opacity", "1", "opacity is not kept"},
    Unkept{"clip-path", "none", "clipping is not applied"},
    Unkept{"mask", "none", "masks are not applied"},
    Unkept{"filter", "none", "filters are not applied"},
    Unkept{"marker-start", "none", "markers are left out"},
    Unkept{"marker-mid", "none", "markers are left out"},
    Unkept{"marker-end", "none", "markers are left out"},
};

bool is_clear(std::string_view value) {
  TextScanner scanner(value);
  const std::optional<double> opacity = scanner.number();
  return opacity && *opacity <= 0;
}

}  // namespace

std::optional<double> svg_length(std::string_view text, double whole) {
  TextScanner scanner(trimmed(text));
  const std::optional<double> number = scanner.number();
  if (!number) return std::nullopt;
  const std::string_view unit = scanner.rest();
  struct Unit {
    std::string_view name;
    double pixels;
  };
  constexpr std::array kUnits{
      Unit{"", 1},           Unit{"px", 1},         Unit{"in", 96},
      Unit{"cm", 96 / 2.54}, Unit{"mm", 96 / 25.4}, Unit{"pt", 96.0 / 72},
      Unit{"pc", 16},        Unit{"em", 16},        Unit{"ex", 8}};
  for (const Unit& known : kUnits) {
    if (unit == known.name) return *number * known.pixels;
  }
  if (unit == "%") return *number / 100 * whole;
  return std::nullopt;
}

void SvgStyles::add_sheet(std::string_view text) {
  const std::string plain = without_comments(text);
  std::string_view rest = plain;
  while (!trimmed(rest).empty()) {
    const std::size_t open = rest.find('{');
    const std::size_t end = rest.find('}', open);
    if (open == std::string_view::npos || end == std::string_view::npos) {
      notes_.insert("a style sheet is not understood to its end");
      return;
    }
    const std::string declarations(rest.substr(open + 1, end - open - 1));
    if (declarations.size() > kMaxRule) {
      notes_.insert("a style rule of more than 4096 characters is not applied");
      rest.remove_prefix(end + 1);
      continue;
    }
    split(rest.substr(0, open), ',', [&](std::string_view selector) {
      if (is_plain_selector(selector)) {
        std::string& rule = rules_[std::string(selector)];
        if (rule.size() + declarations.size() < kMaxRule) {
          rule += declarations + ";";
        }
      } else {
        notes_.insert(
            "style rules other than for a tag, class or id are not applied");
      }
    });
    rest.remove_prefix(end + 1);
  }
}

SvgStyle::Colour SvgStyles::colour_of(std::string_view value,
                                      double paper_from) {
  if (value == "none" || value == "transparent") return SvgStyle::Colour::none;
  if (value.starts_with("url(")) {
    notes_.insert("gradients and patterns are ink");
    return SvgStyle::Colour::ink;
  }
  const std::optional<double> light = luminance(value);
  if (light && *light > paper_from) return SvgStyle::Colour::paper;
  if (value != "currentColor" && (!light || *light != 0)) {
    notes_.insert("colours are not kept");
  }
  return SvgStyle::Colour::ink;
}

void SvgStyles::apply_property(std::string_view name, std::string_view value,
                               SvgStyle& style) {
  if (const std::size_t mark = value.find('!'); mark != value.npos) {
    value = trimmed(value.substr(0, mark));  // "!important"
  }
  if (value == "inherit") return;
  if (name == "fill") {
    style.fill = colour_of(value, 0.5);
  } else if (name == "stroke") {
    style.stroke = colour_of(value, 0.9);
  } else if (name == "stroke-width") {
    if (const auto width = svg_length(value, 100)) style.stroke_width = *width;
  } else if (name == "vector-effect") {
    style.hairline = value == "non-scaling-stroke";
  } else if (name == "fill-rule") {
    style.even_odd = value == "evenodd";
  } else if (name == "display") {
    if (value == "none") style.displayed = false;
  } else if (name == "visibility") {
    style.visible = value == "visible";
  } else if (name == "fill-opacity") {
    style.fill_is_clear = is_clear(value);
  } else if (name == "stroke-opacity") {
    style.stroke_is_clear = is_clear(value);
  } else {
    if (name == "opacity" && is_clear(value)) style.displayed = false;
    for (const Unkept& unkept : kUnkept) {
      if (name == unkept.name && value != unkept.harmless) {
        notes_.insert(unkept.note);
      }
    }
  }
}

void SvgStyles::apply_declarations(std::string_view text, SvgStyle& style) {
  split(text, ';', [&](std::string_view declaration) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) return;
    apply_property(trimmed(declaration.substr(0, colon)),
                   trimmed(declaration.substr(colon + 1)), style);
  });
}

void SvgStyles::apply_rule(const std::string& selector, SvgStyle& style) {
  const auto rule = rules_.find(selector);
  if (rule != rules_.end()) apply_declarations(rule->second, style);
}

void SvgStyles::apply(const pugi::xml_node& node, std::string_view name,
                      SvgStyle& style) {
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    apply_property(attribute.name(), trimmed(attribute.value()), style);
  }
  if (!rules_.empty()) {
    apply_rule("*", style);
    apply_rule(std::string(name), style);
    split(node.attribute("class").value(), ' ', [&](std::string_view word) {
      apply_rule("." + std::string(word), style);
    });
    apply_rule(std::string("#") + node.attribute("id").value(), style);
  }
  apply_declarations(node.attribute("style").value(), style);
}

}  // namespace unstep
