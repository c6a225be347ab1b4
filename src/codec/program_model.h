#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "codec/decision_model.h"
#include "codec/number_model.h"
#include "codec/program_coder.h"
#include "codec/program_history.h"
#include "codec/program_number_model.h"
#include "codec/program_predictors.h"

namespace unstep::codec {

/// Predicts the lines of a program: whether one is a motion; of motions the
/// words and their numbers; of others the bytes.
class ProgramModel {
 public:
  static constexpr std::size_t kWordContexts = 9;
  static constexpr std::size_t kTextContexts = 6;
  using WordDecisions = DecisionModel<kWordContexts>;
  using TextDecisions = DecisionModel<kTextContexts>;

  explicit ProgramModel(std::uint64_t lines);

  /// False if the decoded frame cannot be.
  template <class Coder>
  bool code_frame(Coder& coder, const ProgramFrame& frame) {
    for (std::size_t word = 0; word < kProgramWords; ++word) {
      const bool used = coder.code((frame.words >> word & 1) != 0, 32768);
      if (used) frame_.words |= 1U << word;
    }
    std::uint32_t groups = 0;  // that occur
    for (std::size_t word = 0; word < kProgramWords; ++word) {
      if ((frame_.words >> word & 1) != 0) groups |= 1U << program_group(word);
    }
    for (std::size_t group = 0; group < frame.decimals.size(); ++group) {
      if ((groups >> group & 1) == 0) continue;
      int decimals = 0;
      for (int bit = 2; bit >= 0; --bit) {
        const bool one =
            coder.code((frame.decimals[group] >> bit & 1) != 0, 32768);
        decimals = 2 * decimals + (one ? 1 : 0);
      }
      frame_.decimals[group] = decimals;
    }
    set_units();
    return true;
  }

  /// Whether the next line is a motion.
  template <class Coder>
  bool code_kind(Coder& coder, bool motion) {
    set_word_contexts(0, 0, 0, {});
    return decide(coder, motion, 0);
  }

  /// A motion. False if the numbers decoded are beyond their range.
  template <class Coder>
  bool code_motion(Coder& coder, ProgramLine& line) {
    begin_motion();
    code_mode(coder, line);
    for (std::size_t axis = 0; axis < kProgramAxisWords; ++axis) {
      if (!code_word(coder, axis, line)) return false;
    }
    // The larger part of the chord tells the other coordinate of the centre.
    const bool i_first = chord_is_steep();
    const std::array<std::size_t, 6> others{
        kWordR, i_first ? kWordI : kWordJ, i_first ? kWordJ : kWordI, 12, 14,
        15};
    for (const std::size_t word : others) {
      if (!code_word(coder, word, line)) return false;
    }
    end_motion();
    return true;
  }

  /// Any other line, without its end. False once it has more than `most`
  /// bytes.
  template <class Coder>
  bool code_text(Coder& coder, std::string_view text, std::uint64_t most,
                 std::string& out) {
    out.clear();
    begin_text();
    while (true) {
      const unsigned byte = out.size() < text.size()
                                ? static_cast<unsigned char>(text[out.size()])
                                : '\n';
      const unsigned coded = code_byte(coder, byte);
      if (coded == '\n') break;
      if (out.size() == most) return false;
      out += static_cast<char>(coded);
      advance_text(out);
    }
    end_text(out);
    return true;
  }

 private:
  /// Nodes of words: 0 kind, 1..7 mode, 8.. presence.
  static constexpr std::uint32_t kMode = 1, kPresence = 8;

  template <class Coder>
  bool decide(Coder& coder, bool bit, std::uint32_t node) {
    return words_.code(coder, bit, node, {node, 64 + word_selector_});
  }

  template <class Coder>
  void code_mode(Coder& coder, ProgramLine& line) {
    set_word_contexts(1, 0, 0, {});
    if (!decide(coder, line.motion >= 0, kMode)) {
      line.motion = -1;
      return;
    }
    const bool arc = decide(coder, line.motion >= 2, kMode + 1);
    const bool odd =
        decide(coder, (line.motion & 1) != 0, kMode + 2 + (arc ? 1 : 0));
    line.motion = (arc ? 2 : 0) + (odd ? 1 : 0);
    motion_.motion = line.motion;
  }

  /// Whether the word is there, and its number.
  template <class Coder>
  bool code_word(Coder& coder, std::size_t word, ProgramLine& line) {
    if ((frame_.words >> word & 1) == 0) return true;
    const ProgramPredictions predictions = predict(word);
    set_word_contexts(2 + word, numbers_.outlook(word, predictions),
                      predictions[9] == 0 ? 1 : 0, predictions);
    const bool there = decide(coder, line.has(word),
                              kPresence + static_cast<std::uint32_t>(word));
    if (!there) {
      line.words &= ~(1U << word);
      return true;
    }
    line.words |= 1U << word;
    motion_.words |= 1U << word;
    const std::int64_t base = base_of(word);
    const std::int64_t number = line.value[word] / unit_[word] - base;
    const std::int64_t coded =
        numbers_.code(coder, number_place(word), predictions, number);
    return accept(word, coded, line);
  }

  template <class Coder>
  unsigned code_byte(Coder& coder, unsigned byte) {
    unsigned prefix = 1;
    for (int bit = 7; bit >= 0; --bit) {
      const bool one = text_.code(coder, (byte >> bit & 1) != 0, prefix,
                                  {prefix, 256 + text_selector_});
      prefix = 2 * prefix + (one ? 1 : 0);
    }
    return prefix & 255;
  }

  void set_units();
  void begin_motion();
  void end_motion();
  [[nodiscard]] ProgramPredictions predict(std::size_t word) const;
  [[nodiscard]] ProgramNumberPlace number_place(std::size_t word) const;
  /// What the number of an axis word is counted from.
  [[nodiscard]] std::int64_t base_of(std::size_t word) const;
  [[nodiscard]] bool chord_is_steep() const;
  bool accept(std::size_t word, std::int64_t number, ProgramLine& line);
  void set_word_contexts(std::size_t what, std::uint64_t outlook,
                         std::uint64_t rests,
                         const ProgramPredictions& predictions);
  void begin_text();
  void advance_text(const std::string& line);
  void end_text(const std::string& line);

  ProgramFrame frame_;
  std::array<std::int64_t, kProgramWords> unit_{};  ///< 10^-7 of each number
  WordDecisions words_;
  TextDecisions text_;
  ProgramNumberModel numbers_;
  ProgramHistory history_;
  std::array<AxisTrail, kProgramWords> trails_{};
  ProgramMotion motion_;  ///< the one that is being coded
  int mode_ = 1;          ///< in force, as far as the lines say
  bool incremental_ = false;
  bool incremental_e_ = false;
  std::uint32_t word_selector_ = 0;
  std::uint32_t kinds_ = 1;        ///< motion or not, the latest lines
  std::uint64_t text_before_ = 0;  ///< of the text line before, a hash
  std::uint32_t text_selector_ = 0;
};

}  // namespace unstep::codec
