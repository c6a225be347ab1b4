// Makes src/codec/centreline_warm_start_table.cpp or centreline_weights.cpp
// from drawings of thin lines:
//
//     train_centrelines records|weights OUT.cpp IMAGE...
//
// records: codes every image as coder 3 does, but cold, and takes the slots
// that say most in most images. weights: from the present records and weights,
// the means of the weights at the end: of each node, over all of its vectors,
// by how often they learned. train_centrelines.sh runs both.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "codec/centreline_coder.h"
#include "codec/centreline_model.h"
#include "codec/centreline_start_model.h"
#include "codec/centreline_warm_start.h"
#include "train_text.h"

namespace {

using namespace unstep;
using bench::to_text;
namespace centreline_warm = codec::centreline_warm;
using codec::CentrelineModel;
using codec::CentrelineStartModel;

constexpr double kOld = 2000;  ///< bits that count in full

/// Of kCount vectors, sums of weights by bits, and the bits.
template <std::size_t kCount, std::size_t kInputs>
struct Sums {
  std::array<std::array<double, kInputs>, kCount> weights{};
  std::array<double, kCount> bits{};

  void add(std::size_t vector, std::span<const std::int16_t> learned,
           std::uint16_t age) {
    const double weight = std::min<double>(age, kOld);
    for (std::size_t i = 0; i < kInputs; ++i) {
      weights[vector][i] += weight * learned[i] / 4;
    }
    bits[vector] += weight;
  }
};

/// What the slots of a context and hash came to.
class Slots {
 public:
  void add(const CentrelineModel::Slots& slots) {
    slots.for_each([&](std::size_t context, std::uint16_t index,
                       std::uint16_t check, const auto& p, const auto& n) {
      Sum& sum = sums_[{context, index, check}];
      ++sum.images;
      for (std::size_t node = 0; node < p.size(); ++node) {
        if (n[node] == 0) continue;
        const double share = p[node] / 65536.0;
        const double count = std::min<double>(n[node], kCap);
        sum.ones[node] += share * count;
        sum.total[node] += count;
        sum.score += std::min(count, kEnough) * (information(share) + 0.02);
      }
    });
  }

  [[nodiscard]] bool write(const char* path) const;

 private:
  static constexpr std::size_t kMost = 20000;  ///< records
  static constexpr double kFewest = 3;         ///< observations worth a counter
  static constexpr double kCap = 60;  ///< observations of one image that count
  static constexpr double kEnough = 6;  ///< and for its importance

  struct Sum {
    std::array<double, CentrelineModel::kNodes> ones{};
    std::array<double, CentrelineModel::kNodes> total{};
    double score = 0;
    int images = 0;
  };
  using Key = std::tuple<std::size_t, std::uint16_t, std::uint16_t>;

  static double information(double p) {
    p = std::clamp(p, 1e-4, 1 - 1e-4);
    return 1 + p * std::log2(p) + (1 - p) * std::log2(1 - p);
  }
  [[nodiscard]] double least_score() const {
    std::vector<double> scores;
    for (const auto& [key, sum] : sums_) {
      if (sum.images > 1) scores.push_back(sum.score);
    }
    std::sort(scores.rbegin(), scores.rend());
    return scores.size() > kMost ? scores[kMost] : 0.0;
  }
  static std::string record(std::uint32_t passed, std::uint16_t check,
                            const Sum& sum);

  std::map<Key, Sum> sums_;
};

std::string Slots::record(std::uint32_t passed, std::uint16_t check,
                          const Sum& sum) {
  std::vector<std::size_t> nodes(sum.total.size());
  std::iota(nodes.begin(), nodes.end(), 0U);
  std::sort(nodes.begin(), nodes.end(), [&](std::size_t a, std::size_t b) {
    return sum.total[a] > sum.total[b];
  });
  nodes.resize(centreline_warm::Record::kMostCounters);
  while (nodes.size() > 1 && sum.total[nodes.back()] < kFewest)
    nodes.pop_back();
  std::string text =
      passed < 63 ? to_text(passed, 1) : to_text(63, 1) + to_text(passed, 3);
  text += to_text(
      unsigned{check} << 2 | static_cast<unsigned>(nodes.size() - 1), 3);
  for (const std::size_t node : nodes) {
    unsigned age = 0;
    for (unsigned i = 0; i < centreline_warm::kAges.size(); ++i) {
      if (centreline_warm::kAges[i] <= sum.total[node]) age = i;
    }
    const double p = (sum.ones[node] + 0.02) / (sum.total[node] + 0.04);
    const long level = std::lround(std::log(p / (1 - p)) * 256 / 72) + 32;
    text += to_text(static_cast<unsigned>(node) << 3 | age, 1) +
            to_text(static_cast<unsigned>(std::clamp(level, 0L, 63L)), 1);
  }
  return text;
}

bool Slots::write(const char* path) const {
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) return false;
  std::fprintf(file,
               "// Made by tests/bench/train_centrelines.sh; do not edit.\n"
               "// clang-format off\n"
               "#include \"codec/centreline_warm_start.h\"\n\n"
               "namespace unstep::codec::centreline_warm {\n\n"
               "const Table kTable = {\n    {{");
  const double least = least_score();
  std::array<unsigned, centreline_warm::kContexts> counts{};
  std::array<std::uint32_t, centreline_warm::kContexts> next{};
  std::string text;
  for (const auto& [key, sum] : sums_) {
    const auto& [context, index, check] = key;
    // Of two checks at one index the first stays.
    if (sum.images < 2 || sum.score <= least || index < next[context]) continue;
    text += record(index - next[context], check, sum);
    next[context] = index + 1U;
    ++counts[context];
  }
  for (const unsigned count : counts) std::fprintf(file, "%u, ", count);
  std::fprintf(file, "}},\n");
  bench::print_text(file, text);
  std::fprintf(file,
               "    };\n\n}  // namespace unstep::codec::centreline_warm\n");
  return std::fclose(file) == 0;
}

struct Learned {
  Slots slots;
  Sums<2 * CentrelineModel::kNodes, CentrelineModel::kInputs> lines;
  Sums<3, CentrelineStartModel::Words::kInputs> starts;
};

void learn(const char* file, bool records, Learned& learned) {
  const std::optional<Bitmap> ink = bench::first_page(file);
  if (!ink) return;
  (void)codec::show_centreline_models(
      *ink, records,
      [&](const CentrelineModel& lines, const CentrelineStartModel& starts) {
        if (records) return learned.slots.add(lines.slots());
        for (std::size_t set = 0; set < CentrelineModel::kSets; ++set) {
          const auto ages = lines.mixer().ages(set);
          for (std::size_t k = 0; k < ages.size(); ++k) {
            const std::size_t beside = k < ages.size() / 2 ? 0 : 1;
            learned.lines.add(
                beside * CentrelineModel::kNodes + k % CentrelineModel::kNodes,
                lines.mixer().weights(set, k), ages[k]);
          }
        }
        const std::array mixers{&starts.words().mixer(),
                                &starts.spans().mixer(),
                                &starts.pixels().mixer()};
        for (std::size_t which = 0; which < 3; ++which) {
          for (std::size_t set = 0; set < 3; ++set) {
            const auto ages = mixers[which]->ages(set);
            for (std::size_t k = 0; k < ages.size(); ++k) {
              learned.starts.add(which, mixers[which]->weights(set, k),
                                 ages[k]);
            }
          }
        }
      });
}

template <std::size_t kCount, std::size_t kInputs>
void write_vectors(
    std::FILE* file, const Sums<kCount, kInputs>& sums,
    const std::array<std::array<std::int16_t, kInputs>, kCount>& old) {
  for (std::size_t k = 0; k < kCount; ++k) {
    for (std::size_t i = 0; i < kInputs; ++i) {
      const double mean = sums.bits[k] > 0 ? sums.weights[k][i] / sums.bits[k]
                                           : static_cast<double>(old[k][i]);
      std::fprintf(file, "%s%ld%s",
                   i % 8 == 0 ? (i == 0 ? "    {" : "     ") : " ",
                   std::lround(mean),
                   i + 1 == kInputs ? "},\n"
                   : i % 8 == 7     ? ",\n"
                                    : ",");
    }
  }
}

bool write(const char* path, const Learned& learned) {
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) return false;
  std::fprintf(file,
               "#include \"codec/centreline_model.h\"\n"
               "#include \"codec/centreline_start_model.h\"\n\n"
               "// Made by tests/bench/train_centrelines.cpp.\n"
               "namespace unstep::codec {\n\n"
               "// clang-format off\n"
               "const std::array<CentrelineModel::Weights, 16>\n"
               "    CentrelineModel::kInitialWeights{{\n");
  write_vectors(file, learned.lines, CentrelineModel::kInitialWeights);
  std::fprintf(file,
               "}};\n"
               "const LineStartWeights kLineStartWeights{{\n");
  write_vectors(file, learned.starts, codec::kLineStartWeights);
  std::fprintf(file,
               "}};\n// clang-format on\n\n"
               "}  // namespace unstep::codec\n");
  return std::fclose(file) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view kind = argc < 4 ? "" : argv[1];
  const bool records = kind == "records";
  if (!records && kind != "weights") {
    std::fprintf(stderr,
                 "usage: train_centrelines records|weights OUT.cpp IMAGE...\n");
    return 2;
  }
  Learned learned;
  for (int i = 3; i < argc; ++i) learn(argv[i], records, learned);
  return (records ? learned.slots.write(argv[2]) : write(argv[2], learned)) ? 0
                                                                            : 1;
}
