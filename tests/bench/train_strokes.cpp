// Makes src/codec/stroke_warm_start_table.cpp from drawings:
//
//     train_strokes OUT.cpp IMAGE...
//
// Traces the strokes of every image, lays cheap lines within a tolerance of 1
// along them and encodes all together from nothing: the payload is the table.
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "codec/stroke_warm_start.h"
#include "codec/warm_start.h"
#include "unstep/formats.h"
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

bool add_strokes(const char* file, std::vector<Path>& paths) {
  const auto bytes = read_file(file, std::uint64_t{1} << 30);
  if (!bytes) return false;
  auto reader = RasterReader::open(*bytes, {});
  if (!reader) return false;
  const auto page = reader->read(0);
  if (!page) return false;
  const auto strokes = trace_strokes(page->ink);
  if (!strokes) return false;
  StrokeOptions options;
  options.aim = LineAim::few_bytes;
  options.ink = &page->ink;
  const auto drawing = stroke_paths(
      *strokes, {page->ink.width(), page->ink.height(), YAxis::down}, options);
  if (!drawing) return false;
  paths.insert(paths.end(), drawing->paths.begin(), drawing->paths.end());
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: train_strokes OUT.cpp IMAGE...\n");
    return 2;
  }
  std::vector<Path> paths;
  for (int i = 2; i < argc; ++i) {
    if (!add_strokes(argv[i], paths)) {
      std::fprintf(stderr, "%s: cannot be traced\n", argv[i]);
      return 1;
    }
  }
  std::size_t elements = 0;
  for (const Path& path : paths) elements += path.elements.size();
  const auto block =
      codec::encode_strokes(paths, codec::stroke_warm::Table{}, {});
  if (!block) return 1;
  std::FILE* out = std::fopen(argv[1], "w");
  if (out == nullptr) return 1;
  std::fprintf(out,
               "// Made by tests/bench/train_strokes.sh; do not edit.\n"
               "// clang-format off\n"
               "#include \"codec/stroke_warm_start.h\"\n\n"
               "namespace unstep::codec::stroke_warm {\n\n"
               "const Table kTable = {%zu, %zu,\n",
               paths.size(), elements);
  const std::string text = to_text(block->payload);
  for (std::size_t i = 0; i < text.size(); i += 72) {
    std::fprintf(out, "    \"%s\"\n", text.substr(i, 72).c_str());
  }
  std::fprintf(out, "};\n\n}  // namespace unstep::codec::stroke_warm\n");
  return std::fclose(out) == 0 ? 0 : 1;
}
