#include "codec/program_model.h"

#include <algorithm>
#include <cstdlib>

#include "codec/context.h"

namespace unstep::codec {
namespace {

template <class Model, std::size_t kContexts>
constexpr std::array<typename Model::Weights, 1> make_initial() {
  typename Model::Weights weights{};
  for (std::size_t i = 0; i < 2 * kContexts; ++i) {
    weights[i] = 4096 * 14 / 10 / kContexts;
  }
  return {weights};
}
constexpr auto kWordInitial =
    make_initial<ProgramModel::WordDecisions, ProgramModel::kWordContexts>();
constexpr auto kTextInitial =
    make_initial<ProgramModel::TextDecisions, ProgramModel::kTextContexts>();

std::int64_t kept(std::int64_t value) {
  return std::clamp(value, -kMaxProgramNumber, kMaxProgramNumber);
}

/// Whether the line has this word of G or M, such as "G91".
bool says(std::string_view line, std::string_view word) {
  for (std::size_t at = line.find(word); at != std::string_view::npos;
       at = line.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const char next = end < line.size() ? line[end] : ' ';
    if (next != '.' && (next < '0' || next > '9')) return true;
  }
  return false;
}

}  // namespace

ProgramModel::ProgramModel(std::uint64_t lines)
    : words_(program_table_bits(lines) - 2, kWordInitial),
      text_(program_table_bits(lines) - 2, kTextInitial),
      numbers_(program_table_bits(lines)) {}

void ProgramModel::set_units() {
  for (std::size_t word = 0; word < kProgramWords; ++word) {
    unit_[word] = 1;
    for (int i = frame_.decimals[program_group(word)]; i < kMaxProgramDecimals;
         ++i) {
      unit_[word] *= 10;
    }
  }
}

void ProgramModel::begin_motion() {
  motion_ = ProgramMotion();
  motion_.motion = mode_;
  motion_.from = motion_.to = history_.at();
  numbers_.begin();
}

void ProgramModel::end_motion() {
  mode_ = motion_.motion;
  for (std::size_t axis = 0; axis < kProgramAxisWords; ++axis) {
    if ((frame_.words >> axis & 1) != 0) {
      trails_[axis].push(motion_.delta(axis));
    }
  }
  history_.push(motion_);
  kinds_ = (kinds_ << 1 | 1U) & 0xff;
}

ProgramPredictions ProgramModel::predict(std::size_t word) const {
  const ProgramContext context{history_, motion_};
  const AxisTrail& trail = trails_[word];
  if (word < kProgramAxisWords) return predict_axis(context, word, trail);
  if (word == kWordI || word == kWordJ) {
    const std::size_t other = word == kWordI ? kWordJ : kWordI;
    return predict_centre(context, word, motion_.has(other), trail);
  }
  return predict_word(context, word, trail);
}

ProgramNumberPlace ProgramModel::number_place(std::size_t word) const {
  return {word, &trails_[word], history_.by_vectors().length,
          history_.by_places().length};
}

std::int64_t ProgramModel::base_of(std::size_t word) const {
  if (word >= kProgramAxisWords) return 0;
  const bool incremental = word == kWordE ? incremental_e_ : incremental_;
  return incremental ? 0 : motion_.from[word];
}

bool ProgramModel::chord_is_steep() const {
  return std::abs(motion_.delta(1)) >= std::abs(motion_.delta(0));
}

bool ProgramModel::accept(std::size_t word, std::int64_t number,
                          ProgramLine& line) {
  const std::int64_t value = number + base_of(word);
  if (std::abs(value) > kMaxProgramNumber / unit_[word]) return false;
  line.value[word] = value * unit_[word];
  motion_.value[word] = value;
  if (word < kProgramAxisWords) {
    motion_.to[word] = kept(motion_.from[word] + number);
  } else {
    trails_[word].push(value);
  }
  return true;
}

/// `what`: 0 the kind of the line, 1 its mode, 2.. whether it has a word.
void ProgramModel::set_word_contexts(std::size_t what, std::uint64_t outlook,
                                     std::uint64_t rests,
                                     const ProgramPredictions& predictions) {
  const ProgramMotion& last = history_.before(1);
  const ProgramMotion& second = history_.before(2);
  const ProgramGuess vectors = history_.by_vectors();
  const ProgramGuess places = history_.by_places();
  // Of text lines since the last motion and of modes in the same order.
  const auto look = [what](const ProgramMotion* motion) -> std::uint64_t {
    if (motion == nullptr) return 9;
    return what < 2 ? static_cast<std::uint64_t>(motion->motion)
                    : motion->words;
  };
  const bool rested = last.to == last.from;
  const std::uint64_t now =
      mix(what | static_cast<std::uint64_t>(motion_.motion) << 8 |
              (kinds_ & 3) << 12,
          motion_.words);
  WordDecisions::Values values{};
  values[0] = now;
  values[1] =
      mix(now, mix(last.words, static_cast<std::uint64_t>(last.motion)));
  values[2] = mix(now, mix(mix(last.words, second.words),
                           mix(history_.before(3).words, kinds_)));
  values[3] = mix(now, mix(look(vectors.next), length_class(vectors.length)));
  values[4] = mix(now, mix(look(places.next), length_class(places.length)));
  values[5] = mix(what, mix(outlook, rests));
  values[6] = mix(now, mix(outlook >> 6, last.words));
  values[7] = mix(now, mix(rested ? 1 : 2, mix(last.words, second.words)));
  values[8] =
      mix(mix(what, text_before_),
          mix(kinds_ & 15, what < 2 ? 0
                                    : (predictions[8] == 0 ? 1U : 0U) |
                                          (predictions[10] == 0 ? 2U : 0U)));
  words_.set_contexts(values);
  word_selector_ = static_cast<std::uint32_t>(
      what * 32 + (rested ? 16 : 0) + (last.words >> what >> 1 & 1) * 8 +
      length_class(places.length));
}

void ProgramModel::begin_text() { advance_text({}); }

void ProgramModel::advance_text(const std::string& line) {
  const std::size_t n = line.size();
  const auto byte = [&](std::size_t back) -> std::uint64_t {
    return back <= n ? static_cast<unsigned char>(line[n - back]) : 0;
  };
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const char c = line[i];
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    word = letter ? mix(word + 1, static_cast<unsigned char>(c)) : 0;
  }
  TextDecisions::Values values{};
  values[0] = byte(1);
  values[1] = byte(1) | byte(2) << 8 | 1U << 30;
  values[2] = byte(1) | byte(2) << 8 | byte(3) << 16 | std::uint64_t{1} << 31;
  values[3] = mix(byte(1) | byte(2) << 8 | byte(3) << 16 | byte(4) << 24, 5);
  values[4] = mix(mix(text_before_, std::min<std::size_t>(n, 255)), byte(1));
  values[5] = mix(word, byte(1));
  text_.set_contexts(values);
  text_selector_ = static_cast<std::uint32_t>(byte(1));
}

void ProgramModel::end_text(const std::string& line) {
  kinds_ = kinds_ << 1 & 0xff;
  text_before_ = 1;
  for (const char c : line) {
    text_before_ = mix(text_before_, static_cast<unsigned char>(c));
  }
  if (says(line, "G91")) incremental_ = incremental_e_ = true;
  if (says(line, "G90")) incremental_ = incremental_e_ = false;
  if (says(line, "M83")) incremental_e_ = true;
  if (says(line, "M82")) incremental_e_ = false;
}

}  // namespace unstep::codec
