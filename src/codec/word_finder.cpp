#include "codec/word_finder.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "codec/context.h"
#include "codec/stroke_word.h"

namespace unstep::codec {
namespace {

constexpr int kRounds = 24;

/// A path or a group of the sequence.
struct Node {
  std::uint64_t first = 0;
  std::uint64_t count = 1;
  std::uint32_t kind = 0;
  VertexBox box;  ///< of ink
};

struct PairKey {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::int64_t dx = 0;
  std::int64_t dy = 0;
  friend bool operator==(const PairKey&, const PairKey&) = default;
};
struct PairHash {
  std::size_t operator()(const PairKey& key) const {
    return static_cast<std::size_t>(
        mix(mix(key.a, key.b), mix(static_cast<std::uint64_t>(key.dx),
                                   static_cast<std::uint64_t>(key.dy))) *
            kGolden >>
        8);
  }
};

/// All of a path but its place.
std::vector<std::int32_t> shape_of(const Path& path) {
  std::vector<std::int32_t> shape{path.closed ? 1 : 0, path.width};
  for (const Path::Element& e : path.elements) {
    if (e.kind == Path::Kind::segment) {
      shape.insert(shape.end(), {0, e.segment.dx, e.segment.dy});
    } else {
      shape.insert(shape.end(), {e.arc.clockwise ? 1 : 2, e.arc.centre.x,
                                 e.arc.centre.y, e.arc.end.x, e.arc.end.y});
    }
  }
  return shape;
}

class Finder {
 public:
  explicit Finder(std::span<const Path> paths) : paths_(paths) {
    std::map<std::vector<std::int32_t>, std::uint32_t> shapes;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const Path& path = paths[i];
      const auto kind = shapes.try_emplace(
          shape_of(path), static_cast<std::uint32_t>(shapes.size()));
      VertexBox box;
      box.add(path);
      const std::int32_t reach = path.width / 2 + 1;
      box = {box.left - reach, box.top - reach, box.right + reach,
             box.bottom + reach};
      nodes_.push_back({i, 1, kind.first->second, box});
    }
    kinds_ = static_cast<std::uint32_t>(shapes.size());
    parts_.resize(kinds_);
  }

  std::vector<PathGroup> run() {
    for (int round = 0; round < kRounds && merge(); ++round) {
    }
    while (split()) {
    }
    std::vector<PathGroup> groups;
    const auto times = count_kinds();
    for (const Node& node : nodes_) {
      groups.push_back({node.first, node.count, node.kind, times[node.kind]});
    }
    return groups;
  }

 private:
  struct Parts {
    std::uint64_t first_count = 0;  ///< paths of the first part, 0 for a path
    std::uint32_t a = 0;
    std::uint32_t b = 0;
  };

  static bool touch(const VertexBox& a, const VertexBox& b) {
    return a.left <= b.right && b.left <= a.right && a.top <= b.bottom &&
           b.top <= a.bottom;
  }

  [[nodiscard]] PairKey key(const Node& a, const Node& b) const {
    const Point p = paths_[a.first].origin;
    const Point q = paths_[b.first].origin;
    return {a.kind, b.kind, std::int64_t{q.x} - p.x, std::int64_t{q.y} - p.y};
  }

  [[nodiscard]] std::vector<std::uint32_t> count_kinds() const {
    std::vector<std::uint32_t> counts(kinds_);
    for (const Node& node : nodes_) ++counts[node.kind];
    return counts;
  }

  bool merge() {
    std::unordered_map<PairKey, std::uint32_t, PairHash> counts;
    std::vector<std::uint32_t> at(nodes_.size());
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (touch(nodes_[i].box, nodes_[i + 1].box)) {
        ++counts[key(nodes_[i], nodes_[i + 1])];
      }
    }
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (!touch(nodes_[i].box, nodes_[i + 1].box)) continue;
      at[i] = counts[key(nodes_[i], nodes_[i + 1])];
    }
    std::unordered_map<PairKey, std::uint32_t, PairHash> made;
    std::vector<Node> merged;
    bool any = false;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const std::uint32_t next = i + 1 < nodes_.size() ? at[i + 1] : 0;
      if (at[i] < 2 || at[i] < next) {
        merged.push_back(nodes_[i]);
        continue;
      }
      const Node& a = nodes_[i];
      const Node& b = nodes_[i + 1];
      const auto kind = made.try_emplace(key(a, b), kinds_);
      if (kind.second) {
        ++kinds_;
        parts_.push_back({a.count, a.kind, b.kind});
      }
      VertexBox box = a.box;
      box.add(b.box.left, b.box.top);
      box.add(b.box.right, b.box.bottom);
      merged.push_back({a.first, a.count + b.count, kind.first->second, box});
      ++i;
      any = true;
    }
    nodes_ = std::move(merged);
    return any;
  }

  /// Groups that are left but once fall apart.
  bool split() {
    const auto counts = count_kinds();
    std::vector<Node> all;
    bool any = false;
    for (const Node& node : nodes_) {
      const Parts& parts = parts_[node.kind];
      if (counts[node.kind] > 1 || parts.first_count == 0) {
        all.push_back(node);
        continue;
      }
      any = true;
      all.push_back({node.first, parts.first_count, parts.a, {}});
      all.push_back({node.first + parts.first_count,
                     node.count - parts.first_count,
                     parts.b,
                     {}});
    }
    nodes_ = std::move(all);
    return any;
  }

  std::span<const Path> paths_;
  std::vector<Node> nodes_;
  std::uint32_t kinds_ = 0;
  std::vector<Parts> parts_;  ///< of each kind
};

}  // namespace

std::vector<PathGroup> find_groups(std::span<const Path> paths) {
  return Finder(paths).run();
}

}  // namespace unstep::codec
