#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/block_coder.h"
#include "codec/checksum.h"
#include "codec/path_checksum.h"
#include "fuzz/target.h"

/// One payload, behind no checksum: 3 bytes of coder name, 4 bytes of size
/// (width and rows, chains and steps, paths and elements, or lines and bytes,
/// little-endian),
/// the payload.
namespace unstep::fuzz {
namespace {

constexpr std::size_t kHeadBytes = 7;

/// The first byte picks among the known coders; one in eight is taken as is.
codec::CoderName name_of(std::span<const std::uint8_t> head) {
  constexpr std::array<std::uint8_t, 4> kKnown{
      codec::kCoderStored, codec::kCoderContours, codec::kCoderChains,
      codec::kCoderPaths};
  const std::uint8_t pick = head[0];
  if (pick % 32 == 30) return {codec::kCoderProgram, head[1], head[2]};
  if (pick % 32 == 29) return {codec::kCoderStrokes, head[1], head[2]};
  if (pick % 32 == 28) return {codec::kCoderCentrelines, head[1], head[2]};
  if (pick % 32 == 27) return {codec::kCoderPixels, head[1], head[2]};
  const std::uint8_t coder =
      pick % 8 == 7 ? pick / 8 : kKnown[pick % kKnown.size()];
  return {coder, head[1], head[2]};
}

void decode_ink(const codec::CoderName& name, std::uint32_t width,
                std::uint32_t rows, std::span<const std::uint8_t> payload) {
  if (std::uint64_t{width} * rows > limits().max_pixels) return;
  // A band in the middle of a page: its neighbours must stay paper.
  Result<Bitmap> ink = Bitmap::create(width, std::int64_t{rows} + 2);
  if (!ink) return;
  const Status done = codec::decode_ink(
      name, payload, *ink, 1, static_cast<std::int32_t>(rows), limits(), {});
  if (!done) require_sound(done.error());
  const auto last = static_cast<std::int32_t>(rows) + 1;
  for (const std::int32_t y : {std::int32_t{0}, last}) {
    for (const std::uint64_t word : ink->row(y)) {
      require(word == 0, "rows beside the band stay paper");
    }
  }
  for (std::int32_t y = 1; y < last; ++y) {
    require((ink->row(y).back() & ~ink->last_word_mask()) == 0,
            "unused bits of a row stay 0");
  }
}

void decode_chains(const codec::CoderName& name, std::uint32_t count,
                   std::uint32_t steps, std::span<const std::uint8_t> payload) {
  const auto chains =
      codec::decode_chains(name, payload, count, steps, YAxis::down, {});
  if (!chains) return require_sound(chains.error());
  require(chains->size() == count, "as many chains as declared");
  std::uint64_t found = 0;
  for (const Chain& chain : *chains) found += chain.steps.size();
  require(found == steps, "as many steps as declared");
}

void decode_paths(const codec::CoderName& name, std::uint32_t count,
                  std::uint32_t elements,
                  std::span<const std::uint8_t> payload) {
  const auto paths = codec::decode_paths(name, payload, count, elements, {});
  if (!paths) return require_sound(paths.error());
  require(paths->size() == count, "as many paths as declared");
  const auto survey = codec::survey_paths(*paths, {});
  require(bool{survey}, "decoded paths are valid");
  require(survey->elements == elements, "as many elements as declared");
}

void decode_program(const codec::CoderName& name, std::uint32_t lines,
                    std::uint32_t bytes,
                    std::span<const std::uint8_t> payload) {
  const auto text = codec::decode_program(name, payload, lines, bytes, {});
  if (!text) return require_sound(text.error());
  require(text->size() == bytes, "as many bytes as declared");
  const auto ends = std::count(text->begin(), text->end(), '\n');
  require(ends == static_cast<std::ptrdiff_t>(lines),
          "as many lines as declared");
  const auto again = codec::encode_program(*text, {});
  require(bool{again}, "a decoded program can be encoded");
}

}  // namespace
}  // namespace unstep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace unstep::fuzz;
  if (size < kHeadBytes) return 0;
  const std::span<const std::uint8_t> input(data, size);
  const unstep::codec::CoderName name = name_of(input);
  const std::uint32_t first = input[3] | std::uint32_t{input[4]} << 8;
  const std::uint32_t second = input[5] | std::uint32_t{input[6]} << 8;
  const auto payload = input.subspan(kHeadBytes);
  if (name.coder >= unstep::codec::kCoderProgram) {
    decode_program(name, first, second, payload);
  } else if (name.coder >= unstep::codec::kCoderPaths) {
    decode_paths(name, first, second, payload);
  } else if (name.coder >= unstep::codec::kCoderChains) {
    decode_chains(name, first, second, payload);
  } else {
    decode_ink(name, first + 1, second + 1, payload);
  }
  return 0;
}
