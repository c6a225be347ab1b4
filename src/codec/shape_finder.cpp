#include "codec/shape_finder.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "grid/bit_count.h"

namespace unstep::codec {
namespace {

struct Run {
  std::int32_t first;
  std::int32_t end;
  std::uint32_t label;
};

/// Calls `take(first, end)` for each run of ink of a row.
template <class Take>
void for_each_run(std::span<const std::uint64_t> row, Take take) {
  std::int32_t first = -1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    // Bits that differ from the one before them.
    const std::uint64_t before =
        row[i] >> 1 | (first >= 0 ? std::uint64_t{1} << 63 : 0);
    std::uint64_t edges = row[i] ^ before;
    while (edges != 0) {
      const int bit = std::countl_zero(edges);
      edges &= ~(std::uint64_t{1} << (63 - bit));
      const auto x = static_cast<std::int32_t>(i * 64) + bit;
      if (first < 0) {
        first = x;
      } else {
        take(first, x);
        first = -1;
      }
    }
  }
  if (first >= 0) take(first, static_cast<std::int32_t>(row.size() * 64));
}

/// Components in the making: a forest of labels.
class Labels {
 public:
  std::uint32_t open(std::int32_t y, std::int32_t first) {
    const auto label = static_cast<std::uint32_t>(parents_.size());
    parents_.push_back(label);
    parts_.push_back({first, y, first, y, 0, first});
    return label;
  }
  std::uint32_t root(std::uint32_t label) {
    while (parents_[label] != label) {
      parents_[label] = parents_[parents_[label]];
      label = parents_[label];
    }
    return label;
  }
  std::uint32_t join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return a;
    if (b < a) std::swap(a, b);  // the older one has the top row and the seed
    Component& whole = parts_[a];
    const Component& part = parts_[b];
    whole.x = std::min(whole.x, part.x);
    whole.right = std::max(whole.right, part.right);
    whole.bottom = std::max(whole.bottom, part.bottom);
    whole.pixels += part.pixels;
    parents_[b] = a;
    return a;
  }
  void extend(std::uint32_t label, std::int32_t y, std::int32_t first,
              std::int32_t end) {
    Component& part = parts_[label];
    part.x = std::min(part.x, first);
    part.right = std::max(part.right, end);
    part.bottom = y + 1;
    part.pixels += end - first;
  }
  [[nodiscard]] std::size_t size() const { return parts_.size(); }

  std::vector<Component> roots() {
    std::vector<Component> found;
    for (std::uint32_t label = 0; label < parts_.size(); ++label) {
      if (parents_[label] == label) found.push_back(parts_[label]);
    }
    return found;
  }

 private:
  std::vector<std::uint32_t> parents_;
  std::vector<Component> parts_;
};

}  // namespace

std::vector<Component> find_components(const Bitmap& ink,
                                       std::int32_t first_row,
                                       std::int32_t rows, std::size_t most) {
  Labels labels;
  std::vector<Run> above;
  std::vector<Run> here;
  for (std::int32_t y = 0; y < rows; ++y) {
    here.clear();
    std::size_t next = 0;  // the first run above that may still touch
    for_each_run(ink.row(first_row + y),
                 [&](std::int32_t first, std::int32_t end) {
                   while (next < above.size() && above[next].end < first)
                     ++next;
                   std::uint32_t label = 0;
                   bool known = false;
                   for (std::size_t i = next;
                        i < above.size() && above[i].first <= end; ++i) {
                     label = known ? labels.join(label, above[i].label)
                                   : labels.root(above[i].label);
                     known = true;
                   }
                   if (!known) label = labels.open(y, first);
                   labels.extend(label, y, first, end);
                   here.push_back({first, end, label});
                 });
    std::swap(above, here);
    if (labels.size() > most) return {};
  }
  return labels.roots();
}

Glyph cut_out(const Bitmap& ink, std::int32_t first_row,
              const Component& component) {
  Glyph box(component.width(), component.height());
  const auto shift = static_cast<unsigned>(component.x) % 64;
  const auto first = static_cast<std::size_t>(component.x) / 64;
  const auto used = static_cast<unsigned>(box.width) % 64;
  const std::uint64_t mask =
      used == 0 ? ~std::uint64_t{0} : ~std::uint64_t{0} << (64 - used);
  std::int64_t pixels = 0;
  for (std::int32_t y = 0; y < box.height; ++y) {
    const auto from = ink.row(first_row + component.y + y);
    for (std::size_t i = 0; i < box.stride(); ++i) {
      const std::uint64_t low =
          first + i + 1 < from.size() ? from[first + i + 1] : 0;
      box.row(y)[i] = from[first + i] << shift | low >> 1 >> (63 - shift);
    }
    box.row(y)[box.stride() - 1] &= mask;
    for (std::size_t i = 0; i < box.stride(); ++i) {
      pixels += ones(box.row(y)[i]);
    }
  }
  if (pixels == component.pixels) return box;  // nothing else in the box

  Glyph glyph(box.width, box.height);
  std::vector<std::pair<std::int32_t, std::int32_t>> open{
      {component.seed - component.x, 0}};
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    for (std::int32_t v = std::max(0, y - 1);
         v <= std::min(box.height - 1, y + 1); ++v) {
      for (std::int32_t u = std::max(0, x - 1);
           u <= std::min(box.width - 1, x + 1); ++u) {
        const std::uint64_t bit = std::uint64_t{1} << (63 - u % 64);
        std::uint64_t& left = box.row(v)[u / 64];
        if ((left & bit) == 0) continue;
        left &= ~bit;
        glyph.row(v)[u / 64] |= bit;
        open.emplace_back(u, v);
      }
    }
  }
  return glyph;
}

}  // namespace unstep::codec
