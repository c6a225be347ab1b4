#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "codec/container_decoder.h"
#include "unstep/codec.h"
#include "unstep/result.h"

/// Decodes what a page holds, whole or the part of it that a box needs.
namespace unstep::codec {

class PageDecoder {
 public:
  /// All must outlive the decoder.
  PageDecoder(std::span<const std::uint8_t> file, const DecodeOptions& options,
              const PageEntry& entry, std::span<const BlockProof> proofs)
      : file_(file), options_(options), entry_(entry), proofs_(proofs) {}

  /// UstpReader::read_page, without a box and with one.
  Result<Page> decode(const std::optional<Box>& box) const;

 private:
  using Chosen = std::vector<std::size_t>;  ///< indices of blocks, ascending

  [[nodiscard]] Chosen choose(const std::optional<Box>& box) const;
  Result<std::string> decode_program() const;
  Result<Bitmap> decode_ink(const std::optional<Box>& box) const;
  Result<Bitmap> decode_rows(const Chosen& chosen, std::uint64_t copies) const;
  [[nodiscard]] Status check_ink_limits(std::uint64_t pixels,
                                        std::uint64_t bytes) const;
  template <class Kind>
  Result<std::vector<typename Kind::Item>> decode_items(
      const Chosen& chosen) const;
  template <class Kind>
  [[nodiscard]] Status check_item_limits(const Chosen& chosen) const;
  template <class Kind>
  Result<std::vector<typename Kind::Item>> decode_group(
      std::size_t number,
      const std::function<bool(std::uint64_t)>& progress) const;
  [[nodiscard]] std::span<const std::uint8_t> payload(
      const PageEntry::Block& block) const {
    return file_.subspan(static_cast<std::size_t>(block.offset),
                         static_cast<std::size_t>(block.bytes));
  }

  std::span<const std::uint8_t> file_;
  const DecodeOptions& options_;
  const PageEntry& entry_;
  std::span<const BlockProof> proofs_;
};

}  // namespace unstep::codec
