#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

/// The progress line on stderr.
namespace unstep::cli {

/// Draws "LABEL  45 %  12.3 Mpx/s  0:12 left" and keeps it on one line; erases
/// it when it ends. Draws nothing unless stderr is a terminal and the work has
/// taken a second already. Not for two threads at once.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { finish(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `fraction` of the whole work is done, 0..1, and `pixels` of it.
  void update(std::string_view label, double fraction, std::uint64_t pixels);

  /// Erases the line, before something else is written.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  const bool shown_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point next_draw_ = start_ + std::chrono::seconds(1);
  bool drawn_ = false;
};

/// Seconds as "0:07" or "1:02:03".
[[nodiscard]] std::string clock_time(double seconds);

}  // namespace unstep::cli
