#include <algorithm>
#include <array>
#include <charconv>
#include <new>
#include <string>
#include <utility>

#include "formats/characters.h"
#include "unstep/formats.h"

/// Freeman chain text, docs/freeman.md.
namespace unstep {
namespace {

struct Keyword {
  std::string_view word;
  Connectivity connectivity;
  bool closed;
};
constexpr std::array kKeywords{
    Keyword{"open4", Connectivity::four, false},
    Keyword{"open8", Connectivity::eight, false},
    Keyword{"closed4", Connectivity::four, true},
    Keyword{"closed8", Connectivity::eight, true},
};

class Parser {
 public:
  Parser(std::string_view text, const DecodeLimits& limits)
      : text_(text), limits_(limits) {
    if (text_.starts_with("\xef\xbb\xbf")) position_ = 3;  // some editors' mark
  }

  Result<Drawing> parse() {
    for (skip_blanks(); position_ < text_.size(); skip_blanks()) {
      if (!is_letter(text_[position_])) {
        return error(
            "expected a keyword (canvas, open4, open8, closed4, "
            "closed8) or a comment");
      }
      word_at_ = position_;
      const std::string_view word = read_word();
      Status read;
      if (word == "canvas") {
        read = read_canvas();
      } else {
        const auto keyword =
            std::find_if(kKeywords.begin(), kKeywords.end(),
                         [word](const Keyword& k) { return k.word == word; });
        if (keyword == kKeywords.end()) {
          return error_at(word_at_, "unknown keyword");
        }
        read = read_chain(*keyword);
      }
      if (!read) return read.error();
    }
    return std::move(drawing_);
  }

 private:
  /// Line and column are looked for only when there is an error to tell.
  [[nodiscard]] Error error_at(std::size_t position, const std::string& reason,
                               ErrorCode code = ErrorCode::corrupt) const {
    const std::string_view before = text_.substr(0, position);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t newline = before.rfind('\n');
    const std::size_t column =
        newline == std::string_view::npos ? position + 1 : position - newline;
    return {code, "line " + std::to_string(line) + ", column " +
                      std::to_string(column) + ": " + reason};
  }
  [[nodiscard]] Error error(const std::string& reason,
                            ErrorCode code = ErrorCode::corrupt) const {
    return error_at(position_, reason, code);
  }

  void skip_blanks() { position_ = after_blanks(position_); }

  [[nodiscard]] std::size_t after_blanks(std::size_t at) const {
    for (; at < text_.size(); ++at) {
      const char c = text_[at];
      if (c == '#') {
        at = std::min(text_.find('\n', at), text_.size() - 1);
      } else if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
        break;
      }
    }
    return at;
  }

  /// Blanks inside a line.
  void skip_spaces() {
    while (position_ < text_.size() &&
           (text_[position_] == ' ' || text_[position_] == '\t')) {
      ++position_;
    }
  }

  std::string_view read_word() {
    const std::size_t begin = position_;
    while (position_ < text_.size() &&
           (is_letter(text_[position_]) || is_digit(text_[position_]))) {
      ++position_;
    }
    return text_.substr(begin, position_ - begin);
  }

  Result<std::int32_t> read_number(std::int32_t least, const char* what) {
    skip_spaces();
    const std::size_t begin = position_;
    std::int64_t value = 0;
    const char* end = text_.data() + text_.size();
    const auto [stop, failed] =
        std::from_chars(text_.data() + position_, end, value);
    if (failed == std::errc::invalid_argument) {
      return error(std::string("expected ") + what);
    }
    position_ = static_cast<std::size_t>(stop - text_.data());
    if (failed != std::errc{} || value < least || value > kMaxCoord) {
      return error_at(begin,
                      std::string(what) + " out of range; it is " +
                          std::to_string(least) + " to " +
                          std::to_string(kMaxCoord),
                      ErrorCode::out_of_range);
    }
    return static_cast<std::int32_t>(value);
  }

  Status read_canvas() {
    if (has_canvas_ || !drawing_.chains.empty()) {
      return error_at(word_at_,
                      "the canvas is given once, before the first chain");
    }
    has_canvas_ = true;
    const Result<std::int32_t> width = read_number(0, "a canvas width");
    if (!width) return width.error();
    const Result<std::int32_t> height = read_number(0, "a canvas height");
    if (!height) return height.error();
    drawing_.canvas = {*width, *height, YAxis::down};
    skip_spaces();
    if (position_ < text_.size() && is_letter(text_[position_])) {
      const std::size_t begin = position_;
      const std::string_view word = read_word();
      if (word != "up" && word != "down") {
        return error_at(begin, "expected up, down or the end of the line");
      }
      drawing_.canvas.y_axis = word == "up" ? YAxis::up : YAxis::down;
    }
    return end_of_line();
  }

  Status end_of_line() {
    skip_spaces();
    if (position_ < text_.size() && text_[position_] != '\n' &&
        text_[position_] != '\r' && text_[position_] != '#') {
      return error("expected the end of the line");
    }
    return {};
  }

  Status read_chain(const Keyword& keyword) {
    Chain chain;
    chain.connectivity = keyword.connectivity;
    chain.closed = keyword.closed;
    const Result<std::int32_t> x = read_number(-kMaxCoord, "an x coordinate");
    if (!x) return x.error();
    const Result<std::int32_t> y = read_number(-kMaxCoord, "a y coordinate");
    if (!y) return y.error();
    chain.origin = {*x, *y};
    skip_spaces();
    if (position_ == text_.size() || text_[position_] != ':') {
      return error("expected ':' before the steps");
    }
    ++position_;
    const std::uint64_t count = count_steps();
    if (Status fits = reserve(count, chain); !fits) return fits;
    if (Status steps = read_steps(chain); !steps) return steps;
    drawing_.chains.push_back(std::move(chain));
    return {};
  }

  /// Digits up to the next keyword or the first thing that is no step.
  [[nodiscard]] std::uint64_t count_steps() const {
    std::uint64_t count = 0;
    for (std::size_t at = after_blanks(position_);
         at < text_.size() && is_digit(text_[at]); at = after_blanks(at + 1)) {
      ++count;
    }
    return count;
  }

  Status reserve(std::uint64_t count, Chain& chain) {
    if (count > limits_.max_steps - steps_) {
      return error_at(word_at_,
                      "more than the limit of " +
                          std::to_string(limits_.max_steps) + " steps",
                      ErrorCode::limit_exceeded);
    }
    steps_ += count;
    // The vector of chains may hold twice what it needs while it grows.
    const std::uint64_t memory =
        steps_ + (drawing_.chains.size() + 1) * 3 * sizeof(Chain);
    if (memory > limits_.max_memory) {
      return error_at(word_at_,
                      "more than the memory limit of " +
                          std::to_string(limits_.max_memory) + " bytes",
                      ErrorCode::limit_exceeded);
    }
    chain.steps.reserve(static_cast<std::size_t>(count));
    return {};
  }

  Status read_steps(Chain& chain) {
    Point at = chain.origin;
    const bool four = chain.connectivity == Connectivity::four;
    for (skip_blanks(); position_ < text_.size(); ++position_, skip_blanks()) {
      const char c = text_[position_];
      if (is_letter(c)) break;
      if (c < '0' || c > '7') return error("expected a step, 0 to 7");
      const auto step = static_cast<Step>(c - '0');
      if (four && step % 2 != 0) {
        return error("odd step in a 4-connected chain");
      }
      const Point delta = step_delta(step, drawing_.canvas.y_axis);
      at = {at.x + delta.x, at.y + delta.y};
      if (std::max({at.x, -at.x, at.y, -at.y}) > kMaxCoord) {
        return error("the step leaves the coordinate range of -" +
                         std::to_string(kMaxCoord) + " to " +
                         std::to_string(kMaxCoord),
                     ErrorCode::out_of_range);
      }
      chain.steps.push_back(step);
    }
    if (chain.closed && at != chain.origin) {
      return error_at(word_at_, "closed chain ends at " + std::to_string(at.x) +
                                    " " + std::to_string(at.y) +
                                    ", not at its origin");
    }
    return {};
  }

  std::string_view text_;
  const DecodeLimits& limits_;
  std::size_t position_ = 0;
  std::size_t word_at_ = 0;  ///< of the current keyword
  bool has_canvas_ = false;
  std::uint64_t steps_ = 0;
  Drawing drawing_;
};

}  // namespace

Result<Drawing> parse_freeman(std::string_view text,
                              const DecodeLimits& limits) {
  try {
    return Parser(text, limits).parse();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the chains"};
  }
}

}  // namespace unstep
