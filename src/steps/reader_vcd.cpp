#include <array>
#include <map>
#include <optional>
#include <string>

#include "formats/text_scanner.h"
#include "steps/format.h"

/// Value change dumps: a rising edge of a step wire is a step, its direction
/// is that of the dir wire at the time. docs/steps.md.
namespace unstep::steps {
namespace {

enum class Role : std::uint8_t { step, direction, rapid };

struct Wire {
  Role role = Role::step;
  std::size_t axis = 0;
};

/// What a wire is by its name: "step_x", "XSTEP", "x_dir", "dirZ", "rapid".
std::optional<Wire> wire_of(std::string_view name) {
  std::string word;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') {
      word += static_cast<char>(c + 32);
    } else if (c >= 'a' && c <= 'z') {
      word += c;
    }
  }
  if (word == "rapid") return Wire{Role::rapid, 0};
  for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
    const std::string letter(1, static_cast<char>('x' + axis));
    for (const char* role : {"step", "dir", "direction", "pulse", "stp"}) {
      const std::string text(role);
      if (word != text + letter && word != letter + text) continue;
      return Wire{text[0] == 'd' ? Role::direction : Role::step, axis};
    }
  }
  return std::nullopt;
}

class Reader {
 public:
  Reader(std::string_view text, const StepReadOptions& options)
      : text_(text), out_(options.head, options.max_steps) {}

  Result<StepStream> read() {
    while (next_word()) {
      const Status done = word_[0] == '$'   ? read_command()
                          : word_[0] == '#' ? read_time()
                                            : read_change();
      if (!done) return done.error();
    }
    if (Status done = end_time(); !done) return done.error();
    if (!seen_[0] && !seen_[1]) {
      return error("no wires step_x, dir_x, step_y, dir_y");
    }
    return out_.take();
  }

 private:
  [[nodiscard]] Error error(const std::string& reason) const {
    return {ErrorCode::corrupt, "byte " + std::to_string(at_) + ": " + reason};
  }

  bool next_word() {
    while (at_ < text_.size() && TextScanner::is_blank(text_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !TextScanner::is_blank(text_[at_])) ++at_;
    word_ = text_.substr(begin, at_ - begin);
    return !word_.empty();
  }

  Status read_command() {
    const std::string_view command = word_;
    if (command == "$dumpvars" || command == "$dumpall" ||
        command == "$dumpon" || command == "$dumpoff" || command == "$end") {
      return {};
    }
    const std::size_t begin = at_;
    const std::size_t end = text_.find("$end", at_);
    if (end == std::string_view::npos) {
      return error(std::string(command) + " without $end");
    }
    const std::string_view body = text_.substr(begin, end - begin);
    at_ = end + 4;
    if (command == "$comment" && body.find("unstep") != body.npos) {
      own_ = true;
      out_.head().clock = 0;
      if (!read_head_words(body, out_.head())) {
        return error("a broken number in the head");
      }
    }
    if (command == "$timescale") return read_timescale(body);
    if (command == "$var") return read_var(body);
    if (command == "$enddefinitions") return end_definitions();
    return {};
  }

  Status read_timescale(std::string_view body) {
    TextScanner in(body);
    in.skip_blanks();
    const auto number = in.number();
    in.skip_blanks();
    const std::string_view unit = in.rest();
    constexpr std::array<std::string_view, 6> kUnits{"s",  "ms", "us",
                                                     "ns", "ps", "fs"};
    double per_second = number && *number > 0 ? 1 / *number : 0;
    bool known = false;
    for (const std::string_view name : kUnits) {
      if (unit.starts_with(name)) {
        known = true;
        break;
      }
      per_second *= 1000;
    }
    if (!known || per_second == 0) return error("an unknown timescale");
    // Waits count in ticks of at most 1 GHz.
    clock_ = per_second;
    return {};
  }

  Status read_var(std::string_view body) {
    at_body_ = body;
    std::array<std::string_view, 4> parts;
    for (std::string_view& part : parts) {
      while (!at_body_.empty() && TextScanner::is_blank(at_body_[0])) {
        at_body_.remove_prefix(1);
      }
      std::size_t size = 0;
      while (size < at_body_.size() && !TextScanner::is_blank(at_body_[size])) {
        ++size;
      }
      part = at_body_.substr(0, size);
      at_body_.remove_prefix(size);
    }
    const std::optional<Wire> wire = wire_of(parts[3]);
    if (!wire || parts[1] != "1" || parts[2].empty()) return {};
    if (wires_.size() >= 64) return error("too many wires");
    wires_[std::string(parts[2])] = *wire;
    if (wire->role == Role::step) seen_[wire->axis] = true;
    return {};
  }

  Status end_definitions() {
    StepHead& head = out_.head();
    head.axes = seen_[2] ? 3 : 2;
    if (!seen_[2]) head.origin[2] = 0;
    if (clock_ == 0) return error("no timescale");
    // Without a clock times only tell the order.
    const double clock = std::min(clock_, static_cast<double>(kVcdClock));
    if (!own_) head.clock = static_cast<std::uint32_t>(std::max(clock, 1.0));
    defined_ = true;
    return check_head(head);
  }

  Status read_time() {
    if (!defined_) return error("a time before $enddefinitions");
    std::uint64_t time = 0;
    if (word_.size() < 2 || word_.size() > 19) return error("a broken time");
    for (const char c : word_.substr(1)) {
      if (!TextScanner::is_digit(c)) return error("a broken time");
      time = time * 10 + static_cast<std::uint64_t>(c - '0');
    }
    if (time < time_) return error("a time before the one before");
    if (time == time_) return {};
    if (Status done = end_time(); !done) return done;
    time_ = time;
    return {};
  }

  Status read_change() {
    if (word_[0] == 'b' || word_[0] == 'B' || word_[0] == 'r' ||
        word_[0] == 'R') {
      next_word();  // the wire's name; no wire of steps has more than one bit
      return {};
    }
    const bool high = word_[0] == '1';
    if (!high && word_[0] != '0' && word_[0] != 'x' && word_[0] != 'X' &&
        word_[0] != 'z' && word_[0] != 'Z') {
      return error("neither a time nor a value");
    }
    const auto found = wires_.find(word_.substr(1));
    if (found == wires_.end()) return {};
    const Wire& wire = found->second;
    if (wire.role == Role::rapid) {
      rapid_ = high;
    } else if (wire.role == Role::direction) {
      back_[wire.axis] = high;
    } else {
      if (high && !level_[wire.axis]) rose_[wire.axis] = true;
      level_[wire.axis] = high;
    }
    return {};
  }

  /// All changes of one time are known.
  Status end_time() {
    unsigned word = 0;
    for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
      if (!rose_[axis]) continue;
      word |= (back_[axis] ? 3U : 1U) << (2 * axis);
      rose_[axis] = false;
    }
    if (word == 0) return {};
    const std::uint64_t ticks = ticks_at(time_);
    const std::uint64_t wait =
        std::max<std::uint64_t>(ticks - std::min(before_, ticks), 1);
    if (wait > 0xffffffffU && out_.head().clock > 0) {
      return Error{ErrorCode::out_of_range,
                   "byte " + std::to_string(at_) +
                       ": more than 2^32 ticks between two steps"};
    }
    before_ = ticks;
    return out_.add(rapid_, static_cast<StepWord>(word),
                    static_cast<std::uint32_t>(wait));
  }

  /// Ticks of the head's clock, to the nearest.
  [[nodiscard]] std::uint64_t ticks_at(std::uint64_t time) const {
    const double ticks = static_cast<double>(time) / clock_ *
                         static_cast<double>(out_.head().clock);
    return ticks < 1e18 ? static_cast<std::uint64_t>(ticks + 0.5)
                        : std::uint64_t{1} << 60;
  }

  std::string_view text_;
  std::string_view at_body_;
  std::size_t at_ = 0;
  std::string_view word_;
  Collector out_;
  std::map<std::string, Wire, std::less<>> wires_;
  std::array<bool, kMaxStepAxes> seen_{};
  std::array<bool, kMaxStepAxes> level_{};
  std::array<bool, kMaxStepAxes> back_{};
  std::array<bool, kMaxStepAxes> rose_{};
  bool rapid_ = false;
  bool defined_ = false;
  bool own_ = false;  ///< unstep wrote it
  double clock_ = 0;  ///< of the file's own times
  std::uint64_t time_ = 0;
  std::uint64_t before_ = 0;  ///< ticks of the last step
};

}  // namespace

Result<StepStream> read_vcd(std::string_view text,
                            const StepReadOptions& options) {
  return Reader(text, options).read();
}

}  // namespace unstep::steps
