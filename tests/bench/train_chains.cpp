// Makes src/codec/chain_weights.cpp from drawings:
//
//     train_chains OUT.cpp IMAGE...
//
// Codes the border pixels of every image's contours as coder 16 does, from the
// present weights, and takes the means of the weights at the end: of each node,
// over all of its vectors, by how often they learned. Without images it keeps
// the weights. train_path_coder.sh runs it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "borders.h"
#include "codec/chain_head_model.h"
#include "codec/chain_model.h"
#include "entropy/arithmetic_encoder.h"
#include "unstep/formats.h"
#include "unstep/trace.h"

namespace {

using namespace unstep;
using codec::ChainModel;

constexpr std::size_t kVectors = 8;  ///< ChainModel::kInitialWeights
constexpr double kOld = 2000;        ///< bits that count in full

struct Sums {
  std::array<std::array<double, ChainModel::kInputs>, kVectors> weights{};
  std::array<double, kVectors> bits{};
};

std::vector<Chain> borders_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
  Result<RasterReader> reader = RasterReader::open(bytes, {});
  if (!reader) return {};
  const Result<RasterPage> page = reader->read(0);
  std::vector<Chain> chains;
  if (!page) return chains;
  (void)trace_contours(page->ink, [&](const Chain& contour) {
    chains.push_back(bench::border_of(contour));
    return true;
  });
  return chains;
}

void learn(const std::vector<Chain>& chains, Sums& sums) {
  std::uint64_t steps = 0;
  for (const Chain& chain : chains) steps += chain.steps.size();
  ChainModel model(codec::ChainHeadModel::table_bits(steps));
  entropy::ArithmeticEncoder coder;
  for (const Chain& chain : chains) {
    model.begin({{chain.origin.x, -chain.origin.y},
                 chain.connectivity,
                 chain.closed,
                 chain.steps.size()});
    for (Step step : chain.steps) model.code(coder, step);
  }
  for (std::size_t set = 0; set < 3; ++set) {
    const auto ages = model.mixer().ages(set);
    for (std::size_t k = 0; k < ages.size(); ++k) {
      const double age = std::min<double>(ages[k], kOld);
      const auto weights = model.mixer().weights(set, k);
      for (std::size_t i = 0; i < weights.size(); ++i) {
        sums.weights[k % kVectors][i] += age * weights[i] / 4;
      }
      sums.bits[k % kVectors] += age;
    }
  }
}

bool write(const char* path, const Sums& sums) {
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) return false;
  std::fprintf(file,
               "#include \"codec/chain_model.h\"\n\n"
               "// Made by tests/bench/train_chains.cpp.\n"
               "namespace unstep::codec {\n\n"
               "// clang-format off\n"
               "const std::array<ChainModel::Weights, 8> "
               "ChainModel::kInitialWeights{{\n");
  for (std::size_t k = 0; k < kVectors; ++k) {
    for (std::size_t i = 0; i < ChainModel::kInputs; ++i) {
      const double old = ChainModel::kInitialWeights[k][i];
      const double mean =
          sums.bits[k] > 0 ? sums.weights[k][i] / sums.bits[k] : old;
      std::fprintf(file, "%s%ld%s",
                   i % 8 == 0 ? (i == 0 ? "    {" : "     ") : " ",
                   std::lround(mean),
                   i + 1 == ChainModel::kInputs ? "},\n"
                   : i % 8 == 7                 ? ",\n"
                                                : ",");
    }
  }
  std::fprintf(file,
               "}};\n// clang-format on\n\n"
               "}  // namespace unstep::codec\n");
  return std::fclose(file) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: train_chains OUT.cpp IMAGE...\n");
    return 2;
  }
  Sums sums;
  for (int i = 2; i < argc; ++i) learn(borders_of(argv[i]), sums);
  return write(argv[1], sums) ? 0 : 1;
}
