#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "codec/centreline_coder.h"
#include "codec/contour_coder.h"
#include "codec/pixel_coder.h"
#include "fuzz/target.h"

/// Any ink comes back: 1 byte of width, 1 byte of options, the pixels.
namespace unstep::fuzz {
namespace {

Bitmap ink_of(std::int32_t width, std::span<const std::uint8_t> bits) {
  const auto count = static_cast<std::int64_t>(bits.size()) * 8;
  const std::int64_t height = std::max<std::int64_t>(1, count / width);
  Bitmap ink = *Bitmap::create(width, height);
  for (std::int64_t i = 0; i < std::min(count, width * height); ++i) {
    const bool bit =
        (bits[static_cast<std::size_t>(i / 8)] >> (i % 8) & 1) != 0;
    ink.set(static_cast<std::int32_t>(i % width),
            static_cast<std::int32_t>(i / width), bit);
  }
  return ink;
}

void round_trip(const Bitmap& ink, std::uint8_t choice) {
  EncodeOptions options;
  options.bands = choice % 5;
  options.jobs = 1 + choice / 64;
  PageInfo info;
  if ((choice & 8) != 0) info.name = "page";
  if ((choice & 16) != 0) info.resolution.x = {300, choice};
  if ((choice & 32) != 0) options.metadata = {{"key", "value"}};
  if (info.resolution.x.denominator == 0) info.resolution.x.denominator = 1;

  UstpWriter writer(options);
  const Status added = writer.add_page(ink, info);
  require(static_cast<bool>(added), "any ink can be encoded");
  const auto file = writer.finish();
  require(static_cast<bool>(file), "any page makes a file");
  DecodeOptions decode_options;
  decode_options.jobs = options.jobs;
  const auto reader = UstpReader::open(*file, decode_options);
  require(static_cast<bool>(reader), "an encoded file can be opened");
  const auto page = reader->read_page(0);
  require(static_cast<bool>(page), "an encoded page can be decoded");
  require(page->ink == ink, "decoded pixels are the encoded ones");
  require(page->info == info, "the page's properties are kept");
  require(reader->info().metadata == options.metadata, "metadata is kept");
}

/// The deep models need more than other inputs of the size may have.
DecodeLimits deep_limits() {
  DecodeLimits most = limits();
  most.max_memory = 256U << 20;
  return most;
}

/// Coder 3 as well, which the writer takes for thin lines only.
void round_trip_centrelines(const Bitmap& ink, std::uint8_t revision) {
  const auto payload =
      codec::encode_centrelines(ink, 0, ink.height(), revision, {});
  require(static_cast<bool>(payload), "any ink can be coded as centrelines");
  require(static_cast<bool>(codec::verify_centrelines(
              *payload, ink, 0, ink.height(), revision, deep_limits(), {})),
          "centrelines come back");
}

/// And contours under a model that is taken beside shapes, or if smallest.
void round_trip_contours(const Bitmap& ink, std::uint8_t revision) {
  const auto payload =
      codec::encode_contours(ink, 0, ink.height(), revision, {});
  require(static_cast<bool>(payload), "any ink can be coded as contours");
  require(static_cast<bool>(codec::verify_contours(
              *payload, ink, 0, ink.height(), revision, deep_limits(), {})),
          "contours come back");
}

/// And coder 4, taken for large or dithered pages only.
void round_trip_pixels(const Bitmap& ink, std::uint8_t revision) {
  const auto payload = codec::encode_pixels(ink, 0, ink.height(), revision, {});
  require(static_cast<bool>(payload), "any ink can be coded as pixels");
  Bitmap decoded = *Bitmap::create(ink.width(), ink.height());
  require(static_cast<bool>(codec::decode_pixels(
              *payload, decoded, 0, ink.height(), revision, limits(), {})),
          "pixels can be decoded");
  require(decoded == ink, "pixels come back");
}

}  // namespace
}  // namespace unstep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size < 2 || size > 4096) return 0;
  const std::span<const std::uint8_t> input(data, size);
  const unstep::Bitmap ink =
      unstep::fuzz::ink_of(input[0] + 1, input.subspan(2));
  unstep::fuzz::round_trip(ink, input[1]);
  namespace codec = unstep::codec;
  // Seldom: they fill tens of megabytes for each input.
  const bool deep = input[1] % 16 == 1;
  unstep::fuzz::round_trip_centrelines(
      ink, deep ? codec::kCentrelinesDeep : codec::kCentrelinesMixed);
  unstep::fuzz::round_trip_contours(
      ink, deep ? codec::kContourDeep : codec::kContourLight);
  unstep::fuzz::round_trip_pixels(ink, input[1] % 3);
  return 0;
}
