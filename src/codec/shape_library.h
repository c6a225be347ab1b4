#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "codec/shape_glyph.h"

namespace unstep::codec {

/// The shapes that later ones may refer to. A shape that refers to another is
/// of its class; a class offers its kOffered most recently used shapes, the
/// latest first.
class ShapeLibrary {
 public:
  static constexpr std::size_t kOffered = 64;

  struct Entry {
    Glyph glyph;
    std::uint32_t klass = 0;
    /// Its corner in the frame of the class, that of the first shape.
    std::int32_t x = 0;
    std::int32_t y = 0;
  };

  /// Bytes that remembering a shape takes at most: thrice (for vectors that
  /// grow) an entry, a class and what the owner keeps of the class; the ids of
  /// a class of one and the pixels, with what an allocator adds to either.
  static constexpr std::uint64_t kSmallest =
      3 * (sizeof(Entry) + sizeof(std::vector<std::uint32_t>) +
           sizeof(std::int32_t)) +
      2 * 32;
  static std::uint64_t memory(const Glyph& glyph) {
    return kSmallest + glyph.words.size() * sizeof(std::uint64_t);
  }
  static constexpr std::uint64_t kLargest =
      kSmallest + kMaxShapeSide * ((kMaxShapeSide + 63) / 64) * 8;

  [[nodiscard]] std::size_t classes() const { return classes_.size(); }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] const Entry& entry(std::uint32_t id) const {
    return entries_[id];
  }
  /// How many shapes a class offers, at least one.
  [[nodiscard]] std::size_t offered(std::uint32_t klass) const {
    return classes_[klass].size();
  }
  [[nodiscard]] std::uint32_t at(std::uint32_t klass, std::size_t rank) const {
    return classes_[klass][rank];
  }
  /// kOffered if the shape is no longer offered.
  [[nodiscard]] std::size_t rank(std::uint32_t id) const {
    const auto& ids = classes_[entries_[id].klass];
    const auto found = std::find(ids.begin(), ids.end(), id);
    return found == ids.end() ? kOffered
                              : static_cast<std::size_t>(found - ids.begin());
  }

  /// The shape was referred to.
  void touch(std::uint32_t klass, std::size_t rank) {
    auto& ids = classes_[klass];
    const auto used = ids.begin() + static_cast<std::ptrdiff_t>(rank);
    std::rotate(ids.begin(), used, used + 1);
  }

  /// A shape that refers to none opens a class. Returns its id.
  std::uint32_t open(Glyph glyph) {
    classes_.emplace_back();
    return add(static_cast<std::uint32_t>(classes_.size() - 1),
               std::move(glyph));
  }

  /// Adds to a class. Returns its id.
  std::uint32_t add(std::uint32_t klass, Glyph glyph, std::int32_t x = 0,
                    std::int32_t y = 0) {
    const auto id = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({std::move(glyph), klass, x, y});
    auto& ids = classes_[klass];
    if (ids.size() == kOffered) {
      entries_[ids.back()].glyph = Glyph();  // nobody can ask for it again
      ids.pop_back();
    }
    ids.insert(ids.begin(), id);
    return id;
  }

 private:
  std::vector<Entry> entries_;
  std::vector<std::vector<std::uint32_t>> classes_;
};

}  // namespace unstep::codec
