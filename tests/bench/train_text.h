#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "codec/warm_start.h"
#include "unstep/formats.h"

/// What the programs that make warm starts share.
namespace unstep::bench {

/// The first page of an image; nothing if it is none.
inline std::optional<Bitmap> first_page(const std::string& path) {
  Result<std::vector<std::uint8_t>> bytes =
      read_file(path, std::uint64_t{1} << 32);
  if (!bytes) return std::nullopt;
  Result<RasterReader> reader = RasterReader::open(*std::move(bytes), {});
  if (!reader) return std::nullopt;
  Result<RasterPage> page = reader->read(0);
  if (!page) return std::nullopt;
  return std::move(page->ink);
}

/// A number as characters of six bits, the highest first.
inline std::string to_text(unsigned value, int characters) {
  std::string text;
  for (int i = characters; i-- > 0;) {
    text += codec::warm::to_char(value >> (6 * i) & 63);
  }
  return text;
}

/// Pieces of a string literal, a line each, without trigraphs.
inline void print_text(std::FILE* out, const std::string& text) {
  for (std::size_t i = 0; i < text.size(); i += 72) {
    std::string line = text.substr(i, 72);
    for (std::size_t k = 0; (k = line.find("??", k)) != std::string::npos;) {
      line.insert(++k, "\"\"");
    }
    std::fprintf(out, "    \"%s\"\n", line.c_str());
  }
}

/// What weights of a mixer came to, of one vector or of many.
template <std::size_t kInputs>
struct WeightSum {
  std::array<double, kInputs> weights{};
  double votes = 0;

  /// `learned`: kInputs weights, which have seen `age` bits.
  template <class Weights>
  void add(const Weights& learned, std::uint16_t age) {
    const double share = std::sqrt(age);
    for (std::size_t i = 0; i < kInputs; ++i) weights[i] += share * learned[i];
    votes += share;
  }
  [[nodiscard]] double mean(std::size_t i) const { return weights[i] / votes; }
};

/// A vector as a warm start holds it (codec/warm_start.h); nothing if it is as
/// all others.
/// `one`: a weight of 1 in 12 fractional bits times as much.
template <std::size_t kInputs>
std::string vector_text(std::size_t number, const WeightSum<kInputs>& sum,
                        const WeightSum<kInputs>& all, int characters = 2,
                        double one = 4.0) {
  constexpr double kSharedVotes = 20;  // of what it shares with all others
  const double step = one * codec::warm::kWeightStep;
  std::string text = to_text(static_cast<unsigned>(number), characters);
  bool differs = false;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const double own = (sum.weights[i] + kSharedVotes * all.mean(i)) /
                       (sum.votes + kSharedVotes);
    const long steps =
        std::clamp(std::lround((own - all.mean(i)) / step), -32L, 31L);
    differs = differs || steps != 0;
    text += to_text(static_cast<unsigned>(steps + 32), 1);
  }
  return differs ? text : "";
}

}  // namespace unstep::bench
