#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "codec/warm_start.h"
#include "train_text.h"

/// Records of a warm start of turns (codec/warm_start.h), made from what models
/// learned on drawings.
namespace unstep::bench {

/// One context's counters, added up over the images.
struct Sum {
  std::array<double, 2> ones{};
  std::array<double, 2> total{};
  double score = 0;
};
using Key = std::uint32_t;  // index << 12 | check
using Sums = std::map<Key, Sum>;

inline double information(double p) {
  p = std::clamp(p, 1e-4, 1 - 1e-4);
  return 1 + p * std::log2(p) + (1 - p) * std::log2(1 - p);
}

/// What one image taught: a probability of 65536 and its age.
inline void add(Sum& sum, std::size_t node, double p, double age) {
  constexpr double kEnough = 6;  // observations per image that count in full
  if (age == 0) return;
  const double share = p / 65536.0;
  sum.ones[node] += share * age;
  sum.total[node] += age;
  sum.score += std::min(age, kEnough) * information(share);
}

inline unsigned level_of(double p) {
  const double x = std::log(p / (1 - p)) * 256 / 72;
  return static_cast<unsigned>(std::clamp(std::lround(x) + 32, 0L, 63L));
}

inline unsigned age_of(double n) {
  constexpr double kMaxAge = 30;
  const double age = std::min(n, kMaxAge);
  unsigned best = 0;
  for (unsigned i = 0; i < codec::warm::kAges.size(); ++i) {
    if (codec::warm::kAges[i] <= age) best = i;
  }
  return best;
}

inline std::string record(Key key, const Sum& sum) {
  std::uint64_t bits = std::uint64_t{key} << 20;
  for (const std::size_t node : {0U, 1U}) {
    const double n = sum.total[node];
    const double p = (sum.ones[node] + 0.02) / (n + 0.04);
    bits |= std::uint64_t{level_of(p)} << (node == 0 ? 14 : 8);
    bits |= std::uint64_t{age_of(n)} << (node == 0 ? 4 : 0);
  }
  return to_text(static_cast<unsigned>(bits >> 24), 4) +
         to_text(static_cast<unsigned>(bits & 0xffffff), 4);
}

/// What a context must say more than to be among the `most` that say most.
template <std::size_t kContexts>
double least_score(const std::array<Sums, kContexts>& sums, std::size_t most) {
  std::vector<double> scores;
  for (const Sums& context : sums) {
    for (const auto& [key, sum] : context) scores.push_back(sum.score);
  }
  std::sort(scores.rbegin(), scores.rend());
  return scores.size() > most ? scores[most] : 0.0;
}

inline void write_text(std::FILE* out, const std::string& text) {
  print_text(out, text);
  std::fprintf(out, "    \"\",\n");
}

}  // namespace unstep::bench
