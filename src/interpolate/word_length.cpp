// The word-length and table-size rules of D3 and D4.

#include <cmath>
#include <numbers>

#include "unstep/interpolate.h"

namespace unstep {

int word_length_linear(double feed, double period, double dz) {
  // The largest increment must be below 2^n - 1.
  return static_cast<int>(std::ceil(std::log2(feed * period / dz + 1)));
}

int word_length_circular(double radius_max, double dz) {
  return static_cast<int>(std::ceil(std::log2(radius_max / dz)));
}

std::int64_t rom_nodes(double radius, double dz, int chord_bits) {
  const double chord = std::ldexp(dz, chord_bits);
  return static_cast<std::int64_t>(
      std::ceil(std::numbers::pi / (4 * std::asin(chord / (2 * radius)))));
}

std::int64_t rom_bytes(std::int64_t nodes, int word_bits, RomForm form,
                       int address_bits) {
  const int bits =
      form == RomForm::values ? word_bits : word_bits - address_bits;
  return (2 * (nodes - 1) * bits + 7) / 8;
}

double rom_linear_step(double delta) { return std::sqrt(8 * delta); }

}  // namespace unstep
