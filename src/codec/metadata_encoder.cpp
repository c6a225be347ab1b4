#include "codec/metadata_encoder.h"

#include <zlib.h>

#include <string>
#include <unordered_set>
#include <vector>

#include "codec/container_format.h"
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
  uLongf packed_size = compressBound(static_cast<uLong>(raw.size()));
  std::vector<std::uint8_t> packed(packed_size);
  if (compress2(packed.data(), &packed_size, raw.data(),
                static_cast<uLong>(raw.size()), 9) != Z_OK) {
    return Error{ErrorCode::limit_exceeded, "no memory for deflate"};
  }
  packed.resize(packed_size);
  out.varint(packed.size());
  out.bytes(packed);
  return {};
}

}  // namespace unstep::codec
