#include "codec/deep_shape_sequence.h"

#include "codec/context.h"

namespace unstep::codec {
namespace {

std::uint64_t look_of(const ShapeFact& fact) {
  return std::uint64_t{fact.klass} * 2 + (fact.new_line ? 1 : 0);
}

}  // namespace

// 14 fields of 72 nodes, or of 16 lengths, or of 16 places on a line ...
const DeepShapeSequence::Model::Choice DeepShapeSequence::kSizes{
    {1024, 256, 256, 1024, 1024, 32}, {1024, 256}, 16};

DeepShapeSequence::DeepShapeSequence(std::int32_t width,
                                     std::int32_t /*height*/)
    : ShapeHistory(width),
      model_(kTableBits, kSizes),
      matches_{Match{2, std::vector<std::uint32_t>(1U << kHeadBits)},
               Match{5, std::vector<std::uint32_t>(1U << kHeadBits)}} {}

std::uint64_t DeepShapeSequence::memory(std::int32_t width,
                                        std::int32_t /*height*/) {
  return Model::memory(kTableBits, kSizes) + ShapeHistory::memory(width) +
         (std::uint64_t{2 * sizeof(std::uint32_t)} << kHeadBits);
}

void DeepShapeSequence::push(Match& match) {
  if (match.length > 0) {
    const bool same = look_of(fact(match.at)) == look_of(last(0));
    match.length = same ? match.length + 1 : 0;
    ++match.at;
  }
  if (count() < match.minimum) return;
  std::uint64_t hash = 0;
  for (std::uint32_t k = 0; k < match.minimum; ++k) {
    hash = mix(hash, look_of(last(k)));
  }
  std::uint32_t& head = match.heads[hash * kGolden >> (64 - kHeadBits)];
  if (match.length == 0 && head != 0 && count() - head < kFacts / 2) {
    std::uint32_t same = 0;
    while (same < 32 && same + 1 < head &&
           look_of(fact(head - 1 - same)) == look_of(last(same))) {
      ++same;
    }
    match.at = head;
    match.length = same < match.minimum ? 0 : same;
  }
  head = count() + 1;
}

void DeepShapeSequence::remember(const ShapeFact& fact) {
  ShapeHistory::remember(fact);
  for (Match& match : matches_) push(match);
}

/// What a match says of a field.
std::uint64_t DeepShapeSequence::foretold(Field field,
                                          const Match& match) const {
  if (match.length == 0) return 0;
  const ShapeFact& next = fact(match.at);
  const std::uint64_t same = next.klass == klass() ? 1 : 0;
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
  const std::uint64_t klass = this->klass();
  const std::uint64_t first = bits_of(right_to(0));
  return {bits_of(from()),
          first,
          mix(first, bits_of(right_to(1))),
          mix(mix(klass, first), above(0).klass),
          mix(klass, mix(a.klass, bits_of(a.gap))),
          mix(bits_of(a.gap), mix(bits_of(b.gap), bits_of(last(2).gap))),
          mix(klass, mix(bits_of(a.rise), bits_of(a.height))),
          mix(klass, word()),
          mix(pen().in_line, bits_of(a.width)),
          mix(bits_of(a.gap), bits_of(a.width))};
}

DeepShapeSequence::More DeepShapeSequence::more_of_rise() const {
  const ShapeFact& a = last(0);
  const ShapeFact& b = last(1);
  const std::uint64_t klass = this->klass();
  const std::uint64_t gap = bits_of(this->gap());
  return {bits_of(pen().base),
          mix(bits_of(pen().line_base), gap),
          mix(klass, gap),
          mix(id(), bits_of(a.rise)),
          mix(bits_of(a.rise), mix(bits_of(b.rise), bits_of(last(2).rise))),
          mix(klass, mix(a.klass, bits_of(a.rise))),
          mix(klass, mix(bits_of(a.rise), bits_of(b.rise))),
          mix(bits_of(up_to(0)), bits_of(above(0).rise)),
          mix(pen().in_line, bits_of(a.rise)),
          mix(klass, word())};
}

DeepShapeSequence::More DeepShapeSequence::more_of_others(Field field) const {
  const ShapeFact& a = last(0);
  const ShapeFact& b = last(1);
  const ShapeFact& c = last(2);
  const ShapeFact& over = above(0);
  const std::uint64_t step = bits_of(right_to(0));
  const std::uint64_t klass =
      field == kClass || field == kSide ? 0 : this->klass();
  More values{mix(a.klass, mix(b.klass, c.klass)),
              mix(mix(a.klass, b.klass), mix(c.klass, last(3).klass)),
              word(),
              mix(word(), last_word()),
              mix(step, over.klass),
              mix(over.klass, a.klass),
              mix(b.klass, c.klass),
              mix(pen().in_line, line_class()),
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
  const std::uint64_t told = kind() * 2 + refers();
  for (const Match& match : matches_) add(mix(foretold(field, match), told));
  for (const std::uint64_t value : field == kGap    ? more_of_gap()
                                   : field == kRise ? more_of_rise()
                                                    : more_of_others(field)) {
    add(mix(value, told));
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
                     (field * 16U + pen().in_line) * 4 + kind(),
                     (field * std::size_t{3} + kind()) * 24 + size,
                     field * 2U + (node > 64 ? 1U : 0U)};
  choice_.refined = {name, length(0)};
  choice_.last = field;
}

}  // namespace unstep::codec
