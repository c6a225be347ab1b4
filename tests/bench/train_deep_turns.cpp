// Makes src/codec/deep_warm_start.cpp from small drawings:
//
//     train_deep_turns OUT.cpp [IMAGE...]
//
// As train_warm_start, which see, for the deep model of turns: without images
// it writes the empty table, from an empty one it makes records, from one with
// records it learns the weights of vectors anew. train_warm_start.sh runs all
// passes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "codec/contour_coder.h"
#include "codec/deep_turn_model.h"
#include "codec/deep_warm_start.h"
#include "train_records.h"
#include "train_text.h"

namespace {

using namespace unstep;
using codec::TrainedTurnModel;
using Table = codec::warm::DeepTable;
const Table& start = codec::warm::kDeepTurns;

constexpr std::size_t kMostRecords = 60000;
constexpr std::size_t kMostVectors = 700;
/// Weights of 20 fractional bits to 12.
constexpr double kOne = 256;

struct Trainer {
  using Weights = bench::WeightSum<Table::kInputs>;
  std::array<bench::Sums, Table::kContexts> sums;
  std::array<Weights, 2> all;    ///< of all vectors of a decision
  std::vector<Weights> vectors;  ///< of one each, through the sets

  void learn(const TrainedTurnModel& turns) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      turns.model().for_each_known(
          i, [&](bench::Key key, std::size_t node, double p, double age) {
            bench::add(sums[i][key], node, p + 0.5, age);
          });
    }
    std::size_t number = 0;
    for (std::size_t s = 0; s < TrainedTurnModel::kSets; ++s) {
      const auto ages = turns.model().mixer().ages(s);
      for (std::size_t k = 0; k < ages.size(); ++k, ++number) {
        if (number == vectors.size()) vectors.emplace_back();
        const auto weights = turns.model().mixer().weights(s, k);
        all[k % 2].add(weights, ages[k]);
        vectors[number].add(weights, ages[k]);
      }
    }
  }

  /// The empty table: nothing known, equal weights.
  void forget() {
    for (Weights& sum : all) {
      sum = {};
      for (std::size_t i = 0; i < 90; ++i) {
        sum.weights[i] = kOne * (i < 30 ? 173 : i < 60 ? 66 : 50);
      }
      sum.weights[90] = sum.weights[91] = kOne * 300;
      sum.votes = 1;
    }
    vectors.clear();
  }

  [[nodiscard]] std::string vector_texts() const;
  void write(std::FILE* out) const;
};

/// Those that learned most and differ.
std::string Trainer::vector_texts() const {
  std::vector<double> votes;
  for (const Weights& vector : vectors) votes.push_back(vector.votes);
  std::sort(votes.rbegin(), votes.rend());
  const double least = votes.size() > kMostVectors ? votes[kMostVectors] : 0;
  std::string text;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (vectors[i].votes <= least) continue;
    text += bench::vector_text(i, vectors[i], all[i % 2], Table::kNumber, kOne);
  }
  return text;
}

void Trainer::write(std::FILE* out) const {
  const bool keep = !start.records.empty();
  const double least = keep ? 0 : bench::least_score(sums, kMostRecords);
  std::string records(keep ? start.records : "");
  std::fprintf(out,
               "// Made by tests/bench/train_warm_start.sh; do not edit.\n"
               "// clang-format off\n"
               "#include \"codec/deep_warm_start.h\"\n\n"
               "namespace unstep::codec::warm {\n\n"
               "const DeepTable kDeepTurns = {\n    {{\n   ");
  for (std::size_t i = 0; i < sums.size(); ++i) {
    unsigned count = keep ? start.counts[i] : 0U;
    for (const auto& [key, sum] : sums[i]) {
      if (keep || sum.score <= least) continue;
      records += bench::record(key, sum);
      ++count;
    }
    std::fprintf(out, " %u,", count);
  }
  std::fprintf(out, "\n    }},\n");
  bench::write_text(out, records);
  bench::write_text(out, keep ? vector_texts() : "");
  std::fprintf(out, "    {{\n");
  for (const Weights& sum : all) {
    std::fprintf(out, "    {");
    for (std::size_t i = 0; i < Table::kInputs; ++i) {
      const double w = sum.votes > 0 ? sum.mean(i) / kOne : 0;
      std::fprintf(out, "%ld,%s", std::lround(std::clamp(w, -8191.0, 8191.0)),
                   i % 12 == 11 ? "\n     " : " ");
    }
    std::fprintf(out, "},\n");
  }
  std::fprintf(out, "    }}};\n\n}  // namespace unstep::codec::warm\n");
}

bool learn_file(const char* path, Trainer& trainer) {
  const std::optional<Bitmap> ink = bench::first_page(path);
  return ink && static_cast<bool>(codec::encode_and_show_deep(
                    *ink, [&](const TrainedTurnModel& turns) {
                      trainer.learn(turns);
                    }));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: train_deep_turns OUT.cpp [IMAGE...]\n");
    return 2;
  }
  Trainer trainer;
  if (argc == 2) trainer.forget();
  for (int i = 2; i < argc; ++i) {
    if (!learn_file(argv[i], trainer)) {
      std::fprintf(stderr, "cannot read %s\n", argv[i]);
      return 3;
    }
  }
  std::FILE* out = std::fopen(argv[1], "w");
  if (out == nullptr) return 4;
  trainer.write(out);
  return std::fclose(out) == 0 ? 0 : 4;
}
