#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "cli/exit_code.h"
#include "unstep/result.h"

/// The program's wording: one line per message on stderr, numbers grouped by
/// thousands, file names that cannot break a line or a terminal.
namespace unstep::cli {

/// 1234567 as "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t number);

/// "1 page", "2,000 pages".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view noun);

/// Control characters as \x1b, so that a message stays one line.
[[nodiscard]] std::string printable(std::string_view text);

/// How messages name an input or output path; "-" has a name of its own.
[[nodiscard]] std::string input_name(const std::string& path);
[[nodiscard]] std::string output_name(const std::string& path);

/// A share in per cent with one decimal, "1.9 %"; of 0 it is "0.0 %".
[[nodiscard]] std::string per_cent(std::uint64_t part, std::uint64_t whole);

/// "unstep: NAME: place: reason" on stderr. Returns the exit code of it.
ExitCode report_error(std::string_view name, const Error& error);

/// "unstep: warning: NAME: note" on stderr.
void report_warning(std::string_view name, std::string_view note);

/// "unstep: reason (see unstep VERB --help)" on stderr.
ExitCode report_usage(std::string_view verb, std::string_view reason);

/// What several inputs together return: `only` for one input, else ok or
/// some_failed; interrupted goes before both.
class Outcome {
 public:
  explicit Outcome(std::size_t inputs) : inputs_(inputs) {}
  void add(ExitCode code);
  [[nodiscard]] ExitCode exit_code() const;

 private:
  std::size_t inputs_;
  ExitCode last_failure_ = ExitCode::ok;
  bool interrupted_ = false;
};

}  // namespace unstep::cli
