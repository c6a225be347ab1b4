#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <new>
#include <utility>

#include "formats/decimal.h"
#include "formats/pulse_chain.h"
#include "formats/vcd_reader.h"

namespace unstep {
namespace {

constexpr std::size_t kIllegalNamed = 3;

/// The name's last part in small letters and digits: "top.X_A" is "xa" too.
std::string plain(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') {
      out += static_cast<char>(c - 'A' + 'a');
    } else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      out += c;
    }
  }
  return out;
}

/// "top.x.a" is known as "topxa", "xa" and "a".
bool is_called(std::string_view name, std::string_view wanted) {
  for (;;) {
    if (plain(name) == wanted) return true;
    const std::size_t point = name.find('.');
    if (point == std::string_view::npos) return false;
    name.remove_prefix(point + 1);
  }
}

/// Nothing unless each is there, and once.
std::vector<std::size_t> find_usual(const std::vector<std::string>& names,
                                    std::span<const std::string_view> usual) {
  std::vector<std::size_t> found;
  for (const std::string_view wanted : usual) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!is_called(names[i], wanted)) continue;
      ++count;
      found.push_back(i);
    }
    if (count != 1) return {};
  }
  return found;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    std::string name = names[i].substr(0, 40);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c < ' '; }, '?');
    text += (i == 0 ? "" : ", ") + name;
  }
  return text + (names.size() > kMost ? ", ..." : "");
}

/// A name, or the number of a column.
Result<std::size_t> find_one(const std::vector<std::string>& names,
                             const std::string& wanted) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == wanted) found.push_back(i);
  }
  if (found.size() == 1) return found[0];
  std::size_t number = 0;
  const char* end = wanted.data() + wanted.size();
  const auto [stop, failed] = std::from_chars(wanted.data(), end, number);
  if (found.empty() && failed == std::errc{} && stop == end && number >= 1 &&
      number <= names.size()) {
    return number - 1;
  }
  return Error{ErrorCode::invalid_argument,
               (found.empty() ? "no channel '" : "several channels '") +
                   wanted + "'; there are " + listed(names)};
}

Result<VectorPage> read_raw(std::span<const std::uint8_t> bytes, unsigned bits,
                            const PulseReadOptions& options) {
  PulseChain chain(options, bits);
  for (const std::uint8_t byte : bytes) {
    for (unsigned shift = 8; shift > 0;) {
      shift -= bits;
      // A is the higher bit of each pair, x the higher pair.
      const unsigned x = byte >> (shift + bits - 2) & 3U;
      const unsigned y = bits == 4 ? byte >> shift & 3U : 0U;
      const auto swapped = [](unsigned v) { return v >> 1 | (v & 1) << 1; };
      const Result<bool> illegal = chain.sample(swapped(x) | swapped(y) << 2);
      if (!illegal) return illegal.error();
      if (*illegal) {
        chain.note_illegal("sample " + std::to_string(chain.samples()));
      }
    }
  }
  return chain.finish(bits == 2 ? "raw2" : "raw4");
}

}  // namespace

Result<bool> PulseChain::sample(unsigned levels, unsigned known) {
  if (++samples_ > limits_.max_steps) {
    return Error{ErrorCode::limit_exceeded,
                 "more than the limit of " + std::to_string(limits_.max_steps) +
                     " samples"};
  }
  int dx = 0;
  int dy = 0;
  bool illegal = false;
  if ((known & 3U) == 3U) {
    dx = x_.sample((levels & kXA) != 0, (levels & kXB) != 0);
    illegal = x_.is_illegal();
    illegal_ += illegal ? 1U : 0U;
  }
  if (has_y_ && (known & 12U) == 12U) {
    dy = y_.sample((levels & kYA) != 0, (levels & kYB) != 0);
    illegal_ += y_.is_illegal() ? 1U : 0U;
    illegal = illegal || y_.is_illegal();
  }
  if (dx != 0 || dy != 0) {
    if (Status done = step(dx, dy); !done) return done.error();
  }
  return illegal;
}

Status PulseChain::step(int dx, int dy) {
  // By (dy + 1) * 3 + dx + 1; the middle is no step.
  constexpr std::array<Step, 9> kSteps{5, 6, 7, 4, 0, 0, 3, 2, 1};
  at_ = {at_.x + dx, at_.y + dy};
  if (std::max(std::abs(at_.x), std::abs(at_.y)) > kMaxCoord) {
    return Error{ErrorCode::out_of_range,
                 "the counts leave the range of -" + std::to_string(kMaxCoord) +
                     " to " + std::to_string(kMaxCoord)};
  }
  if (steps_.size() == steps_.capacity() &&
      steps_.size() > limits_.max_memory / 3) {  // old and doubled new
    return Error{ErrorCode::limit_exceeded,
                 "more than the memory limit of " +
                     std::to_string(limits_.max_memory) + " bytes"};
  }
  x_counts_ += dx != 0 ? 1U : 0U;
  y_counts_ += dy != 0 ? 1U : 0U;
  diagonal_ = diagonal_ || (dx != 0 && dy != 0);
  steps_.push_back(kSteps[static_cast<std::size_t>((dy + 1) * 3 + dx + 1)]);
  return {};
}

void PulseChain::note_illegal(const std::string& when) {
  if (first_illegal_.size() < kIllegalNamed) first_illegal_.push_back(when);
}

VectorPage PulseChain::finish(std::string_view format) {
  VectorPage page;
  page.drawing.canvas = {0, 0, YAxis::up};
  std::string told = std::string(format) + ", x" + std::to_string(counts_) +
                     ", " + std::to_string(samples_) + " samples, " +
                     std::to_string(x_counts_) + " counts of x";
  if (has_y_) told += ", " + std::to_string(y_counts_) + " of y";
  told += ", " + std::to_string(illegal_) + " illegal transitions";
  page.info.metadata.emplace_back("unstep:pulses", told);
  if (illegal_ > 0) {
    std::string when;
    for (const std::string& one : first_illegal_) {
      when += (when.empty() ? "" : ", ") + one;
    }
    page.notes.push_back(
        std::to_string(illegal_) +
        (illegal_ == 1 ? " illegal transition" : " illegal transitions") +
        " (both channels of an encoder at once, not counted): " + when +
        (illegal_ > first_illegal_.size() ? ", ..." : ""));
  }
  page.notes.emplace_back("times between the counts not kept");
  page.drawing.chains.push_back(
      {{0, 0},
       diagonal_ ? Connectivity::eight : Connectivity::four,
       false,
       std::move(steps_)});
  return page;
}

Result<std::vector<std::size_t>> choose_channels(
    const std::vector<std::string>& names,
    const std::vector<std::string>& wanted) {
  if (!wanted.empty()) {
    if (wanted.size() != 2 && wanted.size() != 4) {
      return Error{ErrorCode::invalid_argument,
                   "two channels or four are needed, not " +
                       std::to_string(wanted.size())};
    }
    std::vector<std::size_t> chosen;
    for (const std::string& name : wanted) {
      const Result<std::size_t> one = find_one(names, name);
      if (!one) return one.error();
      chosen.push_back(*one);
    }
    return chosen;
  }
  using Names = std::span<const std::string_view>;
  constexpr std::array<std::string_view, 4> kFour{"xa", "xb", "ya", "yb"};
  constexpr std::array<std::string_view, 2> kTwo{"a", "b"};
  for (const Names usual : {Names(kFour), Names(kFour).first(2), Names(kTwo)}) {
    std::vector<std::size_t> found = find_usual(names, usual);
    if (!found.empty()) return found;
  }
  if (names.size() == 2) return std::vector<std::size_t>{0, 1};
  if (names.size() == 4) return std::vector<std::size_t>{0, 1, 2, 3};
  return Error{ErrorCode::invalid_argument,
               names.size() < 2
                   ? "fewer than two channels"
                   : "which channels are A and B is not clear; name them "
                     "(--channels A,B); there are " +
                         listed(names)};
}

std::string time_text(double seconds) {
  constexpr std::array<std::pair<double, const char*>, 5> kUnits{
      {{1, " s"}, {1e-3, " ms"}, {1e-6, " us"}, {1e-9, " ns"}, {1e-12, " ps"}}};
  for (const auto& [unit, name] : kUnits) {
    if (seconds < unit && unit > 1e-12) continue;
    std::string text;
    append_real(text, std::min(seconds / unit, 9e15), 9);
    return text + name;
  }
  return "";
}

Result<VectorPage> read_pulses(std::span<const std::uint8_t> bytes,
                               PulseFormat format,
                               const PulseReadOptions& options) {
  if (options.counts != 1 && options.counts != 2 && options.counts != 4) {
    return Error{ErrorCode::invalid_argument, "counts of a cycle: 1, 2 or 4"};
  }
  if ((options.low != 0 || options.high != 0) &&
      !(options.low < options.high)) {
    return Error{ErrorCode::invalid_argument,
                 "the low level must be below the high one"};
  }
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                              bytes.size());
  try {
    switch (format) {
      case PulseFormat::csv: return read_pulse_csv(text, options);
      case PulseFormat::vcd: return read_pulse_vcd(text, options);
      case PulseFormat::sigrok: return read_pulse_sigrok(bytes, options);
      case PulseFormat::raw2: return read_raw(bytes, 2, options);
      case PulseFormat::raw4: return read_raw(bytes, 4, options);
    }
    return Error{ErrorCode::invalid_argument, "no such format of pulses"};
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the steps"};
  }
}

std::optional<PulseFormat> recognise_pulses(
    std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                              bytes.size());
  if (VcdReader::recognise(text)) return PulseFormat::vcd;
  if (is_sigrok(bytes)) return PulseFormat::sigrok;
  return std::nullopt;
}

}  // namespace unstep
