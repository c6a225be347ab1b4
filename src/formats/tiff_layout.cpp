#include "formats/tiff_layout.h"

#include <algorithm>

namespace unstep {
namespace {

std::size_t type_size(std::uint16_t type) {
  switch (type) {
    case 1:
    case 2:
    case 6:
    case 7: return 1;
    case 3:
    case 8: return 2;
    case 4:
    case 9:
    case 11:
    case 13: return 4;
    case 5:
    case 10:
    case 12:
    case 16:
    case 17:
    case 18: return 8;
    default: return 0;
  }
}

}  // namespace

std::optional<TiffLayout> TiffLayout::parse(
    std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 8 || bytes[0] != bytes[1] ||
      (bytes[0] != 'I' && bytes[0] != 'M')) {
    return std::nullopt;
  }
  TiffLayout layout;
  layout.bytes_ = bytes;
  layout.little_endian_ = bytes[0] == 'I';
  const std::uint64_t version = layout.number(2, 2);
  if (version != 42 && version != 43) return std::nullopt;
  layout.big_tiff_ = version == 43;
  layout.first_ = layout.big_tiff_ ? layout.number(8, 8) : layout.number(4, 4);
  return layout;
}

std::uint64_t TiffLayout::number(std::uint64_t position,
                                 std::size_t size) const {
  if (position > bytes_.size() || size > bytes_.size() - position) return 0;
  const auto at = bytes_.subspan(static_cast<std::size_t>(position), size);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value = value << 8 | at[little_endian_ ? size - 1 - i : i];
  }
  return value;
}

void TiffLayout::put_number(std::span<std::uint8_t> file, std::size_t position,
                            std::size_t size, std::uint64_t value) const {
  for (std::size_t i = 0; i < size; ++i, value >>= 8) {
    file[position + (little_endian_ ? i : size - 1 - i)] =
        static_cast<std::uint8_t>(value);
  }
}

std::uint64_t TiffLayout::entry_count(std::uint64_t directory) const {
  const std::uint64_t count = number(directory, big_tiff_ ? 8 : 2);
  return std::min<std::uint64_t>(count, bytes_.size() / 12);
}

std::uint64_t TiffLayout::entry_position(std::uint64_t directory,
                                         std::uint64_t index) const {
  return directory + (big_tiff_ ? 8 + index * 20 : 2 + index * 12);
}

std::uint64_t TiffLayout::next_directory(std::uint64_t directory) const {
  return number(entry_position(directory, entry_count(directory)),
                big_tiff_ ? 8 : 4);
}

std::optional<TiffLayout::Entry> TiffLayout::find(std::uint64_t directory,
                                                  std::uint16_t tag) const {
  if (directory == 0 || directory >= bytes_.size()) return std::nullopt;
  const std::size_t field = big_tiff_ ? 8 : 4;  // of the count and the value
  for (std::uint64_t i = 0, n = entry_count(directory); i < n; ++i) {
    const std::uint64_t at = entry_position(directory, i);
    if (number(at, 2) != tag) continue;
    Entry entry;
    entry.type = static_cast<std::uint16_t>(number(at + 2, 2));
    entry.count = number(at + 4, field);
    const std::size_t unit = type_size(entry.type);
    if (unit == 0 || entry.count > bytes_.size() / unit) return std::nullopt;
    entry.size = static_cast<std::size_t>(entry.count) * unit;
    std::uint64_t position = at + 4 + field;
    if (entry.size > field) position = number(position, field);
    if (position > bytes_.size() || entry.size > bytes_.size() - position) {
      return std::nullopt;
    }
    entry.position = static_cast<std::size_t>(position);
    return entry;
  }
  return std::nullopt;
}

std::optional<Rational> TiffLayout::rational(const Entry& entry) const {
  if (entry.count != 1) return std::nullopt;
  const auto part = [&](std::size_t offset, std::size_t size) {
    return static_cast<std::uint32_t>(number(entry.position + offset, size));
  };
  switch (entry.type) {
    case kShort: return Rational{part(0, 2), 1};
    case kLong: return Rational{part(0, 4), 1};
    case kRational: return Rational{part(0, 4), part(4, 4)};
    default: return std::nullopt;
  }
}

void TiffLayout::put_rational(std::span<std::uint8_t> file, const Entry& entry,
                              const Rational& value) const {
  put_number(file, entry.position, 4, value.numerator);
  put_number(file, entry.position + 4, 4, value.denominator);
}

void TiffLayout::put_second_short(std::span<std::uint8_t> file,
                                  const Entry& entry,
                                  std::uint16_t value) const {
  put_number(file, entry.position + 2, 2, value);
}

}  // namespace unstep
