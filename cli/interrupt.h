#pragma once

/// Ctrl-C and its kin. Whatever happens, no temporary file stays behind and
/// the exit code is 130.
namespace unstep::cli {

/// Handles SIGINT, SIGTERM and SIGHUP from now on.
void install_interrupt_handlers();

/// True once the user asked to stop. Long work polls it.
[[nodiscard]] bool interrupted();

/// While one lives, a signal is only noted, because the work polls
/// interrupted() and ends by itself; a second signal, or two seconds without
/// an end, stop the program at once. Outside, the first signal does.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
};

}  // namespace unstep::cli
