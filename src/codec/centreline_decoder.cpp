#include <algorithm>
#include <string>
#include <utility>

#include "codec/centreline_coder.h"
#include "codec/centreline_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {

std::uint64_t centreline_memory(std::uint8_t revision, std::int32_t width,
                                std::int32_t rows) {
  const int bits = centreline_table_bits(revision, width, rows);
  const std::uint64_t models =
      revision == kCentrelinesDeep
          ? DeepCentrelineModel::memory(bits) +
                DeepLineStartModel::memory(width)
          : CentrelineModel::memory(bits) + CentrelineStartModel::memory(width);
  return PixelPlanes::memory(width, rows) + VertexRulers::memory(width, rows) +
         models + sizeof(Point) * 2 * kMostWaiting;
}

namespace {

/// `Sink` takes each row of pixels, word by word, as it is complete.
template <class Sink>
class DecoderSide {
 public:
  DecoderSide(entropy::ArithmeticDecoder& coder, std::int32_t width, Sink sink)
      : coder_(coder), words_((width + 63) / 64), sink_(std::move(sink)) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  [[nodiscard]] static bool ink(std::int32_t /*x*/, std::int32_t /*y*/) {
    return false;
  }
  [[nodiscard]] static std::uint64_t ink_word(std::int32_t /*y*/,
                                              std::int32_t /*word*/) {
    return 0;
  }
  void row(std::int32_t y, const PixelPlanes& planes) {
    for (std::int32_t word = 0; word < words_; ++word) {
      sink_(y, static_cast<std::size_t>(word), planes.ink_word(y, word));
    }
  }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }

 private:
  entropy::ArithmeticDecoder& coder_;
  std::int32_t words_;
  Sink sink_;
};

template <class Sink>
Status decode_rows(std::span<const std::uint8_t> payload, std::int32_t width,
                   std::int32_t rows, std::uint8_t revision,
                   const DecodeLimits& limits, const BlockProgress& progress,
                   Sink sink) {
  const std::uint64_t memory = centreline_memory(revision, width, rows);
  if (memory > limits.max_memory) {
    return Error{ErrorCode::limit_exceeded,
                 "centrelines of " + std::to_string(width) + " x " +
                     std::to_string(rows) + " pixels need " +
                     std::to_string(memory) +
                     " bytes, more than the memory limit"};
  }
  entropy::ArithmeticDecoder coder(payload);
  DecoderSide<Sink> side(coder, width, std::move(sink));
  const int bits = centreline_table_bits(revision, width, rows);
  using Side = DecoderSide<Sink>;
  Status status =
      revision == kCentrelinesDeep
          ? CentrelineScan<Side, DeepCentrelineModel, DeepLineStartModel>(
                side, width, rows, bits)
                .run(progress)
          : CentrelineScan<Side, CentrelineModel, CentrelineStartModel>(
                side, width, rows, bits)
                .run(progress);
  if (!status) return status;
  if (!coder.finished()) {
    return Error{ErrorCode::corrupt,
                 "centreline payload does not end where its lines do"};
  }
  return {};
}

}  // namespace

Status decode_centrelines(std::span<const std::uint8_t> payload, Bitmap& ink,
                          std::int32_t first_row, std::int32_t rows,
                          std::uint8_t revision, const DecodeLimits& limits,
                          const BlockProgress& progress) {
  return decode_rows(
      payload, ink.width(), rows, revision, limits, progress,
      [&](std::int32_t y, std::size_t word, std::uint64_t pixels) {
        ink.row(first_row + y)[word] = pixels;
      });
}

Status verify_centrelines(std::span<const std::uint8_t> payload,
                          const Bitmap& ink, std::int32_t first_row,
                          std::int32_t rows, std::uint8_t revision,
                          const DecodeLimits& limits,
                          const BlockProgress& progress) {
  std::int32_t differs = -1;
  Status decoded =
      decode_rows(payload, ink.width(), rows, revision, limits, progress,
                  [&](std::int32_t y, std::size_t word, std::uint64_t pixels) {
                    if (differs < 0 && ink.row(first_row + y)[word] != pixels)
                      differs = y;
                  });
  if (!decoded) return decoded;
  if (differs >= 0) {
    return Error{ErrorCode::internal,
                 "row " + std::to_string(differs) + " decodes to other pixels"};
  }
  return {};
}

}  // namespace unstep::codec
