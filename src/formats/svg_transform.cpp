#include "formats/svg_transform.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "formats/text_scanner.h"

namespace unstep {
namespace {

/// One function; nothing if there is none of that name and count of numbers.
std::optional<Affine> function(std::string_view name,
                               const std::array<double, 6>& v,
                               std::size_t count) {
  const auto radians = [](double degrees) {
    return degrees * std::numbers::pi / 180;
  };
  if (name == "matrix" && count == 6) {
    return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  }
  if (name == "translate" && (count == 1 || count == 2)) {
    return Affine{1, 0, 0, 1, v[0], count == 2 ? v[1] : 0};
  }
  if (name == "scale" && (count == 1 || count == 2)) {
    return Affine{v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0};
  }
  if (name == "rotate" && (count == 1 || count == 3)) {
    // Quarters are exact.
    const double quarters = v[0] / 90;
    double cosine = std::cos(radians(v[0]));
    double sine = std::sin(radians(v[0]));
    if (quarters == std::floor(quarters)) {
      cosine = std::round(cosine);
      sine = std::round(sine);
    }
    const Affine turn{cosine, sine, -sine, cosine, 0, 0};
    if (count == 1) return turn;
    return Affine{1, 0, 0, 1, v[1], v[2]} * turn *
           Affine{1, 0, 0, 1, -v[1], -v[2]};
  }
  if (name == "skewX" && count == 1) {
    return Affine{1, 0, std::tan(radians(v[0])), 1, 0, 0};
  }
  if (name == "skewY" && count == 1) {
    return Affine{1, std::tan(radians(v[0])), 0, 1, 0, 0};
  }
  return std::nullopt;
}

}  // namespace

Result<Affine> parse_svg_transform(std::string_view text) {
  TextScanner scanner(text);
  const auto fault = [&scanner](const char* reason) {
    return Error{ErrorCode::corrupt,
                 "transform, character " +
                     std::to_string(scanner.position() + 1) + ": " + reason};
  };
  Affine all;
  scanner.skip_blanks();
  while (!scanner.at_end()) {
    const std::string_view name = scanner.take_word();
    if (name == "none" && scanner.at_end()) return all;
    scanner.skip_blanks();
    if (name.empty() || !scanner.take('(')) return fault("expected a function");
    std::array<double, 6> values{};
    std::size_t count = 0;
    scanner.skip_blanks();
    while (!scanner.take(')')) {
      const std::optional<double> value = scanner.number();
      if (!value || count == values.size()) return fault("expected a number");
      values[count++] = *value;
      scanner.skip_separator();
    }
    const std::optional<Affine> one = function(name, values, count);
    if (!one) return fault("unknown function or wrong count of numbers");
    all = all * *one;
    scanner.skip_separator();
  }
  return all;
}

}  // namespace unstep
