#include "formats/vcd_reader.h"

#include <algorithm>
#include <new>

#include "formats/vcd_text.h"

namespace unstep {

using vcd::parse_range;
using vcd::shown;

namespace {

/// True if `parts` is `name` or its last parts.
bool is_end_of(std::string_view parts, std::string_view name) {
  return name.ends_with(parts) && (parts.size() == name.size() ||
                                   name[name.size() - parts.size() - 1] == '.');
}

}  // namespace

bool VcdReader::recognise(std::string_view text) {
  const auto begin = std::find_if_not(text.begin(), text.end(), vcd::is_blank);
  text.remove_prefix(static_cast<std::size_t>(begin - text.begin()));
  constexpr std::array<std::string_view, 7> kFirst{
      "$date",  "$version", "$comment",       "$timescale",
      "$scope", "$var",     "$enddefinitions"};
  return std::any_of(kFirst.begin(), kFirst.end(), [text](auto keyword) {
    return text.starts_with(keyword) && (text.size() == keyword.size() ||
                                         vcd::is_blank(text[keyword.size()]));
  });
}

Result<VcdReader> VcdReader::open(std::string_view text,
                                  const DecodeLimits& limits) {
  if (!recognise(text)) {
    return Error{ErrorCode::bad_magic, "does not begin as a VCD file does"};
  }
  try {
    VcdReader reader(text);
    if (Status read = reader.read_header(limits); !read) return read.error();
    return reader;
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the variables"};
  }
}

/// Line and column are looked for only when there is an error to tell.
Error VcdReader::error(std::size_t at, const std::string& reason,
                       ErrorCode code) const {
  const std::string_view before = text_.substr(0, at);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::size_t column =
      newline == std::string_view::npos ? at + 1 : at - newline;
  return {code, "line " + std::to_string(line) + ", column " +
                    std::to_string(column) + ": " + reason};
}

/// Empty at the end.
std::string_view VcdReader::word() {
  std::size_t at = position_;
  while (at < text_.size() && vcd::is_blank(text_[at])) ++at;
  word_at_ = at;
  while (at < text_.size() && !vcd::is_blank(text_[at])) ++at;
  position_ = at;
  return text_.substr(word_at_, at - word_at_);
}

Status VcdReader::skip_section() {
  const std::size_t begin = word_at_;
  for (std::string_view next = word(); next != "$end"; next = word()) {
    if (next.empty()) {
      return error(begin, "no $end after it", ErrorCode::truncated);
    }
  }
  return {};
}

std::uint32_t VcdReader::net_of(std::string_view code) const {
  if (code.size() == 1 && static_cast<unsigned char>(code[0]) < 128) {
    return short_codes_[static_cast<unsigned char>(code[0])];
  }
  const auto found = codes_.find(code);
  return found == codes_.end() ? kNoNet : found->second;
}

std::vector<VcdProbe> VcdReader::matches(std::string_view name) const {
  std::vector<VcdProbe> probes;
  const auto add = [&probes](std::uint32_t net, std::uint64_t bit) {
    if (bit > 63) return;
    const VcdProbe probe{net, static_cast<unsigned>(bit)};
    const bool is_new = std::none_of(
        probes.begin(), probes.end(), [&probe](const VcdProbe& known) {
          return known.net == probe.net && known.bit == probe.bit;
        });
    if (is_new && probes.size() < 2) probes.push_back(probe);
  };
  const std::size_t bracket = name.rfind('[');
  bool indexed = false;  // whether the name is that of a bit of a vector
  std::int64_t index = 0;
  if (bracket != std::string_view::npos) {
    const std::optional<vcd::Range> range = parse_range(name.substr(bracket));
    indexed = range && range->left == range->right;
    if (indexed) index = range->left;
  }
  for (const bool whole : {true, false}) {
    for (const VcdSignal& signal : signals_) {
      const auto fits = [&](std::string_view wanted) {
        return whole ? wanted == signal.name : is_end_of(wanted, signal.name);
      };
      if (fits(name)) {
        if (signal.width == 1) add(signal.net, 0);
      } else if (indexed && signal.width > 1 && fits(name.substr(0, bracket))) {
        const std::int64_t bit = std::abs(index - signal.right);
        if (bit < signal.width)
          add(signal.net, static_cast<std::uint64_t>(bit));
      }
    }
    if (!probes.empty()) break;
  }
  return probes;
}

Result<VcdProbe> VcdReader::find(std::string_view name) const {
  const std::vector<VcdProbe> probes = matches(name);
  if (probes.size() == 1) return probes[0];
  if (probes.size() > 1) {
    return Error{ErrorCode::invalid_argument,
                 shown(name) + " names several signals; give the whole name"};
  }
  constexpr std::size_t kMost = 8;
  std::string known;
  for (std::size_t i = 0; i < std::min(signals_.size(), kMost); ++i) {
    const std::string_view all = signals_[i].name;
    known += (i == 0 ? " (there are " : ", ") + shown(all);
    if (signals_[i].width > 1) {
      known += " of " + std::to_string(signals_[i].width) + " bits";
    }
  }
  if (signals_.size() > kMost) known += ", ...";
  return Error{ErrorCode::invalid_argument,
               "no signal of one bit is named " + shown(name) +
                   (known.empty() ? "" : known + ")")};
}

Status VcdReader::read_time(std::string_view digits) {
  std::uint64_t time = 0;
  if (!parse_whole(digits, time)) {
    return error(word_at_, "#" + std::string(digits.substr(0, 24)) +
                               " is no time of 0 to 2^64 - 1");
  }
  if (time < time_) {
    return error(word_at_, "time goes back from " + std::to_string(time_) +
                               " to " + std::to_string(time));
  }
  time_ = time;
  return {};
}

Result<VcdChange> VcdReader::scalar(std::string_view word) const {
  const std::uint32_t net = net_of(word.substr(1));
  if (net == kNoNet) {
    return error(word_at_, "no $var has the code " + shown(word.substr(1)));
  }
  const bool known = word[0] == '0' || word[0] == '1';
  return VcdChange{time_, net, word[0] == '1' ? 1U : 0U, known ? 0U : 1U};
}

/// A vector is filled up on the left with 0, or with x or z if that is its
/// first digit (IEEE 1364-2005, table 18-3).
Result<VcdChange> VcdReader::vector(std::string_view digits,
                                    std::string_view code) {
  const std::uint32_t net = net_of(code);
  if (net == kNoNet) {
    return error(word_at_, "no $var has the code " + shown(code));
  }
  while (digits.size() > widths_[net] && digits[0] == '0') {
    digits.remove_prefix(1);
  }
  if (digits.size() > widths_[net]) {
    return error(word_at_, "a value of " + std::to_string(digits.size()) +
                               " bits for " + std::to_string(widths_[net]));
  }
  VcdChange change{time_, net, 0, 0};
  if (!digits.empty() && digits[0] != '0' && digits[0] != '1') {
    change.unknown = ~std::uint64_t{0};
  }
  for (const char digit : digits) {
    constexpr std::string_view kDigits = "01xXzZ";
    if (kDigits.find(digit) == std::string_view::npos) {
      return error(word_at_, "a vector of other digits than 0, 1, x and z");
    }
    const bool known = digit == '0' || digit == '1';
    change.bits = change.bits << 1 | (digit == '1' ? 1U : 0U);
    change.unknown = change.unknown << 1 | (known ? 0U : 1U);
  }
  if (const std::uint32_t width = widths_[net]; width < 64) {
    change.unknown &= (std::uint64_t{1} << width) - 1;
  }
  return change;
}

Result<std::optional<VcdChange>> VcdReader::next() {
  for (;;) {
    const std::string_view token = word();
    if (token.empty()) return std::optional<VcdChange>{};
    switch (token[0]) {
      case '#':
        if (Status read = read_time(token.substr(1)); !read) {
          return read.error();
        }
        break;
      case '0':
      case '1':
      case 'x':
      case 'X':
      case 'z':
      case 'Z': {
        Result<VcdChange> change = scalar(token);
        if (!change) return change.error();
        return std::optional<VcdChange>(*change);
      }
      case 'b':
      case 'B': {
        const std::size_t at = word_at_;
        const std::string_view code = word();
        word_at_ = at;
        Result<VcdChange> change = vector(token.substr(1), code);
        if (!change) return change.error();
        return std::optional<VcdChange>(*change);
      }
      case 'r':
      case 'R':
      case 's':
      case 'S': word(); break;
      case '$':
        if (token == "$comment") {
          if (Status skipped = skip_section(); !skipped) {
            return skipped.error();
          }
        }
        break;  // $dumpvars and the like, and their $end
      default: return error(word_at_, shown(token) + " is no change of value");
    }
  }
}

}  // namespace unstep
