#include "codec/metadata_encoder.h"

#include <zlib.h>

#include <string>
#include <unordered_set>
#include <vector>

#include "codec/container_format.h"
#include "codec/metadata_words.h"
#include "codec/text_rules.h"

namespace unstep::codec {
namespace {

Status check(const Metadata& metadata) {
  if (metadata.size() > kMaxMetadataPairs ||
      metadata_bytes(metadata) > kMaxMetadataBytes) {
    return Error{ErrorCode::limit_exceeded,
                 "metadata: at most " + std::to_string(kMaxMetadataPairs) +
                     " pairs and " + std::to_string(kMaxMetadataBytes) +
                     " bytes are possible in one list"};
  }
  std::unordered_set<std::string_view> keys;
  for (const auto& [key, value] : metadata) {
    if (key.empty()) {
      return Error{ErrorCode::invalid_argument, "metadata: empty key"};
    }
    if (!is_text(key)) {
      return Error{ErrorCode::invalid_argument,
                   "metadata: a key is not UTF-8 text"};
    }
    if (!is_text(value)) {
      return Error{ErrorCode::invalid_argument,
                   "metadata: the value of \"" + key + "\" is not UTF-8 text"};
    }
    if (!keys.insert(key).second) {
      return Error{ErrorCode::invalid_argument,
                   "metadata: key \"" + key + "\" is given twice"};
    }
  }
  return {};
}

Status deflate_list(std::vector<std::uint8_t>& raw,
                    std::vector<std::uint8_t>& packed) {
  const Error no_memory{ErrorCode::limit_exceeded, "no memory for deflate"};
  z_stream stream{};
  if (deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    return no_memory;
  }
  packed.resize(deflateBound(&stream, static_cast<uLong>(raw.size())));
  stream.next_in = raw.data();
  stream.avail_in = static_cast<uInt>(raw.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool done =
      deflateSetDictionary(
          &stream, reinterpret_cast<const Bytef*>(kMetadataWords.data()),
          static_cast<uInt>(kMetadataWords.size())) == Z_OK &&
      deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (!done) return no_memory;
  return {};
}

}  // namespace

std::uint64_t metadata_bytes(const Metadata& metadata) {
  std::uint64_t total = 0;
  for (const auto& [key, value] : metadata) {
    total += key.size() + value.size() + 2;
  }
  return total;
}

Status write_metadata(const Metadata& metadata, ByteWriter& out) {
  if (Status valid = check(metadata); !valid) return valid;
  std::vector<std::uint8_t> raw;
  for (const auto& [key, value] : metadata) {
    raw.insert(raw.end(), key.begin(), key.end());
    raw.push_back(0);
    raw.insert(raw.end(), value.begin(), value.end());
    raw.push_back(0);
  }
  out.varint(raw.size());
  if (raw.empty()) return {};
  std::vector<std::uint8_t> packed;
  if (Status done = deflate_list(raw, packed); !done) return done;
  out.varint(packed.size());
  out.bytes(packed);
  return {};
}

}  // namespace unstep::codec
