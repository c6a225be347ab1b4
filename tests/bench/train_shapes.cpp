// Makes src/codec/shape_warm_start_table.cpp from pages:
//
//     train_shapes OUT.cpp IMAGE...
//
// Codes every image that the default effort codes by shapes, from the present
// weights, and takes what the vectors of the mixers came to: their mean, and of
// each how it differs. Without images it writes equal weights. train_shapes.sh
// runs it.
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "codec/shape_coder.h"
#include "codec/shape_finder.h"
#include "codec/shape_matcher.h"
#include "codec/shape_models.h"
#include "codec/shape_warm_start.h"
#include "train_text.h"

namespace {

using namespace unstep;
using codec::PixelMixer;

/// The vectors of one mixer, numbered through its sets.
class Vectors {
 public:
  void learn(const PixelMixer::Mixer& mixer) {
    std::size_t number = 0;
    for (std::size_t s = 0; s < PixelMixer::kSets; ++s) {
      const auto ages = mixer.ages(s);
      for (std::size_t k = 0; k < ages.size(); ++k, ++number) {
        if (number == sums_.size()) sums_.emplace_back();
        sums_[number].add(mixer.weights(s, k), ages[k]);
        all_.add(mixer.weights(s, k), ages[k]);
      }
    }
  }

  void write(std::FILE* out, const char* name) const {
    std::fprintf(out, "const PixelMixer::Start %s = {\n    {", name);
    for (std::size_t i = 0; i < PixelMixer::kInputs; ++i) {
      std::fprintf(out, "%s%ld", i == 0 ? "" : ", ",
                   all_.votes > 0 ? std::lround(all_.mean(i) / 4)
                                  : PixelMixer::even().shared[i]);
    }
    std::fprintf(out, "},\n");
    std::string text;
    for (std::size_t number = 0; number < sums_.size(); ++number) {
      text += bench::vector_text(number, sums_[number], all_);
    }
    bench::print_text(out, text);
    std::fprintf(out, "    \"\"};\n\n");
  }

 private:
  using Sum = bench::WeightSum<PixelMixer::kInputs>;

  std::vector<Sum> sums_;
  Sum all_;
};

struct Trainer {
  Vectors pixels;
  Vectors numbers;
};

bool learn_file(const char* path, Trainer& trainer) {
  const std::optional<Bitmap> page = bench::first_page(path);
  if (!page) return false;
  const Bitmap& ink = *page;
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
