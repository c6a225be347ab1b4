#include "cli/message.h"

#include <fmt/format.h>

#include <cstdio>

namespace unstep::cli {

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3;) {
    i -= 3;
    digits.insert(i, 1, ',');
  }
  return digits;
}

std::string counted(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(count), noun, count == 1 ? "" : "s");
}

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out;
}

std::string input_name(const std::string& path) {
  return path == "-" ? "standard input" : printable(path);
}

std::string output_name(const std::string& path) {
  return path == "-" ? "standard output" : printable(path);
}

std::string per_cent(std::uint64_t part, std::uint64_t whole) {
  const double share = whole == 0 ? 0.0
                                  : 100.0 * static_cast<double>(part) /
                                        static_cast<double>(whole);
  return fmt::format("{:.1f} %", share);
}

ExitCode report_error(std::string_view name, const Error& error) {
  const bool stopped = error.code == ErrorCode::cancelled;
  fmt::print(stderr, "unstep: {}: {}\n", name,
             stopped ? "interrupted" : printable(error.message));
  return exit_code_of(error.code);
}

void report_warning(std::string_view name, std::string_view note) {
  fmt::print(stderr, "unstep: warning: {}: {}\n", name, printable(note));
}

ExitCode report_usage(std::string_view verb, std::string_view reason) {
  fmt::print(stderr, "unstep: {} (see unstep {} --help)\n", printable(reason),
             verb);
  return ExitCode::usage;
}

void Outcome::add(ExitCode code) {
  if (code == ExitCode::interrupted) interrupted_ = true;
  if (code != ExitCode::ok) last_failure_ = code;
}

ExitCode Outcome::exit_code() const {
  if (interrupted_) return ExitCode::interrupted;
  if (last_failure_ == ExitCode::ok) return ExitCode::ok;
  return inputs_ == 1 ? last_failure_ : ExitCode::some_failed;
}

}  // namespace unstep::cli
