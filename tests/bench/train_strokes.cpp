// Makes src/codec/stroke_warm_start_table.cpp from drawings:
//
//     train_strokes OUT.cpp IMAGE...
//
// Traces the strokes of every image, lays cheap lines within a tolerance of 1
// along them and encodes each after those before: the payloads are the table.
#include <cstdint>
#include <cstdio>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "codec/stroke_warm_start.h"
#include "codec/warm_start.h"
#include "train_text.h"
#include "unstep/trace.h"

namespace {

using namespace unstep;

/// Six bits to a character, high ones first, the last filled with zeros.
std::string to_text(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  unsigned held = 0;
  int bits = 0;
  for (const std::uint8_t byte : bytes) {
    held = (held & 0x3fU) << 8 | byte;
    for (bits += 8; bits >= 6; bits -= 6) {
      text += codec::warm::to_char(held >> (bits - 6) & 63);
    }
  }
  if (bits > 0) text += codec::warm::to_char(held << (6 - bits) & 63);
  return text;
}

std::vector<Path> strokes_of(const char* file) {
  const std::optional<Bitmap> ink = bench::first_page(file);
  if (!ink) return {};
  const auto strokes = trace_strokes(*ink);
  if (!strokes) return {};
  StrokeOptions options;
  options.aim = LineAim::few_bytes;
  options.ink = &*ink;
  const auto drawing = stroke_paths(
      *strokes, {ink->width(), ink->height(), YAxis::down}, options);
  return drawing ? drawing->paths : std::vector<Path>{};
}

/// What a drawing teaches after others.
class Course {
 public:
  bool add(const std::vector<Path>& paths) {
    std::size_t elements = 0;
    for (const Path& path : paths) elements += path.elements.size();
    const auto block = codec::encode_strokes(paths, lessons_, {});
    if (!block || paths.empty()) return false;
    texts_.push_back(to_text(block->payload));
    lessons_.push_back({static_cast<std::uint32_t>(paths.size()),
                        static_cast<std::uint32_t>(elements), texts_.back()});
    return true;
  }

  void write(std::FILE* out) const {
    std::fprintf(out,
                 "// Made by tests/bench/train_strokes.sh; do not edit.\n"
                 "// clang-format off\n"
                 "#include \"codec/stroke_warm_start.h\"\n\n"
                 "namespace unstep::codec::stroke_warm {\n"
                 "namespace {\n\n"
                 "constexpr Lesson kLessons[] = {\n");
    for (const codec::stroke_warm::Lesson& lesson : lessons_) {
      std::fprintf(out, "    {%u, %u,\n", lesson.paths, lesson.elements);
      bench::print_text(out, std::string(lesson.payload));
      std::fprintf(out, "    },\n");
    }
    std::fprintf(out,
                 "};\n\n}  // namespace\n\n"
                 "const Table kTable{kLessons};\n\n"
                 "}  // namespace unstep::codec::stroke_warm\n");
  }

 private:
  std::deque<std::string> texts_;
  std::vector<codec::stroke_warm::Lesson> lessons_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: train_strokes OUT.cpp IMAGE...\n");
    return 2;
  }
  Course course;
  for (int i = 2; i < argc; ++i) {
    if (!course.add(strokes_of(argv[i]))) {
      std::fprintf(stderr, "%s: cannot be traced\n", argv[i]);
      return 1;
    }
  }
  std::FILE* out = std::fopen(argv[1], "w");
  if (out == nullptr) return 1;
  course.write(out);
  return std::fclose(out) == 0 ? 0 : 1;
}
