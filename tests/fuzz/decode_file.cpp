#include <algorithm>
#include <cstddef>
#include <vector>

#include "codec/byte_reader.h"
#include "codec/checksum.h"
#include "fuzz/target.h"

/// Any bytes as a file; then the same bytes with right block CRCs, so that
/// what lies behind a CRC is reached too.
namespace unstep::fuzz {
namespace {

void decode(std::span<const std::uint8_t> file) {
  DecodeOptions options;
  options.limits = limits();
  const Result<UstpReader> reader = UstpReader::open(file, options);
  if (!reader) return require_sound(reader.error());
  const std::size_t pages =
      std::min<std::size_t>(reader->info().pages.size(), 4);
  for (std::size_t i = 0; i < pages; ++i) {
    const Result<Page> page = reader->read_page(i);
    if (!page) {
      require_sound(page.error());
    } else if (page->kind == PageKind::ink) {
      require(page->ink.crc32() == reader->info().pages[i].checksum,
              "decoded ink has the page's checksum");
    }
  }
  require(!reader->read_page(reader->info().pages.size()),
          "a page after the last is an error");
}

/// REQUIRES: block form.
void repair_crcs(std::vector<std::uint8_t>& file) {
  constexpr std::size_t kFirstBlock = 5;
  std::size_t at = kFirstBlock;
  while (at < file.size()) {
    const std::span<const std::uint8_t> rest = std::span(file).subspan(at);
    codec::ByteReader in(rest, at, ErrorCode::truncated);
    in.u8("type");
    const std::uint64_t length = in.varint("length", file.size());
    in.bytes("content", length);
    const auto crc_at = static_cast<std::size_t>(in.position());
    in.u32("crc");
    if (!in.ok()) return;
    const std::uint32_t crc =
        codec::crc_bytes(std::span(file).subspan(at, crc_at - at));
    for (std::size_t i = 0; i < 4; ++i) {
      file[crc_at + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    }
    at = crc_at + 4;
  }
}

}  // namespace
}  // namespace unstep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using unstep::codec::kBlockFormFlag;
  unstep::fuzz::decode({data, size});
  if (size > 5 && (data[4] & kBlockFormFlag) != 0) {
    std::vector<std::uint8_t> repaired(data, data + size);
    unstep::fuzz::repair_crcs(repaired);
    unstep::fuzz::decode(repaired);
  }
  return 0;
}
