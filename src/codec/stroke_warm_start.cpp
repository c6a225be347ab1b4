#include "codec/stroke_warm_start.h"

#include <cstdint>
#include <vector>

#include "codec/stroke_decoder_side.h"
#include "codec/warm_start.h"

namespace unstep::codec::stroke_warm {
namespace {

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() * 3 / 4);
  unsigned held = 0;
  int bits = 0;
  for (const char c : text) {
    held = (held << 6 | warm::from_char(c)) & 0xffffU;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<std::uint8_t>(held >> bits));
  }
  return bytes;
}

}  // namespace

void learn(Table table, StrokeModels& models) {
  for (const Lesson& lesson : table) {
    const std::vector<std::uint8_t> payload = bytes_of(lesson.payload);
    StrokeDecoderSide side(payload);
    // The table is right; golden files prove it.
    (void)StrokeScan<StrokeDecoderSide>(side, models, lesson.paths,
                                        lesson.elements)
        .run({});
  }
}

}  // namespace unstep::codec::stroke_warm
