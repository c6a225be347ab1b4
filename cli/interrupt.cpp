#include "cli/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>

#include "cli/exit_code.h"
#include "formats/file.h"

namespace unstep::cli {
namespace {

constexpr unsigned kGraceSeconds = 2;

std::atomic<bool> asked_to_stop{false};
std::atomic<int> interruptible_depth{0};
static_assert(std::atomic<bool>::is_always_lock_free &&
              std::atomic<int>::is_always_lock_free);

/// Only async-signal-safe calls below.
[[noreturn]] void stop_now() {
  remove_temporaries();
  _exit(static_cast<int>(ExitCode::interrupted));
}

void on_signal(int) {
  const bool again = asked_to_stop.exchange(true);
  if (again || interruptible_depth.load() == 0) stop_now();
  alarm(kGraceSeconds);
}

void on_alarm(int) { stop_now(); }

}  // namespace

void install_interrupt_handlers() {
  struct sigaction action = {};
  sigfillset(&action.sa_mask);
  action.sa_handler = on_alarm;
  sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = on_signal;
  for (const int signal : std::array{SIGINT, SIGTERM, SIGHUP}) {
    // What was ignored stays ignored: nohup, background jobs of old shells.
    struct sigaction old = {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

bool interrupted() { return asked_to_stop.load(std::memory_order_relaxed); }

Interruptible::Interruptible() { ++interruptible_depth; }
Interruptible::~Interruptible() { --interruptible_depth; }

}  // namespace unstep::cli
