// Makes src/codec/path_warm_start_table.cpp from drawings:
//
//     train_path_coder OUT.cpp IMAGE...
//
// Lays cheap lines at tolerances of 1 and 2 over every image and codes them.
// First cold: the counters that tell most in most drawings become the table.
// Then from that table: the weights of the mixers go from drawing to drawing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "codec/path_scan.h"
#include "train_drawings.h"
#include "train_text.h"

namespace {

using namespace unstep;
using bench::to_text;
using codec::VectorModel;
namespace path_warm = codec::path_warm;
namespace warm = codec::warm;

constexpr std::size_t kMaxCounters = 190'000;  // 405,000 characters
constexpr std::size_t kMaxVectors = 1000;      // 78,000 characters
constexpr double kMaxAge = 30;
constexpr double kCap = 20;     // observations of one drawing that count
constexpr double kEnough = 12;  // and for its importance

/// Takes decisions as they are and keeps nothing.
struct NullCoder {
  static bool code(bool bit, int /*p1*/) { return bit; }
};

/// What PathScan asks of an encoder (path_scan.h); paths begin where they are
/// told, as cheap lines do.
struct Side {
  std::span<const Path> paths;
  NullCoder null;

  NullCoder& coder() { return null; }
  [[nodiscard]] codec::PathFrame frame() const {
    codec::PathFrame frame;
    for (const Path& path : paths) frame.starts.add(path.origin.x);
    return frame;
  }
  [[nodiscard]] codec::PathHead head(std::uint64_t i) const {
    const Path& path = paths[static_cast<std::size_t>(i)];
    return {path.origin, path.closed, path.width, path.elements.size(), 0};
  }
  [[nodiscard]] Path::Element element(std::uint64_t i, std::uint64_t k) const {
    return paths[static_cast<std::size_t>(i)]
        .elements[static_cast<std::size_t>(k)];
  }
  void begin(const codec::PathHead& /*head*/) {}
  void push(const Path::Element& /*element*/) {}
  void end() {}
  [[nodiscard]] static bool damaged() { return false; }
};

/// Codes a drawing; `prepare` and `learn` see the models before and after.
template <class Prepare, class Learn>
void code(const Drawing& drawing, Prepare prepare, Learn learn) {
  std::uint64_t elements = 0;
  for (const Path& path : drawing.paths) elements += path.elements.size();
  Side side{drawing.paths, {}};
  const auto scan = std::make_unique<codec::PathScan<Side>>(
      side, drawing.paths.size(), elements, path_warm::Table{});
  prepare(scan->model().vectors());
  if (scan->run({})) learn(scan->model().vectors());
}

struct Sum {
  double ones = 0;
  double total = 0;
  double score = 0;
  int drawings = 0;
};

double information(double p) {
  p = std::clamp(p, 1e-4, 1 - 1e-4);
  return 1 + p * std::log2(p) + (1 - p) * std::log2(1 - p);
}

class Counters {
 public:
  void learn(VectorModel& model) {
    for (std::size_t c = 0; c < sums_.size(); ++c) {
      auto& decisions = model.decisions()[c / VectorModel::kContexts];
      for (std::uint32_t k = 0; k < 1U << codec::kPathTableBits; ++k) {
        const auto& counter = decisions.counter(c % VectorModel::kContexts, k);
        if (counter.n == 0) continue;
        const double p = counter.p / 65536.0;
        const double n = std::min<double>(counter.n, kCap);
        Sum& sum = sums_[c][k];
        sum.ones += p * n;
        sum.total += n;
        sum.score += std::min(n, kEnough) * (information(p) + 0.02);
        ++sum.drawings;
      }
    }
  }

  [[nodiscard]] std::string text() const {
    std::vector<double> scores;
    for (const auto& context : sums_) {
      for (const auto& [index, sum] : context) {
        if (sum.drawings > 1) scores.push_back(sum.score);
      }
    }
    std::sort(scores.rbegin(), scores.rend());
    const double least =
        scores.size() > kMaxCounters ? scores[kMaxCounters] : 0.0;
    std::string text;
    for (const auto& context : sums_) {
      std::uint32_t next = 0;
      for (const auto& [index, sum] : context) {
        if (sum.drawings < 2 || sum.score <= least) continue;
        text += passed(index - next) + entry(sum);
        next = index + 1;
      }
      text += to_text(path_warm::kManyPassed, 1) + to_text(0, 1);
    }
    return text;
  }

 private:
  /// The characters for so many indices without a counter.
  static std::string passed(std::uint32_t count) {
    std::string text;
    while (count >= 64) {
      const std::uint32_t k = std::min(count / 64, 63U);
      text += to_text(path_warm::kManyPassed, 1) + to_text(k, 1);
      count -= 64 * k;
    }
    if (count >= path_warm::kSomePassed) {
      text += to_text(path_warm::kSomePassed, 1);
      count -= path_warm::kSomePassed;
    }
    return text + to_text(count, 1);
  }

  static std::string entry(const Sum& sum) {
    const auto& levels = path_warm::kLevels;
    const auto& ages = path_warm::kCounterAges;
    const double p =
        std::clamp((sum.ones + 0.4) / (sum.total + 0.8), 0.0005, 0.9995);
    const double x = std::log(p / (1 - p)) * 256;
    const auto level = static_cast<unsigned>(
        std::min_element(
            levels.begin(), levels.end(),
            [&](int a, int b) { return std::abs(a - x) < std::abs(b - x); }) -
        levels.begin());
    const double age = std::min(2 * sum.total / sum.drawings, kMaxAge);
    unsigned best = 0;
    for (unsigned i = 1; i < ages.size(); ++i) {
      if (std::sqrt(double{1} * ages[i] * ages[i - 1]) <= age) best = i;
    }
    return to_text(level * static_cast<unsigned>(ages.size()) + best, 1);
  }

  std::array<std::map<std::uint32_t, Sum>, 3 * VectorModel::kContexts> sums_;
};

/// The mixers of the three parts, handed from drawing to drawing.
class Weights {
 public:
  void prepare(VectorModel& model) const {
    for (std::size_t part = 0; part < mixers_.size(); ++part) {
      model.decisions()[part].mixer() = mixers_[part];
    }
  }
  void learn(VectorModel& model) {
    mixers_.clear();
    for (auto& decisions : model.decisions()) {
      mixers_.push_back(decisions.mixer());
    }
  }

  [[nodiscard]] std::string text() const {
    struct Used {
      unsigned age, part, set, vector;
    };
    std::vector<Used> used;
    std::string text;
    for (unsigned part = 0; part < mixers_.size(); ++part) {
      std::vector<double> mean(path_warm::kWeights);
      double votes = 0;
      for (unsigned set = 0; set < VectorModel::kSets; ++set) {
        const auto ages = mixers_[part].ages(set);
        for (unsigned k = 0; k < ages.size(); ++k) {
          if (ages[k] > 0) used.push_back({ages[k], part, set, k});
          votes += ages[k];
          for (std::size_t i = 0; i < mean.size(); ++i) {
            mean[i] += mixers_[part].weights(set, k)[i] * double{1} * ages[k];
          }
        }
      }
      for (double& m : mean) m /= std::max(votes, 1.0);
      text += vector(part, 0, path_warm::kAllVectors, mean);
    }
    std::sort(used.begin(), used.end(),
              [](const Used& a, const Used& b) { return a.age > b.age; });
    used.resize(std::min(used.size(), kMaxVectors));
    for (const Used& u : used) {
      const auto w = mixers_[u.part].weights(u.set, u.vector);
      text += vector(u.part, u.set, u.vector, {w.begin(), w.end()});
    }
    return text;
  }

 private:
  static std::string vector(unsigned part, unsigned set, unsigned k,
                            const std::vector<double>& weights) {
    std::string text = to_text(part, 1) + to_text(set, 1) + to_text(k, 2);
    for (std::size_t i = 0; i < path_warm::kWeights; ++i) {
      const long level =
          std::lround(weights[i] / (1 << path_warm::kWeightShift)) +
          path_warm::kWeightZero;
      text += to_text(static_cast<unsigned>(std::clamp(level, 0L, 4095L)), 2);
    }
    return text;
  }

  std::vector<
      std::decay_t<decltype(std::declval<VectorModel::Decisions&>().mixer())>>
      mixers_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: train_path_coder OUT.cpp IMAGE...\n");
    return 2;
  }
  // Images alternate in an order that is no order of theirs.
  std::vector<Drawing> drawings;
  const int images = argc - 2;
  for (int i = 0; i < images; ++i) {
    const int k = static_cast<int>(std::int64_t{i} * 7919 % images);
    for (const std::uint32_t tolerance : {1U, 2U}) {
      for (Drawing& lines : bench::cheap_drawings(
               argv[2 + k], {{tolerance, 1}, Effort::standard, false})) {
        drawings.push_back(std::move(lines));
      }
    }
  }
  Counters counters;
  for (const Drawing& drawing : drawings) {
    code(
        drawing, [](VectorModel&) {},
        [&](VectorModel& model) { counters.learn(model); });
  }
  const std::string records = counters.text();
  Weights weights;
  bool known = false;
  for (int round = 0; round < 2; ++round) {
    for (const Drawing& drawing : drawings) {
      code(
          drawing,
          [&](VectorModel& model) {
            path_warm::apply({records, ""}, model);
            if (known) weights.prepare(model);
          },
          [&](VectorModel& model) { weights.learn(model); });
      known = true;
    }
  }
  std::FILE* out = std::fopen(argv[1], "w");
  if (out == nullptr) return 1;
  std::fprintf(out,
               "// Made by tests/bench/train_path_coder.sh; do not edit.\n"
               "// clang-format off\n"
               "#include \"codec/path_warm_start.h\"\n\n"
               "namespace unstep::codec::path_warm {\n\n"
               "const Table kTable = {\n");
  bench::print_text(out, records);
  std::fprintf(out, "    ,\n");
  bench::print_text(out, weights.text());
  std::fprintf(out, "};\n\n}  // namespace unstep::codec::path_warm\n");
  return std::fclose(out) == 0 ? 0 : 1;
}
