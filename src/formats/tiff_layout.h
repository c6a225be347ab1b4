#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "unstep/codec.h"

/// The directories of a TIFF file as bytes (TIFF 6.0, section 2; BigTIFF).
/// libtiff gives rationals as floats; the exact ones are read, and written,
/// here. EXIF data has the same form.
namespace unstep {

class TiffLayout {
 public:
  /// Where the value of a tag is.
  struct Entry {
    std::uint16_t type = 0;
    std::uint64_t count = 0;
    std::size_t position = 0;  ///< of the value; `size` bytes are inside
    std::size_t size = 0;
  };

  /// Nothing if the bytes do not begin with a TIFF header.
  static std::optional<TiffLayout> parse(std::span<const std::uint8_t> bytes);

  [[nodiscard]] std::uint64_t first_directory() const { return first_; }

  /// 0 after the last directory or where the file ends too early.
  [[nodiscard]] std::uint64_t next_directory(std::uint64_t directory) const;

  /// The entry of a tag in the directory at that offset. Nothing if there is
  /// none, its type is unknown or its value is not inside the file.
  [[nodiscard]] std::optional<Entry> find(std::uint64_t directory,
                                          std::uint16_t tag) const;

  /// The value of one unsigned RATIONAL, LONG or SHORT.
  [[nodiscard]] std::optional<Rational> rational(const Entry& entry) const;

  /// Overwrites a RATIONAL, or the second of two SHORTs, in a copy of the file
  /// that this layout was parsed from. REQUIRES: the entry has that type.
  void put_rational(std::span<std::uint8_t> file, const Entry& entry,
                    const Rational& value) const;
  void put_second_short(std::span<std::uint8_t> file, const Entry& entry,
                        std::uint16_t value) const;

  static constexpr std::uint16_t kShort = 3;
  static constexpr std::uint16_t kLong = 4;
  static constexpr std::uint16_t kRational = 5;

 private:
  /// A number of 1..8 bytes; 0 if it is not inside the file.
  [[nodiscard]] std::uint64_t number(std::uint64_t position,
                                     std::size_t size) const;
  void put_number(std::span<std::uint8_t> file, std::size_t position,
                  std::size_t size, std::uint64_t value) const;
  [[nodiscard]] std::uint64_t entry_count(std::uint64_t directory) const;
  [[nodiscard]] std::uint64_t entry_position(std::uint64_t directory,
                                             std::uint64_t index) const;

  std::span<const std::uint8_t> bytes_;
  bool little_endian_ = true;
  bool big_tiff_ = false;
  std::uint64_t first_ = 0;
};

}  // namespace unstep
