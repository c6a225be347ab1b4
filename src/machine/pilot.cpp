#include "machine/pilot.h"

namespace unstep::machine {

std::int32_t Pilot::counter(Axis axis) {
  auto value = zenit_.read_counter(axis);
  while (!value) {
    zenit_.tick();
    value = zenit_.read_counter(axis);
  }
  return *value;
}

void Pilot::go(Axis axis, std::int32_t place) {
  const std::int32_t way = place - counter(axis);
  zenit_.command(Operation::load_cr1, axis, to_direct_code(way));
  zenit_.command(Operation::positioning, axis);
  zenit_.command(Operation::start_motor, axis);
}

Status Pilot::arrive(double seconds) {
  const auto there = [this] {
    return zenit_.motor_done(Axis::x) && zenit_.motor_done(Axis::y);
  };
  if (wait(there, seconds)) return {};
  return Error{ErrorCode::internal, "Zenit: the carriage does not arrive"};
}

}  // namespace unstep::machine
