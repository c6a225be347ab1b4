#include <algorithm>
#include <charconv>
#include <optional>

#include "formats/pulse_chain.h"

/// Encoder channels as columns of text, as oscilloscopes, logic analysers and
/// sigrok-cli write them.
namespace unstep {
namespace {

std::string_view unquoted(std::string_view text) {
  const auto is_edge = [](char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '"';
  };
  while (!text.empty() && is_edge(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_edge(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, value);
  if (failed != std::errc{} || stop != end) return std::nullopt;
  return value;
}

bool is_time(std::string_view name) {
  std::string small(name);
  std::transform(small.begin(), small.end(), small.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return small == "t" || small.find("time") != std::string::npos ||
         small.starts_with("sample");
}

class CsvPulses {
 public:
  CsvPulses(std::string_view text, const PulseReadOptions& options)
      : text_(text), options_(options) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
  }

  Result<VectorPage> read() {
    std::optional<PulseChain> chain;
    while (next_row()) {
      if (!chain) {
        Result<bool> header = read_head();
        if (!header) return at_line(header.error());
        chain.emplace(options_, columns_.size());
        if (*header) continue;
      }
      if (Status done = take_row(*chain); !done) return at_line(done.error());
    }
    if (!chain) {
      return Error{ErrorCode::truncated, "no row of channels in the text"};
    }
    return chain->finish("csv");
  }

 private:
  static constexpr std::size_t kMostColumns = 4096;

  [[nodiscard]] Error at_line(const Error& error) const {
    return {error.code, "line " + std::to_string(line_) + ": " + error.message};
  }

  /// Passes over empty lines and comments.
  bool next_row() {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      row_ = unquoted(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
      if (!row_.empty() && row_[0] != ';' && row_[0] != '#') return true;
    }
    return false;
  }

  /// Field `column` of the row; nothing if there is none.
  void split() {
    fields_.clear();
    std::string_view rest = row_;
    while (fields_.size() < kMostColumns) {
      const std::size_t end = rest.find(separator_);
      fields_.push_back(unquoted(rest.substr(0, end)));
      if (end == std::string_view::npos) return;
      rest.remove_prefix(end + 1);
    }
  }

  /// From the first row: separator, names, columns. Was it a header?
  Result<bool> read_head() {
    for (const char c : {',', ';', '\t', ' '}) {
      separator_ = c;
      if (row_.find(c) != std::string_view::npos) break;
    }
    split();
    const bool is_header =
        std::any_of(fields_.begin(), fields_.end(),
                    [](std::string_view field) { return !number(field); });
    std::vector<std::string> names;
    for (const std::string_view field : fields_) {
      names.emplace_back(is_header ? std::string(field)
                                   : std::to_string(names.size() + 1));
    }
    const bool has_time =
        is_header ? is_time(names[0]) : names.size() == 3 || names.size() == 5;
    if (has_time) time_column_ = 0;
    if (!options_.channels.empty()) {
      auto chosen = choose_channels(names, options_.channels);
      if (!chosen) return chosen.error();
      columns_ = *std::move(chosen);
      return is_header;
    }
    const std::size_t skipped = has_time ? 1 : 0;
    names.erase(names.begin(),
                names.begin() + static_cast<std::ptrdiff_t>(skipped));
    auto chosen = choose_channels(names, {});
    if (!chosen) return chosen.error();
    for (const std::size_t i : *chosen) columns_.push_back(i + skipped);
    return is_header;
  }

  Status take_row(PulseChain& chain) {
    split();
    unsigned levels = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i] >= fields_.size()) {
        return Error{ErrorCode::corrupt, "column " +
                                             std::to_string(columns_[i] + 1) +
                                             " is missing; the row has " +
                                             std::to_string(fields_.size())};
      }
      const Result<bool> level =
          level_of(fields_[columns_[i]], (levels_ >> i & 1) != 0, i);
      if (!level) return level.error();
      if (*level) levels |= 1U << i;
    }
    levels_ = levels;
    if (Status later = check_time(); !later) return later;
    const Result<bool> illegal = chain.sample(levels);
    if (!illegal) return illegal.error();
    if (*illegal) {
      std::string when = "line " + std::to_string(line_);
      if (time_column_) {
        when += " (time " + std::string(fields_[0].substr(0, 32)) + ")";
      }
      chain.note_illegal(when);
    }
    return {};
  }

  [[nodiscard]] Result<bool> level_of(std::string_view field, bool before,
                                      std::size_t channel) const {
    const std::optional<double> value = number(field);
    const bool is_analogue = options_.low < options_.high;
    if (value && is_analogue) {
      return *value > options_.high || (before && *value >= options_.low);
    }
    if (value && (*value == 0 || *value == 1)) return *value == 1;
    return Error{ErrorCode::corrupt,
                 "column " + std::to_string(columns_[channel] + 1) +
                     (value ? " is neither 0 nor 1; for analogue values give "
                              "the levels of a trigger"
                            : " is no number")};
  }

  /// Rows out of order would be counted wrongly.
  Status check_time() {
    if (!time_column_) return {};
    const std::optional<double> time = number(fields_[0]);
    if (!time) return Error{ErrorCode::corrupt, "the time is no number"};
    if (last_time_ && *time < *last_time_) {
      return Error{ErrorCode::corrupt, "the time goes back"};
    }
    last_time_ = time;
    return {};
  }

  std::string_view text_;
  const PulseReadOptions& options_;
  std::uint64_t line_ = 0;
  std::string_view row_;
  char separator_ = ',';
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> columns_;
  std::optional<std::size_t> time_column_;
  std::optional<double> last_time_;
  unsigned levels_ = 0;
};

}  // namespace

Result<VectorPage> read_pulse_csv(std::string_view text,
                                  const PulseReadOptions& options) {
  return CsvPulses(text, options).read();
}

}  // namespace unstep
