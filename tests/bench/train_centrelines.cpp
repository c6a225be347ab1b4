// Makes src/codec/centreline_weights.cpp from drawings of thin lines:
//
//     train_centrelines OUT.cpp IMAGE...
//
// Codes every image as coder 3 does, from the present weights, and takes the
// means of the weights at the end: of each node, over all of its vectors, by
// how often they learned. Without images it keeps the weights.
// train_centrelines.sh runs it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

#include "codec/centreline_coder.h"
#include "codec/centreline_model.h"
#include "codec/centreline_start_model.h"
#include "unstep/formats.h"

namespace {

using namespace unstep;
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

struct Learned {
  Sums<2 * CentrelineModel::kNodes, CentrelineModel::kInputs> lines;
  Sums<3, CentrelineStartModel::Words::kInputs> starts;
};

void learn(const char* file, Learned& learned) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
  Result<RasterReader> reader = RasterReader::open(bytes, {});
  if (!reader) return;
  const Result<RasterPage> page = reader->read(0);
  if (!page) return;
  (void)codec::show_centreline_models(
      page->ink,
      [&](const CentrelineModel& lines, const CentrelineStartModel& starts) {
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
  if (argc < 2) {
    std::fprintf(stderr, "usage: train_centrelines OUT.cpp IMAGE...\n");
    return 2;
  }
  Learned learned;
  for (int i = 2; i < argc; ++i) learn(argv[i], learned);
  return write(argv[1], learned) ? 0 : 1;
}
