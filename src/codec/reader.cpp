#include <new>
#include <optional>
#include <string>
#include <utility>

#include "codec/container_decoder.h"
#include "codec/page_decoder.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

Error no_memory() { return Error{ErrorCode::limit_exceeded, "no memory"}; }

}  // namespace

struct UstpReader::Impl {
  std::span<const std::uint8_t> file;
  DecodeOptions options;
  codec::ParsedFile parsed;

  [[nodiscard]] Result<Page> read(std::size_t index,
                                  const std::optional<Box>& box) const;
};

Result<Page> UstpReader::Impl::read(std::size_t index,
                                    const std::optional<Box>& box) const {
  const std::vector<PageEntry>& pages = parsed.info.pages;
  if (index >= pages.size()) {
    return Error{ErrorCode::out_of_range, "page " + std::to_string(index + 1) +
                                              " of " +
                                              std::to_string(pages.size())};
  }
  try {
    const codec::PageDecoder decoder(file, options, pages[index],
                                     parsed.proofs[index]);
    Result<Page> page = decoder.decode(box);
    if (page || page.error().code == ErrorCode::cancelled) return page;
    Error error = page.error();
    error.message = "page " + std::to_string(index + 1) + ": " + error.message;
    return error;
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
}

UstpReader::UstpReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UstpReader::~UstpReader() = default;
UstpReader::UstpReader(UstpReader&&) noexcept = default;
UstpReader& UstpReader::operator=(UstpReader&&) noexcept = default;

Result<UstpReader> UstpReader::open(std::span<const std::uint8_t> file,
                                    DecodeOptions options) {
  try {
    Result<codec::ParsedFile> parsed = codec::parse_file(file);
    if (!parsed) return parsed.error();
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    impl->options = std::move(options);
    impl->parsed = *std::move(parsed);
    return UstpReader(std::move(impl));
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
}

const FileInfo& UstpReader::info() const { return impl_->parsed.info; }

Result<Page> UstpReader::read_page(std::size_t index) const {
  return impl_->read(index, std::nullopt);
}

Result<Page> UstpReader::read_page(std::size_t index, const Box& box) const {
  return impl_->read(index, box);
}

}  // namespace unstep
