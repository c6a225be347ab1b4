#include "codec/metadata_decoder.h"

#include <zlib.h>

#include <algorithm>
#include <new>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "codec/container_format.h"
#include "codec/metadata_words.h"
#include "codec/text_rules.h"

namespace unstep::codec {
namespace {

/// `packed` is a list of at most kMaxMetadataBytes and known sizes.
bool inflate_exactly(std::span<const std::uint8_t> packed,
                     std::vector<std::uint8_t>& raw) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  stream.next_in = const_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = raw.data();
  stream.avail_out = static_cast<uInt>(raw.size());
  const bool done =
      inflateSetDictionary(
          &stream, reinterpret_cast<const Bytef*>(kMetadataWords.data()),
          static_cast<uInt>(kMetadataWords.size())) == Z_OK &&
      inflate(&stream, Z_FINISH) == Z_STREAM_END && stream.avail_in == 0 &&
      stream.avail_out == 0;
  inflateEnd(&stream);
  return done;
}

/// The text up to the next zero byte; false if there is none.
bool next_text(std::string_view& rest, std::string_view& text) {
  const std::size_t end = rest.find('\0');
  if (end == std::string_view::npos) return false;
  text = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return is_text(text);
}

bool split(std::string_view rest, Metadata& out) {
  std::unordered_set<std::string_view> keys;
  while (!rest.empty()) {
    std::string_view key;
    std::string_view value;
    if (!next_text(rest, key) || !next_text(rest, value)) return false;
    if (key.empty() || !keys.insert(key).second) return false;
    if (out.size() == kMaxMetadataPairs) return false;
    out.emplace_back(key, value);
  }
  return true;
}

}  // namespace

Metadata read_metadata(ByteReader& in, std::uint64_t& budget) {
  const std::uint64_t start = in.position();
  const std::uint64_t raw_size = in.varint("the size of the metadata",
                                           std::min(budget, kMaxMetadataBytes));
  if (!in.ok() || raw_size == 0) return {};
  const std::uint64_t packed_size =
      in.varint("the packed size of the metadata",
                std::min(in.left(), kMaxPackedMetadataBytes));
  const auto packed = in.bytes("the metadata", packed_size);
  if (!in.ok()) return {};
  std::vector<std::uint8_t> raw(static_cast<std::size_t>(raw_size));
  if (!inflate_exactly(packed, raw)) {
    in.fail(ErrorCode::corrupt, start, "metadata does not inflate");
    return {};
  }
  Metadata metadata;
  if (!split({reinterpret_cast<const char*>(raw.data()), raw.size()},
             metadata)) {
    in.fail(ErrorCode::corrupt, start,
            "metadata is not a list of texts under different keys");
    return {};
  }
  const std::uint64_t cost = metadata_cost(raw_size, metadata.size());
  if (cost > budget) {
    in.fail(ErrorCode::corrupt, start, "too much metadata in the file");
    return {};
  }
  budget -= cost;
  return metadata;
}

}  // namespace unstep::codec
