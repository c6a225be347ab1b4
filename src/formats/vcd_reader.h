#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "unstep/codec.h"
#include "unstep/result.h"

/// Value change dumps (IEEE 1364-2005, clause 18), as simulators, logic
/// analysers and sigrok write them.
///
///     Result<VcdReader> file = VcdReader::open(text, {});
///     const Result<VcdProbe> a = file->find("top.encoder.a");
///     for (auto change = file->next(); change && *change;
///          change = file->next()) {
///       if ((*change)->net == a->net) use((*change)->time,
///       a->level(**change));
///     }
namespace unstep {

/// The new value of a net: bit i of `bits` is bit i from the right, below 64.
/// A bit of `unknown` marks x or z; the bit of `bits` is then 0.
struct VcdChange {
  std::uint64_t time = 0;  ///< in VcdReader::timescale
  std::uint32_t net = 0;
  std::uint64_t bits = 0;
  std::uint64_t unknown = 0;
};

/// One bit of one net.
struct VcdProbe {
  std::uint32_t net = 0;
  unsigned bit = 0;  ///< 0..63
  /// Nothing for x and z. REQUIRES: change.net == net.
  [[nodiscard]] std::optional<bool> level(const VcdChange& change) const {
    if ((change.unknown >> bit & 1) != 0) return std::nullopt;
    return (change.bits >> bit & 1) != 0;
  }
};

/// A variable of the header. Several may show the same net.
struct VcdSignal {
  std::string name;  ///< scopes and name, joined by points; with "[3]" if the
                     ///< file names a single bit of a vector
  std::uint32_t net = 0;
  std::uint32_t width = 1;  ///< bits; above 64 only the low 64 are given
  std::int64_t right = 0;   ///< index of the rightmost bit of a vector
};

/// 1, 10 or 100 times a power of ten of a second.
struct VcdTimescale {
  bool known = false;
  std::int32_t magnitude = 1;
  std::int32_t exponent = 0;  ///< 0, -3, ... -15
};

/// The dump change by change, in the order of the file; times never fall.
/// Reals and strings are passed over. Errors name line and column. A dump that
/// was cut off between two changes cannot be told from a whole one.
class VcdReader {
 public:
  /// Reads the header. bad_magic if the text does not begin with a VCD
  /// keyword. The text must outlive the reader. Memory grows with the number
  /// of variables only, within limits.max_memory.
  static Result<VcdReader> open(std::string_view text,
                                const DecodeLimits& limits);

  /// True if a text begins as a dump does.
  [[nodiscard]] static bool recognise(std::string_view text);

  [[nodiscard]] const std::vector<VcdSignal>& signals() const {
    return signals_;
  }
  [[nodiscard]] const VcdTimescale& timescale() const { return timescale_; }
  /// What the first $comment of the header says; empty if there is none.
  [[nodiscard]] std::string_view comment() const { return comment_; }
  /// Of the last change or time mark.
  [[nodiscard]] std::uint64_t time() const { return time_; }

  /// The bit of a name: a whole name, or its last parts ("a", "encoder.a") if
  /// they mean one net only; of a vector "bus[2]". invalid_argument if there
  /// is none or several, saying which there are.
  [[nodiscard]] Result<VcdProbe> find(std::string_view name) const;

  /// The next change; nothing at the end. After an error only destruction is
  /// allowed.
  Result<std::optional<VcdChange>> next();

 private:
  static constexpr std::uint32_t kNoNet = 0xffff'ffffU;

  explicit VcdReader(std::string_view text) : text_(text) {
    short_codes_.fill(kNoNet);
  }
  [[nodiscard]] Error error(std::size_t at, const std::string& reason,
                            ErrorCode code = ErrorCode::corrupt) const;
  std::string_view word();
  /// The words up to $end.
  Result<std::vector<std::string_view>> section(std::string_view keyword);
  Status skip_section();
  Status read_header(const DecodeLimits& limits);
  Status read_timescale();
  Status read_scope(const DecodeLimits& limits);
  Status leave_scope();
  Status read_variable(const DecodeLimits& limits);
  Status read_time(std::string_view digits);
  [[nodiscard]] std::uint32_t net_of(std::string_view code) const;
  Result<VcdChange> scalar(std::string_view word) const;
  Result<VcdChange> vector(std::string_view digits, std::string_view code);
  [[nodiscard]] std::vector<VcdProbe> matches(std::string_view name) const;

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t word_at_ = 0;          ///< of the last word
  std::vector<std::string> scopes_;  ///< joined names, outermost first
  std::vector<VcdSignal> signals_;
  std::vector<std::uint32_t> widths_;  ///< by net
  std::uint64_t memory_ = 0;
  std::array<std::uint32_t, 128> short_codes_{};  ///< nets by codes of one byte
  std::unordered_map<std::string_view, std::uint32_t> codes_;  ///< the others
  VcdTimescale timescale_;
  std::string_view comment_;
  std::uint64_t time_ = 0;
};

}  // namespace unstep
