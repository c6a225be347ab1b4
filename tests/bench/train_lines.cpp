// Makes src/reverse/line_price_prior.cpp from drawings:
//
//     train_lines OUT.cpp IMAGE...
//
// Traces every image, lays cheap lines at tolerances of 1 and 2 with the
// present prices, and counts them. A large drawing counts less than its lines.
// Without images it writes empty tables. train_path_coder.sh runs it.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "reverse/line_price.h"
#include "train_drawings.h"

namespace {

using namespace unstep;
using reverse::LinePrice;

constexpr double kFewLines = 400;     ///< in full; more count as their root
constexpr double kPriorLines = 2000;  ///< what all tables stand for

struct Sums {
  std::vector<double> turns;
  std::vector<double> lengths;
  double lines = 0;
};

std::vector<double> differences(const std::vector<std::uint32_t>& a,
                                const std::vector<std::uint32_t>& b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.push_back((static_cast<double>(a[i]) - b[i]) / LinePrice::kUnit);
  }
  return result;
}

void add(const std::vector<double>& values, double weight,
         std::vector<double>& sums) {
  sums.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) sums[i] += weight * values[i];
}

reverse::LineVertices vertices_of(const Path& path) {
  reverse::LineVertices vertices{{0, path.origin}};
  for (const Path::Element& element : path.elements) {
    const Point at = vertices.back().at;
    vertices.push_back(
        {0, {at.x + element.segment.dx, at.y + element.segment.dy}});
  }
  return vertices;
}

void count(const Drawing& drawing, Sums& sums) {
  const LinePrice before;
  LinePrice after;
  double lines = 0;
  for (const Path& path : drawing.paths) {
    std::int64_t steps = 0;
    for (const Path::Element& element : path.elements) {
      steps += std::abs(element.segment.dx) + std::abs(element.segment.dy);
    }
    if (path.closed && steps <= 8) continue;  // a speck keeps its corners
    after.count(vertices_of(path), path.closed);
    lines += static_cast<double>(path.elements.size());
  }
  const double weight = lines > kFewLines ? std::sqrt(kFewLines / lines) : 1.0;
  add(differences(after.turn_counts(), before.turn_counts()), weight,
      sums.turns);
  add(differences(after.length_counts(), before.length_counts()), weight,
      sums.lengths);
  sums.lines += weight * lines;
}

/// As LinePrice reads it: none, then four levels to the octave.
char level_of(double count) {
  if (count < 1) return '0';
  const double octave = std::floor(std::log2(count));
  const double part = count / std::exp2(octave);
  const int level = static_cast<int>(4 * octave + std::floor(4 * (part - 1)));
  return static_cast<char>('1' + level);
}

void print(std::FILE* out, const char* name, const std::vector<double>& sums,
           double scale) {
  std::fprintf(out, "\nconst std::string_view %s =", name);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (i % 72 == 0) std::fprintf(out, "%s\n    R\"(", i > 0 ? ")\"" : "");
    std::fputc(level_of(sums[i] * scale), out);
  }
  std::fprintf(out, sums.empty() ? "\n    \"\";\n" : ")\";\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: train_lines OUT.cpp IMAGE...\n");
    return 2;
  }
  Sums sums;
  for (int i = 2; i < argc; ++i) {
    for (const std::uint32_t tolerance : {1U, 2U}) {
      for (const Drawing& lines : bench::cheap_drawings(
               argv[i], {{tolerance, 1}, Effort::standard, false})) {
        count(lines, sums);
      }
    }
  }
  std::FILE* out = std::fopen(argv[1], "w");
  if (out == nullptr) return 1;
  const double scale =
      sums.lines > 0 ? kPriorLines * LinePrice::kUnit / sums.lines : 0;
  std::fprintf(out,
               "// Made by tests/bench/train_path_coder.sh; do not edit.\n"
               "// clang-format off\n"
               "#include \"reverse/line_price_prior.h\"\n\n"
               "namespace unstep::reverse::prior {\n");
  print(out, "kTurns", sums.turns, scale);
  print(out, "kLengths", sums.lengths, scale);
  std::fprintf(out, "\n}  // namespace unstep::reverse::prior\n");
  return std::fclose(out) == 0 ? 0 : 1;
}
