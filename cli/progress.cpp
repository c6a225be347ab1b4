#include "cli/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/message.h"

namespace unstep::cli {
namespace {

constexpr std::chrono::milliseconds kRedraw{200};
constexpr double kLongestClock = 359999;  // 99:59:59

std::size_t terminal_columns() {
  winsize size = {};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) {
    return 80;
  }
  return size.ws_col;
}

}  // namespace

std::string clock_time(double seconds) {
  const auto whole = static_cast<std::uint64_t>(
      std::ceil(std::clamp(seconds, 0.0, kLongestClock)));
  const std::uint64_t hours = whole / 3600;
  const std::uint64_t minutes = whole / 60 % 60;
  if (hours == 0) return fmt::format("{}:{:02}", minutes, whole % 60);
  return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
}

ProgressLine::ProgressLine(bool quiet)
    : shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

void ProgressLine::finish() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
  drawn_ = false;
}

void ProgressLine::update(std::string_view label, double fraction,
                          std::uint64_t pixels) {
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_draw_) return;
  next_draw_ = now + kRedraw;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double done = std::clamp(fraction, 0.0, 1.0);
  std::string figures = fmt::format("  {:.0f} %", 100 * done);
  if (pixels > 0) {
    figures += fmt::format("  {:.1f} Mpx/s",
                           static_cast<double>(pixels) / 1e6 / elapsed);
  }
  if (done > 0) {
    figures += "  " + clock_time(elapsed * (1 - done) / done) + " left";
  }
  // A line as wide as the terminal would wrap and could not be erased.
  const std::size_t room = terminal_columns() - 1;
  std::string name = printable(label);
  if (name.size() + figures.size() > room) {
    name.resize(room > figures.size() ? room - figures.size() : 0);
  }
  fmt::print(stderr, "\r\x1b[K{}{}", name, figures);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace unstep::cli
