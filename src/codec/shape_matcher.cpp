#include "codec/shape_matcher.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "codec/shape_finder.h"
#include "codec/shape_library.h"
#include "grid/bit_count.h"

namespace unstep::codec {
namespace {

/// Specks below this are cheaper as contours.
constexpr std::int64_t kMinPixels = 4;
/// How far a size may differ from that of a reference.
constexpr std::int32_t kNearSize = 2;
/// Of 64 cells; beyond this a candidate is not looked at.
constexpr int kFarCells = 20;
/// How many candidates are compared pixel by pixel.
constexpr int kMaxTries = 12;
/// How many candidates of one size are looked at, from the latest back.
constexpr std::size_t kLatest = 256;
/// Lines that grow higher than this are not one line.
constexpr std::int32_t kLineHeight = 60;

/// A shape that may be referred to, and what finds it fast.
struct Candidate {
  std::size_t shape;
  std::uint32_t id;  ///< in the library
};

/// Those of one size, and beside them their 8 x 8 cells, one bit each.
struct Bucket {
  std::vector<Candidate> candidates;
  std::vector<std::uint64_t> coarse;
};

/// 8 x 8 cells of a glyph, set if half of the cell is ink.
std::uint64_t coarse_view(const Glyph& glyph) {
  std::uint64_t view = 0;
  std::array<std::int32_t, 9> edge{};
  for (std::int32_t i = 0; i <= 8; ++i) {
    edge[static_cast<std::size_t>(i)] = i * glyph.width / 8;
  }
  for (std::int32_t v = 0; v < 8; ++v) {
    const std::int32_t top = v * glyph.height / 8;
    const std::int32_t bottom = std::max(top + 1, (v + 1) * glyph.height / 8);
    std::array<std::int32_t, 8> ink{};
    for (std::int32_t y = top; y < bottom; ++y) {
      const std::uint64_t* row = glyph.row(y);
      for (std::size_t u = 0; u < 8; ++u) {
        // At most 32 pixels wide, so in one window.
        const std::int32_t x = edge[u];
        const std::int32_t width = std::max(1, edge[u + 1] - x);
        const auto word = static_cast<std::size_t>(x / 64);
        std::uint64_t bits = row[word] << x % 64;
        if (word + 1 < glyph.stride()) {
          bits |= row[word + 1] >> 1 >> (63 - x % 64);
        }
        ink[u] += ones(bits >> (64 - width));
      }
    }
    for (std::size_t u = 0; u < 8; ++u) {
      const std::int32_t area =
          std::max(1, edge[u + 1] - edge[u]) * (bottom - top);
      view = view << 1 | (ink[u] * 2 > area ? 1U : 0U);
    }
  }
  return view;
}

/// In how many pixels two narrow glyphs differ, in rows first .. end - 1 that
/// both have; stops a few rows after `limit` is reached.
std::int32_t narrow_distance(const Glyph& a, const Glyph& b, std::int32_t dy,
                             std::int32_t first, std::int32_t end, int shift,
                             std::int32_t limit) {
  std::int32_t differ = 0;
  const std::uint64_t* ra = a.row(first);
  const std::uint64_t* rb = b.row(first + dy);
  std::int32_t left = end - first;
  for (; left >= 4 && differ < limit; left -= 4, ra += 4, rb += 4) {
    differ += ones_of_difference(ra, 8, rb, shift);
  }
  for (; left > 0 && differ < limit; --left) {
    differ += ones(*ra++ >> 8 ^ *rb++ >> shift);
  }
  return differ;
}

/// In how many pixels two glyphs differ, (i, j) of a lying on (i + dx, j + dy)
/// of b; stops at `limit`. REQUIRES: |dx| < 8.
std::int32_t distance(const Glyph& a, const Glyph& b, std::int32_t dx,
                      std::int32_t dy, std::int32_t limit) {
  static constexpr std::array<std::uint64_t, kMaxShapeSide / 64 + 1> kBlank{};
  std::int32_t differ = 0;
  const std::int32_t top = std::min(0, -dy);
  const std::int32_t bottom = std::max(a.height, b.height - dy);
  const int shift = 8 - dx;  // b moves by it, a by 8, so both to the right
  const auto row_of = [](const Glyph& glyph, std::int32_t y) {
    return y >= 0 && y < glyph.height ? glyph.row(y) : kBlank.data();
  };
  if (std::max(a.width, b.width) <= 48) {
    const std::int32_t first = std::max(0, -dy);
    const std::int32_t end = std::max(first, std::min(a.height, b.height - dy));
    for (std::int32_t y = top; y < bottom; ++y) {
      if (y == first) y = end;
      if (y >= bottom) break;
      differ += ones(*row_of(a, y) ^ *row_of(b, y + dy));
    }
    return differ +
           narrow_distance(a, b, dy, first, end, shift, limit - differ);
  }
  const std::size_t words = std::max(a.stride(), b.stride()) + 1;
  for (std::int32_t y = top; y < bottom && differ < limit; ++y) {
    const std::uint64_t* ra = row_of(a, y);
    const std::uint64_t* rb = row_of(b, y + dy);
    std::uint64_t last_a = 0;
    std::uint64_t last_b = 0;
    for (std::size_t i = 0; i < words; ++i) {
      const std::uint64_t wa = i < a.stride() ? ra[i] : 0;
      const std::uint64_t wb = i < b.stride() ? rb[i] : 0;
      const std::uint64_t x =
          (last_a << 56 | wa >> 8) ^ (last_b << (64 - shift) | wb >> shift);
      if (x != 0) differ += ones(x);
      last_a = wa;
      last_b = wb;
    }
  }
  return differ;
}

/// Reading order: lines from the top, each from the left.
std::vector<std::pair<std::size_t, bool>> reading_order(
    const std::vector<Component>& parts) {
  std::vector<std::pair<std::size_t, bool>> order;
  std::vector<bool> used(parts.size());
  std::vector<std::size_t> line;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (used[i]) continue;
    const std::int32_t top = parts[i].y;
    std::int32_t bottom = parts[i].bottom;
    line.clear();
    for (std::size_t j = i; j < parts.size() && parts[j].y < bottom; ++j) {
      if (used[j]) continue;
      const std::int32_t middle = (parts[j].y + parts[j].bottom) / 2;
      if (middle < top - 2 || middle > bottom + 2) continue;
      line.push_back(j);
      used[j] = true;
      if (parts[j].height() < kLineHeight) {
        bottom = std::max(bottom, std::min(parts[j].bottom, top + kLineHeight));
      }
    }
    std::sort(line.begin(), line.end(), [&](std::size_t a, std::size_t b) {
      return parts[a].x < parts[b].x;
    });
    for (const std::size_t j : line) order.emplace_back(j, j == line.front());
  }
  return order;
}

class Matcher {
 public:
  /// Sets what a shape refers to, if anything, and offers it to later ones.
  void match(std::vector<PlacedShape>& shapes, std::size_t index,
             std::int64_t pixels) {
    PlacedShape& shape = shapes[index];
    const Glyph& glyph = shape.glyph;
    const std::uint64_t view = coarse_view(glyph);
    gather(glyph, view);
    // Not like it if a quarter of the ink or all along the outline differs.
    auto best = static_cast<std::int32_t>(
        std::min<std::int64_t>(pixels / 4, 2 * (glyph.width + glyph.height)));
    best = std::max(best, 1);
    const Candidate* found = nullptr;
    int tries = 0;
    for (std::size_t i = 0; i < near_.size() && tries < kMaxTries && best > 0;
         ++i) {
      const Candidate& candidate = *near_[i];
      if (library_.rank(candidate.id) == ShapeLibrary::kOffered) continue;
      ++tries;
      if (try_all(glyph, shapes[candidate.shape].glyph, best, shape)) {
        found = &candidate;
      }
    }
    if (found == nullptr)
      return offer(shapes, index, library_.open(Glyph()), view);
    shape.refers = true;
    shape.reference = found->id;
    const std::uint32_t klass = library_.entry(found->id).klass;
    library_.touch(klass, library_.rank(found->id));
    if (best > 0) offer(shapes, index, library_.add(klass, Glyph()), view);
  }

 private:
  static std::size_t place_of(std::int32_t height, std::int32_t width) {
    return static_cast<std::size_t>(height * (kMaxShapeSide + 1) + width);
  }

  void offer(const std::vector<PlacedShape>& shapes, std::size_t index,
             std::uint32_t id, std::uint64_t view) {
    const Glyph& glyph = shapes[index].glyph;
    std::uint32_t& place = places_[place_of(glyph.height, glyph.width)];
    if (place == kNone) {
      place = static_cast<std::uint32_t>(buckets_.size());
      buckets_.emplace_back();
    }
    Bucket& bucket = buckets_[place];
    bucket.candidates.push_back({index, id});
    bucket.coarse.push_back(view);
  }

  /// The latest candidates of about this size, the most alike first, later
  /// ones before earlier ones.
  void gather(const Glyph& glyph, std::uint64_t view) {
    for (auto& level : levels_) level.clear();
    for (std::int32_t h = glyph.height - kNearSize;
         h <= glyph.height + kNearSize; ++h) {
      for (std::int32_t w = glyph.width - kNearSize;
           w <= glyph.width + kNearSize; ++w) {
        if (h >= 1 && w >= 1 && h <= kMaxShapeSide && w <= kMaxShapeSide) {
          const std::uint32_t place = places_[place_of(h, w)];
          if (place != kNone) gather(buckets_[place], view);
        }
      }
    }
    near_.clear();
    for (auto& level : levels_) {
      std::sort(level.begin(), level.end(),
                [](const Candidate* a, const Candidate* b) {
                  return a->shape > b->shape;
                });
      near_.insert(near_.end(), level.begin(), level.end());
      if (near_.size() >= std::size_t{4} * kMaxTries) break;
    }
    near_.resize(std::min(near_.size(), std::size_t{4} * kMaxTries));
  }

  void gather(const Bucket& bucket, std::uint64_t view) {
    const std::size_t size = bucket.candidates.size();
    const auto look = [&](std::size_t i, int differ) {
      if (differ > kFarCells) return;
      levels_[static_cast<std::size_t>(differ)].push_back(
          &bucket.candidates[i]);
    };
    std::size_t i = size - std::min(size, kLatest);
    for (; i + 2 <= size; i += 2) {
      const auto [first, second] = ones_of_two(&bucket.coarse[i], view);
      look(i, first);
      look(i + 1, second);
    }
    if (i < size) look(i, ones(view ^ bucket.coarse[i]));
  }

  /// Tries all shifts; true if one is better than `best`.
  static bool try_all(const Glyph& glyph, const Glyph& other,
                      std::int32_t& best, PlacedShape& shape) {
    const std::int32_t dx = (other.width - glyph.width) / 2;
    const std::int32_t dy = (other.height - glyph.height) / 2;
    const std::int32_t middle = distance(glyph, other, dx, dy, 2 * best);
    if (middle >= 2 * best) return false;  // no shift will mend that
    bool better = false;
    for (const std::int32_t v : {0, -1, 1}) {
      for (const std::int32_t u : {0, -1, 1}) {
        const std::int32_t differ =
            u == 0 && v == 0 ? middle
                             : distance(glyph, other, dx + u, dy + v, best);
        if (differ >= best) continue;
        best = differ;
        shape.dx = u;
        shape.dy = v;
        better = true;
      }
    }
    return better;
  }

  std::array<std::vector<const Candidate*>, kFarCells + 1> levels_;
  std::vector<const Candidate*> near_;
  /// Where the bucket of a size is. Most sizes never come.
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> places_ = std::vector<std::uint32_t>(
      std::size_t{kMaxShapeSide + 1} * (kMaxShapeSide + 1), kNone);
  std::vector<Bucket> buckets_;
  ShapeLibrary library_;  ///< without the pixels
};

/// The length of a glyph's outlines in unit steps.
std::uint64_t outline(const Glyph& glyph) {
  std::uint64_t steps = 0;
  const std::size_t stride = glyph.stride();
  for (std::int32_t y = 0; y <= glyph.height; ++y) {
    std::uint64_t left = 0;
    for (std::size_t i = 0; i < stride; ++i) {
      const std::uint64_t here = y < glyph.height ? glyph.row(y)[i] : 0;
      const std::uint64_t above = y > 0 ? glyph.row(y - 1)[i] : 0;
      steps += static_cast<std::uint64_t>(ones(here ^ above) +
                                          ones(here ^ (here >> 1 | left)));
      left = here << 63;
    }
    steps += left >> 63;
  }
  return steps;
}

/// What decides whether shapes are cheaper told by reference than walked
/// around: they must repeat, be many and not be mere specks.
struct Worth {
  static constexpr std::uint64_t kFewest = 100;
  /// Shapes after which a hopeless page is given up, and again at every power
  /// of two: later shapes find more to refer to, so it may miss by half at
  /// first, by less the more it has seen.
  static constexpr std::uint64_t kSample = 1024;

  std::uint64_t least = kShapesPay;
  std::uint64_t count = 0;
  std::uint64_t referring = 0;
  std::uint64_t steps = 0;

  void add(const PlacedShape& shape) {
    ++count;
    referring += shape.refers ? 1U : 0U;
    steps += outline(shape.glyph);
  }
  /// Fewer than 2^26 shapes of at most 2^17 steps: no overflow.
  [[nodiscard]] std::uint64_t measure() const {
    return referring * referring / count * (steps / count);
  }
  [[nodiscard]] bool enough() const {
    return referring >= kFewest && measure() >= least * count;
  }
  [[nodiscard]] bool hopeless() const {
    return count >= kSample && std::has_single_bit(count) &&
           measure() < least * (count - kSample / 2);
  }
};

/// All shapes matched; with `worth`, none if it is not worth it.
std::vector<PlacedShape> match(const Bitmap& ink, std::int32_t first_row,
                               std::int32_t rows, Worth* worth) {
  std::vector<Component> parts =
      find_components(ink, first_row, rows, ink.pixels() / 64 + 4096);
  std::erase_if(parts, [](const Component& part) {
    return part.width() > kMaxShapeSide || part.height() > kMaxShapeSide ||
           part.pixels < kMinPixels;
  });
  std::vector<PlacedShape> shapes;
  Matcher matcher;
  std::uint64_t room = shape_room(ink.width(), rows);
  for (const auto& [index, new_line] : reading_order(parts)) {
    const Component& part = parts[index];
    const std::uint64_t cost = shape_cost(part.width(), part.height());
    if (cost > room) break;
    room -= cost;
    PlacedShape shape;
    shape.glyph = cut_out(ink, first_row, part);
    shape.x = part.x;
    shape.y = part.y;
    shape.new_line = new_line;
    shapes.push_back(std::move(shape));
    matcher.match(shapes, shapes.size() - 1, part.pixels);
    if (worth != nullptr) {
      worth->add(shapes.back());
      if (worth->hopeless()) return {};
    }
  }
  if (worth != nullptr && !worth->enough()) shapes.clear();
  return shapes;
}

}  // namespace

std::vector<PlacedShape> match_shapes(const Bitmap& ink, std::int32_t first_row,
                                      std::int32_t rows) {
  return match(ink, first_row, rows, nullptr);
}

std::vector<PlacedShape> find_shapes(const Bitmap& ink, std::int32_t first_row,
                                     std::int32_t rows, std::uint64_t least) {
  Worth worth{least};
  return match(ink, first_row, rows, &worth);
}

}  // namespace unstep::codec
