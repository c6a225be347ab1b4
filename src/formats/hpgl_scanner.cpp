#include "formats/hpgl_scanner.h"

#include <algorithm>

#include "formats/text_scanner.h"

namespace unstep {
namespace {

bool is_filler(char c) { return is_blank(c) || c == ';' || c == '\0'; }

char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

}  // namespace

/// "ESC . x ... :" of serial plotters, "ESC % n B" and "ESC E" of PCL.
void HpglScanner::skip_escape() {
  ++at_;
  const char kind = at_ < text_.size() ? text_[at_] : '\0';
  if (kind == '.') {
    at_ += 2;
    while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == ';')) {
      ++at_;
    }
    if (at_ < text_.size() && text_[at_] == ':') ++at_;
  } else if (kind == 'E') {
    ++at_;
  } else {
    while (at_ < text_.size() && !(text_[at_] >= 'A' && text_[at_] <= 'Z')) {
      ++at_;
    }
    ++at_;
  }
  at_ = std::min(at_, text_.size());
}

Status HpglScanner::read_values(std::vector<double>& values) {
  TextScanner scanner(text_.substr(at_));
  for (;;) {
    scanner.skip_separator();
    const char c = scanner.peek();
    if (scanner.at_end() || c == ';' || c == '\0' || c == '\x1b' ||
        is_letter(c)) {
      break;
    }
    // HPGL has no exponents: "E" begins an instruction.
    std::string_view rest = scanner.rest();
    std::size_t length = c == '-' || c == '+' ? 1 : 0;
    while (length < rest.size() &&
           (is_digit(rest[length]) || rest[length] == '.')) {
      ++length;
    }
    TextScanner one(rest.substr(0, length));
    const std::optional<double> value = one.number();
    if (!value || !one.at_end()) {
      return Error{ErrorCode::corrupt,
                   "byte " + std::to_string(at_ + scanner.position()) +
                       ": expected a number"};
    }
    values.push_back(*value);
    scanner.skip(length);
  }
  at_ += scanner.position();
  return {};
}

Result<std::string_view> HpglScanner::next(std::vector<double>& values) {
  values.clear();
  while (at_ < text_.size()) {
    if (text_[at_] == '\x1b') {
      skip_escape();
    } else if (is_filler(text_[at_])) {
      ++at_;
    } else {
      break;
    }
  }
  begin_ = at_;
  if (at_ >= text_.size()) return std::string_view{};
  if (at_ + 1 >= text_.size() || !is_letter(text_[at_]) ||
      !is_letter(text_[at_ + 1])) {
    return Error{any_ ? ErrorCode::corrupt : ErrorCode::bad_magic,
                 "byte " + std::to_string(at_) +
                     ": expected an instruction of two letters"};
  }
  name_ = {capital(text_[at_]), capital(text_[at_ + 1])};
  at_ += 2;
  any_ = true;
  if (name_ == "LB") {
    at_ = std::min(text_.find(label_end_, at_), text_.size());
    at_ = std::min(at_ + 1, text_.size());
  } else if (name_ == "DT") {
    if (at_ < text_.size() && text_[at_] != ';') label_end_ = text_[at_++];
  } else if (name_ == "PE" || name_ == "CO" || name_ == "SM") {
    const std::size_t begin = at_;
    at_ = std::min(text_.find(';', at_), text_.size());
    encoded_ = text_.substr(begin, at_ - begin);
  } else if (Status read = read_values(values); !read) {
    return read.error();
  }
  return std::string_view(name_);
}

}  // namespace unstep
