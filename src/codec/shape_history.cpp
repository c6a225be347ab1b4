#include "codec/shape_history.h"

#include "codec/context.h"

namespace unstep::codec {
namespace {

constexpr std::int32_t kWideGap = 12;  ///< between words

}  // namespace

ShapeHistory::ShapeHistory(std::int32_t width)
    : facts_(kFacts), columns_(static_cast<std::size_t>(width) + 1) {}

std::uint64_t ShapeHistory::memory(std::int32_t width) {
  return kFacts * sizeof(ShapeFact) +
         (static_cast<std::uint64_t>(width) + 1) * sizeof(std::uint32_t);
}

void ShapeHistory::begin(const ShapePen& pen) {
  pen_ = pen;
  kind_ = 2;
  refers_ = klass_ = id_ = 0;
  gap_ = 0;
  find_above();
}

void ShapeHistory::note(std::uint8_t field, std::int64_t value) {
  switch (field) {
    case kNewLine:
      kind_ = bits_of(value);
      find_above();
      break;
    case kRefers: refers_ = bits_of(value); break;
    case kClass: klass_ = bits_of(value) + 1; break;
    case kGap: gap_ = value; break;
    default: break;
  }
}

/// The first shapes that begin to the right and stand above.
void ShapeHistory::find_above() {
  const bool fresh = kind_ == 1;
  const std::int32_t from = this->from();
  above_ = {};
  std::size_t found = 0;
  const auto end = std::min<std::int64_t>(
      std::int64_t{from} + 120, static_cast<std::int64_t>(columns_.size()));
  for (std::int64_t x = std::max(0, from - (fresh ? 40 : 3)); x < end; ++x) {
    const std::uint32_t other = columns_[static_cast<std::size_t>(x)];
    if (other == 0 || count_ - other >= kFacts) continue;
    const std::int64_t rise = std::int64_t{base()} - fact(other).bottom;
    if (rise < (fresh ? -200 : 4) || rise > 400) continue;
    above_[found++] = other;
    if (found == above_.size()) return;
  }
}

void ShapeHistory::remember(const ShapeFact& fact) {
  ++count_;
  facts_[count_ % kFacts] = fact;
  if (fact.new_line) {
    word_ = 0;
    line_class_ = fact.klass;
  } else if (fact.gap > kWideGap) {
    last_word_ = word_;
    word_ = 0;
  }
  word_ = mix(word_, fact.klass);
  columns_[static_cast<std::size_t>(fact.x)] = count_;
}

}  // namespace unstep::codec
