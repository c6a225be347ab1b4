#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "formats/text_scanner.h"
#include "steps/format.h"

/// Comma-separated steps: comments with "#", a line of names, a line per
/// pulse. docs/steps.md.
namespace unstep::steps {
namespace {

enum class Column : std::uint8_t { x, y, z, rapid, wait, ignored };

constexpr std::size_t kMaxColumns = 32;

class CsvReader {
 public:
  explicit CsvReader(const StepReadOptions& options)
      : out_(options.head, options.max_steps) {}

  Result<StepStream> read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      ++line_;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      if (Status done = read_line(line); !done) return done.error();
    }
    if (columns_ == 0) return error("no names of columns");
    return out_.take();
  }

 private:
  [[nodiscard]] Error error(const std::string& reason) const {
    return {ErrorCode::corrupt,
            "line " + std::to_string(line_) + ": " + reason};
  }

  Status read_line(std::string_view line) {
    if (line.starts_with('#')) {
      if (read_head_words(line.substr(1), out_.head())) return {};
      return error("a broken number in the head");
    }
    if (line.find_first_not_of(" \t") == std::string_view::npos) return {};
    return columns_ == 0 ? read_names(line) : read_pulse(line);
  }

  Status read_names(std::string_view line) {
    bool timed = false;
    bool z = false;
    std::array<bool, 5> seen{};
    while (true) {
      const std::size_t comma = std::min(line.find(','), line.size());
      std::string_view name = line.substr(0, comma);
      while (name.starts_with(' ')) name.remove_prefix(1);
      while (name.ends_with(' ')) name.remove_suffix(1);
      if (columns_ == kMaxColumns) return error("too many columns");
      const Column column = name == "x"       ? Column::x
                            : name == "y"     ? Column::y
                            : name == "z"     ? Column::z
                            : name == "rapid" ? Column::rapid
                            : name == "wait"  ? Column::wait
                                              : Column::ignored;
      if (column != Column::ignored) {
        bool& before = seen[static_cast<std::size_t>(column)];
        if (before) return error("two columns of one name");
        before = true;
      }
      z = z || column == Column::z;
      timed = timed || column == Column::wait;
      kinds_[columns_++] = column;
      if (comma == line.size()) break;
      line.remove_prefix(comma + 1);
    }
    if (!seen[0] || !seen[1]) return error("no columns x and y");
    StepHead& head = out_.head();
    head.axes = z ? 3 : 2;
    if (!z) head.origin[2] = 0;
    if (timed && head.clock == 0) {
      return error("waits, but no \"# clock\" before");
    }
    if (!timed) head.clock = 0;
    return check_head(head);
  }

  Status read_pulse(std::string_view line) {
    TextScanner in(line);
    unsigned word = 0;
    bool rapid = false;
    std::uint32_t wait = 0;
    for (std::size_t i = 0; i < columns_; ++i) {
      in.skip_blanks();
      if (i > 0 && !in.take(',')) return error("too few columns");
      in.skip_blanks();
      if (kinds_[i] == Column::ignored) {
        in.skip(std::min(in.rest().find(','), in.rest().size()));
        continue;
      }
      const std::optional<double> value = in.number();
      if (!value) return error("expected a number");
      if (kinds_[i] == Column::rapid) {
        if (*value != 0 && *value != 1) return error("rapid is 0 or 1");
        rapid = *value == 1;
      } else if (kinds_[i] == Column::wait) {
        if (!(*value >= 1) || !(*value <= 4294967295.0) ||
            *value != std::floor(*value)) {
          return error("a wait is 1 to 4294967295 ticks");
        }
        wait = static_cast<std::uint32_t>(*value);
      } else {
        if (*value != 0 && *value != 1 && *value != -1) {
          return error("a step is -1, 0 or 1");
        }
        const unsigned bits = *value == 0 ? 0U : *value > 0 ? 1U : 3U;
        word |= bits << (2 * static_cast<unsigned>(kinds_[i]));
      }
    }
    in.skip_blanks();
    if (!in.at_end()) return error("too many columns");
    if (word == 0) return error("a pulse without a step");
    return out_.add(rapid, static_cast<StepWord>(word), wait);
  }

  Collector out_;
  std::array<Column, kMaxColumns> kinds_{};
  std::size_t columns_ = 0;
  std::uint64_t line_ = 0;
};

}  // namespace

Result<StepStream> read_csv(std::string_view text,
                            const StepReadOptions& options) {
  return CsvReader(options).read(text);
}

}  // namespace unstep::steps
