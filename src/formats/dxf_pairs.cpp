#include "formats/dxf_pairs.h"

#include <charconv>
#include <cmath>
#include <string>

#include "formats/characters.h"
#include "formats/text_scanner.h"

namespace unstep {
namespace {

constexpr int kComment = 999;

}  // namespace

std::optional<double> dxf_number(std::string_view value) {
  TextScanner scanner(value);
  const std::optional<double> number = scanner.number();
  return scanner.at_end() ? number : std::nullopt;
}

std::optional<std::string_view> DxfRecord::text(int code) const {
  for (const DxfPair& pair : pairs) {
    if (pair.code == code) return pair.value;
  }
  return std::nullopt;
}

double DxfRecord::real(int code, double missing) const {
  const std::optional<std::string_view> value = text(code);
  return value ? dxf_number(*value).value_or(missing) : missing;
}

int DxfRecord::integer(int code, int missing) const {
  const double value = real(code, missing);
  return std::fabs(value) < 1e9 ? static_cast<int>(value) : missing;
}

std::optional<std::string_view> DxfRecords::line() {
  if (place_.offset >= text_.size()) return std::nullopt;
  std::size_t end = text_.find('\n', place_.offset);
  if (end == std::string_view::npos) end = text_.size();
  const std::string_view found =
      text_.substr(place_.offset, end - place_.offset);
  place_.offset = end + 1;
  ++place_.line;
  return trimmed(found);
}

Result<bool> DxfRecords::pair(DxfPair& pair) {
  do {
    const std::optional<std::string_view> code = line();
    if (!code) return false;
    const auto [end, failed] =
        std::from_chars(code->data(), code->data() + code->size(), pair.code);
    if (failed != std::errc{} || end != code->data() + code->size()) {
      return Error{place_.line == 1 ? ErrorCode::bad_magic : ErrorCode::corrupt,
                   "line " + std::to_string(place_.line) +
                       ": expected the number of a group"};
    }
    const std::optional<std::string_view> value = line();
    if (!value) return false;
    pair.value = *value;
  } while (pair.code == kComment);
  return true;
}

Status DxfRecords::next(DxfRecord& record) {
  const auto ends = [this] {
    return Error{ErrorCode::truncated, "line " + std::to_string(place_.line) +
                                           ": the file ends before its EOF"};
  };
  DxfPair group;
  Result<bool> read = pair(group);
  if (!read) return read.error();
  if (!*read) return ends();
  if (group.code != 0) {
    return Error{
        place_.line == 2 ? ErrorCode::bad_magic : ErrorCode::corrupt,
        "line " + std::to_string(place_.line - 1) + ": expected group 0"};
  }
  record.kind = group.value;
  record.line = place_.line;
  record.pairs.clear();
  for (;;) {
    const Place before = place_;
    read = pair(group);
    if (!read) return read.error();
    if (!*read) {
      // After EOF, nothing need follow.
      if (record.kind == "EOF") return {};
      return ends();
    }
    if (group.code == 0) {
      place_ = before;
      return {};
    }
    record.pairs.push_back(group);
  }
}

}  // namespace unstep
