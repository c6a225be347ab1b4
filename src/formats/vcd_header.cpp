#include <algorithm>
#include <utility>

#include "formats/vcd_reader.h"
#include "formats/vcd_text.h"

/// The header of a value change dump: timescale, scopes and variables.
namespace unstep {

using vcd::parse_range;
using vcd::shown;

Result<std::vector<std::string_view>> VcdReader::section(
    std::string_view keyword) {
  constexpr std::size_t kMost = 8;  // $var has the most words, 6
  const std::size_t begin = word_at_;
  std::vector<std::string_view> words;
  for (std::string_view next = word(); next != "$end"; next = word()) {
    if (next.empty()) {
      return error(begin, std::string(keyword) + " without $end",
                   ErrorCode::truncated);
    }
    if (words.size() == kMost) {
      return error(begin, "too many words in " + std::string(keyword));
    }
    words.push_back(next);
  }
  word_at_ = begin;
  return words;
}

Status VcdReader::read_header(const DecodeLimits& limits) {
  for (;;) {
    const std::string_view keyword = word();
    if (keyword.empty()) {
      return error(text_.size(), "the file ends before $enddefinitions",
                   ErrorCode::truncated);
    }
    if (keyword[0] != '$') {
      return error(word_at_, shown(keyword) + " before $enddefinitions");
    }
    Status read;
    if (keyword == "$timescale") {
      read = read_timescale();
    } else if (keyword == "$scope") {
      read = read_scope(limits);
    } else if (keyword == "$upscope") {
      read = leave_scope();
    } else if (keyword == "$var") {
      read = read_variable(limits);
    } else {
      const std::size_t begin = position_;
      const bool comment = keyword == "$comment" && comment_.empty();
      read = skip_section();
      if (comment) comment_ = text_.substr(begin, word_at_ - begin);
    }
    if (!read || keyword == "$enddefinitions") return read;
  }
}

Status VcdReader::read_timescale() {
  const auto words = section("$timescale");
  if (!words) return words.error();
  std::string text;
  for (const std::string_view part : *words) text += part;
  const std::size_t unit_at = text.find_first_not_of("0123456789");
  const std::string_view unit = unit_at == std::string::npos
                                    ? ""
                                    : std::string_view(text).substr(unit_at);
  constexpr std::array<std::string_view, 6> kUnits{"s",  "ms", "us",
                                                   "ns", "ps", "fs"};
  const auto found = std::find(kUnits.begin(), kUnits.end(), unit);
  std::int32_t magnitude = 0;
  if (found == kUnits.end() ||
      !parse_whole(std::string_view(text).substr(0, unit_at), magnitude) ||
      (magnitude != 1 && magnitude != 10 && magnitude != 100)) {
    return error(word_at_, "$timescale is not 1, 10 or 100 of s to fs");
  }
  timescale_ = {true, magnitude,
                -3 * static_cast<std::int32_t>(found - kUnits.begin())};
  return {};
}

Status VcdReader::read_scope(const DecodeLimits& limits) {
  const auto words = section("$scope");
  if (!words) return words.error();
  if (words->size() != 2) {
    return error(word_at_, "$scope needs a kind and a name");
  }
  std::string path = scopes_.empty() ? "" : scopes_.back() + ".";
  path += (*words)[1];
  memory_ += path.size() + 2 * sizeof(std::string);
  if (memory_ > limits.max_memory) {
    return error(word_at_, "more names than the memory limit allows",
                 ErrorCode::limit_exceeded);
  }
  scopes_.push_back(std::move(path));
  return {};
}

Status VcdReader::leave_scope() {
  const auto words = section("$upscope");
  if (!words) return words.error();
  if (scopes_.empty()) return error(word_at_, "$upscope without $scope");
  memory_ -= scopes_.back().size() + 2 * sizeof(std::string);
  scopes_.pop_back();
  return {};
}

/// $var KIND WIDTH CODE NAME [RANGE] $end; names of some writers have blanks.
Status VcdReader::read_variable(const DecodeLimits& limits) {
  const auto words = section("$var");
  if (!words) return words.error();
  VcdSignal signal;
  if (words->size() < 4 || !parse_whole((*words)[1], signal.width)) {
    return error(word_at_, "$var needs a kind, a width, a code and a name");
  }
  const std::string_view code = (*words)[2];
  std::string name(words->at(3));
  for (std::size_t i = 4; i < words->size(); ++i) {
    if ((*words)[i][0] != '[') name += ' ';
    name += (*words)[i];
  }
  std::string range_text;
  const std::size_t bracket = name.rfind('[');
  if (name.ends_with(']') && bracket != 0 && bracket != std::string::npos) {
    range_text = name.substr(bracket);
    name.resize(bracket);
  }
  // Besides the signal: a width and a node of the table of codes; vectors may
  // hold twice what they need while they grow.
  const std::size_t path = scopes_.empty() ? 0 : scopes_.back().size() + 1;
  memory_ += path + name.size() + range_text.size() +
             3 * (sizeof(VcdSignal) + sizeof(std::uint32_t)) + 64;
  if (memory_ > limits.max_memory) {
    return error(word_at_, "more variables than the memory limit allows",
                 ErrorCode::limit_exceeded);
  }
  if (!scopes_.empty()) signal.name = scopes_.back() + ".";
  signal.name += name;
  const std::optional<vcd::Range> range = parse_range(range_text);
  if (range && range->left != range->right) {
    signal.right = range->right;
  } else {
    signal.name += range_text;
  }
  signal.net = net_of(code);
  if (signal.net == kNoNet) {
    signal.net = static_cast<std::uint32_t>(widths_.size());
    widths_.push_back(signal.width);
    if (code.size() == 1 && static_cast<unsigned char>(code[0]) < 128) {
      short_codes_[static_cast<unsigned char>(code[0])] = signal.net;
    } else {
      codes_.emplace(code, signal.net);
    }
  } else if (widths_[signal.net] != signal.width) {
    return error(word_at_, "code " + shown(code) + " has two widths");
  }
  signals_.push_back(std::move(signal));
  return {};
}

}  // namespace unstep
