#pragma once

#include <cstdint>

#include "machine/zenit.h"
#include "unstep/result.h"

/// What every program for "Zenit" does.
namespace unstep::machine {

/// The computer at the other end of the controller's lines.
class Pilot {
 public:
  explicit Pilot(Zenit& zenit) : zenit_(zenit) {}

  /// Reads a counter, waiting for its turn.
  std::int32_t counter(Axis axis);

  /// Sends an axis to a count; it goes on holding it. arrive() waits.
  void go(Axis axis, std::int32_t place);

  /// `internal` if both axes have not arrived after `seconds`.
  Status arrive(double seconds);

  /// Ticks until `reached()`; false after `seconds`.
  template <class Condition>
  bool wait(Condition reached, double seconds) {
    const double until = zenit_.seconds() + seconds;
    while (!reached()) {
      if (zenit_.seconds() > until) return false;
      zenit_.tick();
    }
    return true;
  }

 private:
  Zenit& zenit_;
};

}  // namespace unstep::machine
