#include "codec/deep_shape_sequence.h"

#include "codec/context.h"

namespace unstep::codec {
namespace {

constexpr std::int32_t kWideGap = 12;  ///< between words
constexpr std::int32_t kNoShape = -999;

/// Negative ones modulo 2^64.
std::uint64_t bits_of(std::int64_t value) {
  return static_cast<std::uint64_t>(value);
}
std::uint64_t look_of(const ShapeFact& fact) {
  return std::uint64_t{fact.klass} * 2 + (fact.new_line ? 1 : 0);
}

}  // namespace

// 14 fields of 72 nodes, or of 16 lengths, or of 16 places on a line ...
const DeepShapeSequence::Model::Choice DeepShapeSequence::kSizes{
    {1024, 256, 256, 1024, 1024, 32}, {1024, 256}, 16};

DeepShapeSequence::DeepShapeSequence(std::int32_t width)
    : model_(kTableBits, kSizes),
      facts_(kFacts),
      matches_{Match{2, std::vector<std::uint32_t>(1U << kHeadBits)},
               Match{5, std::vector<std::uint32_t>(1U << kHeadBits)}},
      columns_(static_cast<std::size_t>(width) + 1) {}

std::uint64_t DeepShapeSequence::memory(std::int32_t width) {
  return Model::memory(kTableBits, kSizes) + kFacts * sizeof(ShapeFact) +
         (std::uint64_t{2 * sizeof(std::uint32_t)} << kHeadBits) +
         (static_cast<std::uint64_t>(width) + 1) * sizeof(std::uint32_t);
}

void DeepShapeSequence::begin(const ShapePen& pen) {
  pen_ = pen;
  kind_ = 2;
  refers_ = klass_ = id_ = 0;
  gap_ = 0;
  find_above();
}

void DeepShapeSequence::note(Field field, std::int64_t value) {
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
void DeepShapeSequence::find_above() {
  const bool fresh = kind_ == 1;
  const std::int32_t from = fresh ? pen_.line_x : pen_.x;
  const std::int32_t base = fresh ? pen_.line_base : pen_.base;
  above_ = {};
  std::size_t found = 0;
  const auto end = std::min<std::int64_t>(
      std::int64_t{from} + 120, static_cast<std::int64_t>(columns_.size()));
  for (std::int64_t x = std::max(0, from - (fresh ? 40 : 3)); x < end; ++x) {
    const std::uint32_t other = columns_[static_cast<std::size_t>(x)];
    if (other == 0 || count_ - other >= kFacts) continue;
    const std::int64_t rise = std::int64_t{base} - fact(other).bottom;
    if (rise < (fresh ? -200 : 4) || rise > 400) continue;
    above_[found++] = other;
    if (found == above_.size()) return;
  }
}

void DeepShapeSequence::push(Match& match) {
  if (match.length > 0) {
    const bool same = look_of(fact(match.at)) == look_of(last(0));
    match.length = same ? match.length + 1 : 0;
    ++match.at;
  }
  if (count_ < match.minimum) return;
  std::uint64_t hash = 0;
  for (std::uint32_t k = 0; k < match.minimum; ++k) {
    hash = mix(hash, look_of(last(k)));
  }
  std::uint32_t& head = match.heads[hash * kGolden >> (64 - kHeadBits)];
  if (match.length == 0 && head != 0 && count_ - head < kFacts / 2) {
    std::uint32_t same = 0;
    while (same < 32 && same + 1 < head &&
           look_of(fact(head - 1 - same)) == look_of(last(same))) {
      ++same;
    }
    match.at = head;
    match.length = same < match.minimum ? 0 : same;
  }
  head = count_ + 1;
}

void DeepShapeSequence::remember(const ShapeFact& fact) {
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
  for (Match& match : matches_) push(match);
  columns_[static_cast<std::size_t>(fact.x)] = count_;
}

/// What a match says of a field.
std::uint64_t DeepShapeSequence::foretold(Field field,
                                          const Match& match) const {
  if (match.length == 0) return 0;
  const ShapeFact& next = fact(match.at);
  const std::uint64_t same = next.klass == klass_ ? 1 : 0;
  const std::uint64_t value = field == kClass  ? next.klass
                              : field == kGap  ? mix(bits_of(next.gap), same)
                              : field == kRise ? mix(bits_of(next.rise), same)
                              : field == kNewLine ? (next.new_line ? 1U : 0U)
                              : field == kRefers  ? next.klass
                                                  : bits_of(next.width);
  return mix(value, std::min(match.length, 15U));
}

DeepShapeSequence::More DeepShapeSequence::more_of_gap() const {
  const ShapeFact& a = last(0);
  const ShapeFact& b = last(1);
  const std::int32_t from = kind_ == 1 ? pen_.line_x : pen_.x;
  const auto above = [&](std::size_t k) {
    return bits_of(above_[k] == 0 ? kNoShape : fact(above_[k]).x - from);
  };
  return {bits_of(from),
          above(0),
          mix(above(0), above(1)),
          mix(mix(klass_, above(0)), fact(above_[0]).klass),
          mix(klass_, mix(a.klass, bits_of(a.gap))),
          mix(bits_of(a.gap), mix(bits_of(b.gap), bits_of(last(2).gap))),
          mix(klass_, mix(bits_of(a.rise), bits_of(a.height))),
          mix(klass_, word_),
          mix(pen_.in_line, bits_of(a.width)),
          mix(bits_of(a.gap), bits_of(a.width))};
}

DeepShapeSequence::More DeepShapeSequence::more_of_rise() const {
  const ShapeFact& a = last(0);
  const ShapeFact& b = last(1);
  const std::int32_t base = kind_ == 1 ? pen_.line_base : pen_.base;
  const std::uint64_t step = above_[0] == 0
                                 ? bits_of(kNoShape)
                                 : bits_of(fact(above_[0]).bottom - base);
  return {bits_of(pen_.base),
          mix(bits_of(pen_.line_base), bits_of(gap_)),
          mix(klass_, bits_of(gap_)),
          mix(id_, bits_of(a.rise)),
          mix(bits_of(a.rise), mix(bits_of(b.rise), bits_of(last(2).rise))),
          mix(klass_, mix(a.klass, bits_of(a.rise))),
          mix(klass_, mix(bits_of(a.rise), bits_of(b.rise))),
          mix(step, bits_of(fact(above_[0]).rise)),
          mix(pen_.in_line, bits_of(a.rise)),
          mix(klass_, word_)};
}

DeepShapeSequence::More DeepShapeSequence::more_of_others(Field field) const {
  const ShapeFact& a = last(0);
  const ShapeFact& b = last(1);
  const ShapeFact& c = last(2);
  const ShapeFact& over = fact(above_[0]);
  const std::int32_t from = kind_ == 1 ? pen_.line_x : pen_.x;
  const std::uint64_t step = bits_of(above_[0] == 0 ? kNoShape : over.x - from);
  const std::uint64_t klass = field == kClass || field == kSide ? 0 : klass_;
  More values{mix(a.klass, mix(b.klass, c.klass)),
              mix(mix(a.klass, b.klass), mix(c.klass, last(3).klass)),
              word_,
              mix(word_, last_word_),
              mix(step, over.klass),
              mix(over.klass, a.klass),
              mix(b.klass, c.klass),
              mix(pen_.in_line, line_class_),
              mix(bits_of(a.gap), a.klass),
              bits_of(a.height)};
  for (std::uint64_t& value : values) value = mix(value, klass);
  return values;
}

void DeepShapeSequence::look(Field field, const Contexts& contexts) {
  std::size_t i = 0;
  const auto add = [&](std::uint64_t value) {
    values_[i] = mix(value, std::uint64_t{field} * 64 + i);
    ++i;
  };
  for (const std::uint64_t value : contexts) add(value);
  const std::uint64_t kind = kind_ * 2 + refers_;
  for (const Match& match : matches_) add(mix(foretold(field, match), kind));
  for (const std::uint64_t value : field == kGap    ? more_of_gap()
                                   : field == kRise ? more_of_rise()
                                                    : more_of_others(field)) {
    add(mix(value, kind));
  }
}

void DeepShapeSequence::ask(std::uint64_t name) {
  for (std::size_t i = 0; i < kContexts; ++i) {
    model_.ask(i, mix(values_[i], name) * kGolden);
  }
}

void DeepShapeSequence::choose(Field field, std::uint32_t node) {
  const std::size_t name = field * kNodes + std::min(node, kNodes - 1);
  const auto length = [&](std::size_t k) {
    return field * 16U + std::min(matches_[k].length, 15U);
  };
  const std::size_t size = std::min(node < 64 ? node : 20U, 23U);
  choice_.vectors = {name,
                     length(0),
                     length(1),
                     (field * 16U + pen_.in_line) * 4 + kind_,
                     (field * std::size_t{3} + kind_) * 24 + size,
                     field * 2U + (node > 64 ? 1U : 0U)};
  choice_.refined = {name, length(0)};
  choice_.last = field;
}

}  // namespace unstep::codec
