#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/context.h"
#include "codec/vector_classes.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// The vertices of all paths so far, found by place: tiles of 16 x 16 units in
/// a hash table of lists, the latest first.
class VertexMemory {
 public:
  static constexpr std::int32_t kNone = -1;
  struct Vertex {
    Point at;
    std::int32_t previous = kNone;  ///< along its path
    std::int32_t next = kNone;
    std::int32_t below = kNone;  ///< in the list of its tile's place
  };

  VertexMemory() : heads_(std::size_t{1} << kHeadBits, kNone) {}

  /// A vertex after `previous`, or the first of a path. At most 2^31 - 1.
  std::int32_t add(Point at, std::int32_t previous) {
    const auto id = static_cast<std::int32_t>(vertices_.size());
    std::int32_t& head = heads_[place(at.x >> 4, at.y >> 4)];
    vertices_.push_back({at, previous, kNone, head});
    head = id;
    if (previous != kNone) vertex(previous).next = id;
    return id;
  }
  /// The last vertex of a closed path is followed by its first.
  void close(std::int32_t last, std::int32_t first) {
    vertex(last).next = first;
    vertex(first).previous = last;
  }

  [[nodiscard]] std::int32_t size() const {
    return static_cast<std::int32_t>(vertices_.size());
  }
  [[nodiscard]] const Vertex& operator[](std::int32_t id) const {
    return vertices_[static_cast<std::size_t>(id)];
  }

  /// Calls visit(id) for the latest vertices in the 3 x 3 tiles around a
  /// point, at most kDepth of each.
  template <class Visit>
  void for_near(Point at, Visit visit) const {
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        visit_tile((at.x >> 4) + dx, (at.y >> 4) + dy, visit);
      }
    }
  }

 private:
  static constexpr int kHeadBits = 14;
  static constexpr int kDepth = 32;

  static std::size_t place(std::int32_t tx, std::int32_t ty) {
    return static_cast<std::size_t>(
        mix(static_cast<std::uint32_t>(tx), static_cast<std::uint32_t>(ty)) *
            kGolden >>
        (64 - kHeadBits));
  }
  Vertex& vertex(std::int32_t id) {
    return vertices_[static_cast<std::size_t>(id)];
  }

  /// Tiles that share a place share their list: others are passed over.
  template <class Visit>
  void visit_tile(std::int32_t tx, std::int32_t ty, Visit visit) const {
    std::int32_t id = heads_[place(tx, ty)];
    for (int depth = 0; id != kNone && depth < kDepth; ++depth) {
      const Vertex& v = (*this)[id];
      if (v.at.x >> 4 == tx && v.at.y >> 4 == ty) visit(id);
      id = v.below;
    }
  }

  std::vector<Vertex> vertices_;
  std::vector<std::int32_t> heads_;
};

}  // namespace unstep::codec
