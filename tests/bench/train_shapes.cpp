// Makes src/codec/shape_warm_start_table.cpp from pages:
//
//     train_shapes OUT.cpp IMAGE...
//
// Codes every image that the default effort codes by shapes, from the present
// weights, and takes what the vectors of the mixers came to: their mean, and of
// each how it differs. Without images it writes equal weights. train_shapes.sh
// runs it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "codec/shape_coder.h"
#include "codec/shape_finder.h"
#include "codec/shape_matcher.h"
#include "codec/shape_models.h"
#include "codec/shape_warm_start.h"
#include "codec/warm_start.h"
#include "unstep/formats.h"

namespace {

using namespace unstep;
using codec::PixelMixer;

constexpr double kSharedVotes = 20;  // of what a vector shares with all others

/// The vectors of one mixer, numbered through its sets.
class Vectors {
 public:
  void learn(const PixelMixer::Mixer& mixer) {
    std::size_t number = 0;
    for (std::size_t s = 0; s < PixelMixer::kSets; ++s) {
      const auto ages = mixer.ages(s);
      for (std::size_t k = 0; k < ages.size(); ++k, ++number) {
        if (number == sums_.size()) sums_.emplace_back();
        const double votes = std::sqrt(ages[k]);
        for (Sum* sum : {&sums_[number], &all_}) {
          for (std::size_t i = 0; i < PixelMixer::kInputs; ++i) {
            sum->weights[i] += votes * mixer.weights(s, k)[i] / 4;
          }
          sum->votes += votes;
        }
      }
    }
  }

  void write(std::FILE* out, const char* name) const {
    std::fprintf(out, "const PixelMixer::Start %s = {\n    {", name);
    for (std::size_t i = 0; i < PixelMixer::kInputs; ++i) {
      std::fprintf(out, "%s%ld", i == 0 ? "" : ", ", std::lround(shared(i)));
    }
    std::fprintf(out, "},\n");
    std::string text;
    for (std::size_t number = 0; number < sums_.size(); ++number) {
      text += vector(number);
    }
    for (std::size_t i = 0; i < text.size(); i += 72) {
      std::fprintf(out, "    \"%s\"\n", text.substr(i, 72).c_str());
    }
    std::fprintf(out, "    \"\"};\n\n");
  }

 private:
  struct Sum {
    std::array<double, PixelMixer::kInputs> weights{};
    double votes = 0;
  };

  [[nodiscard]] double shared(std::size_t i) const {
    constexpr double kEven = 6144.0 / PixelMixer::kContexts;
    return all_.votes > 0 ? all_.weights[i] / all_.votes : kEven;
  }

  /// As the table holds it; nothing if it is as all others.
  [[nodiscard]] std::string vector(std::size_t number) const {
    const Sum& sum = sums_[number];
    std::string text;
    for (const std::size_t digit : {number >> 6, number & 63}) {
      text += codec::warm::to_char(static_cast<unsigned>(digit));
    }
    bool differs = false;
    for (std::size_t i = 0; i < PixelMixer::kInputs; ++i) {
      const double own = (sum.weights[i] + kSharedVotes * shared(i)) /
                         (sum.votes + kSharedVotes);
      const long steps = std::clamp(
          std::lround((own - shared(i)) / PixelMixer::kStartStep), -32L, 31L);
      differs = differs || steps != 0;
      text += codec::warm::to_char(static_cast<unsigned>(steps + 32));
    }
    return differs ? text : "";
  }

  std::vector<Sum> sums_;
  Sum all_;
};

struct Trainer {
  Vectors pixels;
  Vectors numbers;
};

bool learn_file(const char* path, Trainer& trainer) {
  Result<std::vector<std::uint8_t>> bytes =
      read_file(path, std::uint64_t{1} << 32);
  if (!bytes) return false;
  Result<RasterReader> reader = RasterReader::open(*std::move(bytes), {});
  if (!reader) return false;
  const Result<RasterPage> page = reader->read(0);
  if (!page) return false;
  const Bitmap& ink = page->ink;
  const Result<codec::EncodedBlock> block =
      codec::encode_ink(ink, 0, ink.height(), Effort::standard, {});
  if (!block) return false;
  if (block->name.coder != codec::kCoderShapes) return true;
  const std::vector<codec::PlacedShape> shapes =
      codec::find_shapes(ink, 0, ink.height(), codec::kShapesPay);
  return static_cast<bool>(
      codec::show_shape_models(ink, shapes,
                               [&](const codec::ShapePixels& pixels,
                                   const codec::MixedShapeSequence& numbers) {
                                 trainer.pixels.learn(pixels.model().mixer());
                                 trainer.numbers.learn(numbers.mixer());
                               }));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: train_shapes OUT.cpp [IMAGE...]\n");
    return 2;
  }
  Trainer trainer;
  for (int i = 2; i < argc; ++i) {
    if (!learn_file(argv[i], trainer)) {
      std::fprintf(stderr, "cannot read %s\n", argv[i]);
      return 3;
    }
  }
  std::FILE* out = std::fopen(argv[1], "w");
  if (out == nullptr) return 4;
  std::fprintf(out,
               "// Made by tests/bench/train_shapes.sh; do not edit.\n"
               "// clang-format off\n"
               "#include \"codec/shape_warm_start.h\"\n\n"
               "namespace unstep::codec::shape_warm {\n\n");
  trainer.pixels.write(out, "kPixels");
  trainer.numbers.write(out, "kNumbers");
  std::fprintf(out, "}  // namespace unstep::codec::shape_warm\n");
  return std::fclose(out) == 0 ? 0 : 4;
}
