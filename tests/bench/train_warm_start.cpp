// Makes src/codec/warm_start_small.cpp, _large.cpp or _clean.cpp from drawings:
//
//     train_warm_start small|large|clean OUT.cpp IMAGE...
//
// Without images it writes the empty table.
//
// Every image is encoded from the present warm start. What its models know at
// the end is added up over the images. If the present table has no records,
// the contexts that most images use and that say most become records; if it
// has, they are kept and only the mixer weights are learned anew on top of
// them, those of each vector but for `large`. train_warm_start.sh runs all
// passes from an empty table.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "codec/contour_coder.h"
#include "codec/start_model.h"
#include "codec/turn_model.h"
#include "codec/warm_start.h"
#include "entropy/logistic.h"
#include "train_records.h"
#include "train_text.h"

namespace {

using namespace unstep;
using bench::add;
using bench::Key;
using bench::Sum;
using bench::Sums;
using codec::StartModel;
using codec::TurnModel;
namespace warm = codec::warm;

/// A table: how many records, of eight characters, and whether vectors.
struct Part {
  std::string_view name;
  const char* variable;
  const warm::Table& table;
  std::size_t most;
  bool vectors;
};
const std::array<Part, 3> kParts{{
    {"small", "kSmall", warm::kSmall, 24000, true},
    {"large", "kLarge", warm::kLarge, 6900, false},
    {"clean", "kClean", warm::kClean, 24000, true},
}};
struct Trainer {
  explicit Trainer(const Part& wanted) : part(wanted) {}

  const Part& part;
  std::array<Sums, warm::kContexts> sums;
  std::array<std::array<double, 2>, warm::kFlags> open{};
  using TurnWeights = bench::WeightSum<32>;
  std::array<TurnWeights, 2> turn_weights;  ///< of all vectors of a node
  std::vector<TurnWeights> vectors;         ///< of one each, through the sets
  std::array<double, 8> start_weights{};
  double start_votes = 0;
  bool forgotten = false;

  [[nodiscard]] const warm::Table& start() const { return part.table; }

  void learn(const TurnModel& turns, const StartModel& starts) {
    for (std::size_t i = 0; i < warm::kTurnContexts; ++i) {
      const auto slots = turns.slots().slots(i);
      for (std::size_t k = 0; k < slots.size(); ++k) {
        const auto& slot = slots[k];
        if (slot.n[0] == 0 && slot.n[1] == 0) continue;
        const int shift = std::countr_zero(slots.size()) - 16;
        Sum& sum =
            sums[i][static_cast<Key>(k >> shift << 12 | (slot.check - 1U))];
        for (const std::size_t node : {0U, 1U}) {
          add(sum, node, slot.p[node], slot.n[node]);
        }
      }
    }
    for (std::size_t i = 0; i < warm::kStartContexts; ++i) {
      const auto counters = starts.near(i);
      for (std::size_t k = 0; k < counters.size(); ++k) {
        if (counters[k].n == 0) continue;
        const int shift = 16 - StartModel::near_bits(i);
        add(sums[warm::kTurnContexts + i][static_cast<Key>(k << shift << 12)],
            0, counters[k].p, counters[k].n);
      }
    }
    for (std::size_t i = 0; i < warm::kFlags; ++i) {
      const auto& counter = starts.flags()[i];
      open[i][0] += counter.p / 65536.0 * counter.n;
      open[i][1] += counter.n;
    }
    learn_turn_weights(turns);
    const auto ages = starts.mixer().ages(0);
    for (std::size_t k = 0; k < ages.size(); ++k) {
      const double votes = std::sqrt(ages[k]);
      for (std::size_t i = 0; i < 8; ++i) {
        start_weights[i] += votes * starts.mixer().weights(0, k)[i];
      }
      start_votes += votes;
    }
  }

  void learn_turn_weights(const TurnModel& turns) {
    std::size_t number = 0;
    for (std::size_t s = 0; s < TurnModel::kSets; ++s) {
      const auto ages = turns.mixer().ages(s);
      for (std::size_t k = 0; k < ages.size(); ++k, ++number) {
        if (number == vectors.size()) vectors.emplace_back();
        const auto weights = turns.mixer().weights(s, k);
        turn_weights[k % 2].add(weights, ages[k]);
        vectors[number].add(weights, ages[k]);
      }
    }
  }

  void forget();
  void write(std::FILE* out) const;
};

template <std::size_t kSize>
void write_weights(std::FILE* out, const std::array<double, kSize>& sums,
                   double votes) {
  std::fprintf(out, "    {");
  for (std::size_t i = 0; i < kSize; ++i) {
    const double w = votes > 0 ? sums[i] / votes / 4 : 0;
    std::fprintf(out, "%s%ld",
                 i == 0        ? ""
                 : i % 10 == 0 ? ",\n     "
                               : ", ",
                 std::lround(std::clamp(w, -8191.0, 8191.0)));
  }
  std::fprintf(out, "},\n");
}

/// The empty table: nothing known, equal weights.
void Trainer::forget() {
  forgotten = true;
  for (auto& counter : open) counter = {0, 0};
  for (TurnWeights& sum : turn_weights) {
    for (std::size_t i = 0; i < 32; ++i)
      sum.weights[i] = i % 16 >= warm::kTurnContexts ? 0 : 410 * 4;
    sum.votes = 1;
  }
  for (std::size_t i = 0; i < 3; ++i) start_weights[i] = 1638 * 4;
  start_votes = 1;
}

void Trainer::write(std::FILE* out) const {
  const bool keep = !start().records.empty() && !forgotten;
  const double least = keep ? 0 : bench::least_score(sums, part.most);
  std::string records(keep ? start().records : "");
  std::fprintf(out,
               "// Made by tests/bench/train_warm_start.sh; do not edit.\n"
               "// clang-format off\n"
               "#include \"codec/warm_start.h\"\n\n"
               "namespace unstep::codec::warm {\n\n"
               "const Table %s = {\n    {{\n   ",
               part.variable);
  for (std::size_t i = 0; i < warm::kContexts; ++i) {
    unsigned count = keep ? start().counts[i] : 0U;
    for (const auto& [key, sum] : sums[i]) {
      if (keep || sum.score <= least) continue;
      records += bench::record(key, sum);
      ++count;
    }
    std::fprintf(out, " %u,", count);
  }
  std::fprintf(out, "\n    }},\n");
  bench::write_text(out, records);
  std::string own;
  for (std::size_t i = 0; part.vectors && keep && i < vectors.size(); ++i) {
    own += bench::vector_text(i, vectors[i], turn_weights[i % 2]);
  }
  bench::write_text(out, own);
  std::fprintf(out, "    {{\n");
  for (const std::size_t node : {0U, 1U}) {
    write_weights(out, turn_weights[node].weights, turn_weights[node].votes);
  }
  std::fprintf(out, "    }},\n    {{\n");
  write_weights(out, start_weights, start_votes);
  std::fprintf(out, "    }},\n    {{\n");
  for (std::size_t i = 0; i < warm::kFlags; ++i) {
    const double n = open[i][1];
    const double p = (open[i][0] + 0.02) / (n + 2);
    const long value = keep ? start().flags[i][0] : std::lround(p * 65536);
    const long age =
        keep ? start().flags[i][1] : std::lround(std::min(n, 20.0));
    std::fprintf(out, "    {%ld, %ld},%s", std::clamp(value, 2L, 60000L), age,
                 i % 4 == 3 ? "\n" : "");
  }
  std::fprintf(out, "    }}};\n\n}  // namespace unstep::codec::warm\n");
}

/// A page that the standard effort codes by contours alone, all views.
bool is_clean(const Bitmap& ink) {
  if (ink.pixels() < 2'000'000) return false;
  const Result<codec::EncodedBlock> block =
      codec::encode_ink(ink, 0, ink.height(), Effort::standard, {});
  return block && block->name.coder == codec::kCoderContours &&
         block->name.revision == codec::kContourStandard;
}

bool learn_file(const char* path, Trainer& trainer) {
  const std::optional<Bitmap> ink = bench::first_page(path);
  if (!ink) return false;
  if (&trainer.start() == &warm::kClean && !is_clean(*ink)) return true;
  return static_cast<bool>(codec::encode_and_show(
      *ink, trainer.start(),
      [&](const TurnModel& turns, const StartModel& starts) {
        trainer.learn(turns, starts);
      }));
}

}  // namespace

int main(int argc, char** argv) {
  const auto part = std::find_if(
      kParts.begin(), kParts.end(),
      [&](const Part& p) { return argc >= 3 && p.name == argv[1]; });
  if (part == kParts.end()) {
    std::fprintf(stderr,
                 "usage: train_warm_start small|large|clean OUT.cpp "
                 "[IMAGE...]\n");
    return 2;
  }
  Trainer trainer(*part);
  if (argc == 3) trainer.forget();
  for (int i = 3; i < argc; ++i) {
    if (!learn_file(argv[i], trainer)) {
      std::fprintf(stderr, "cannot read %s\n", argv[i]);
      return 3;
    }
  }
  std::FILE* out = std::fopen(argv[2], "w");
  if (out == nullptr) return 4;
  trainer.write(out);
  return std::fclose(out) == 0 ? 0 : 4;
}
