#pragma once

#include <cstddef>
#include <span>

#include "interpolate/ticks.h"
#include "unstep/interpolate.h"

/// A1 and A3 behind the common interface: the device and its sign rule.
namespace unstep::interpolation {

template <class Device>
class DeviceLine {
 public:
  explicit DeviceLine(Segment segment) : quadrant_(segment) {
    device_.start(quadrant_.xk, quadrant_.yk);
  }

  Tick next() {
    switch (device_.clock()) {
      case DeviceRegisters::Axis::x: return step_tick(quadrant_.along_x);
      case DeviceRegisters::Axis::y: return step_tick(quadrant_.along_y);
      case DeviceRegisters::Axis::none: break;
    }
    return {};
  }

  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  Quadrant quadrant_;
  Device device_;
};

template <>
inline std::size_t DeviceLine<DeviceRegisters>::registers(
    std::span<Register, kMaxRegisters> out) const {
  out[0] = {"X", device_.x};
  out[1] = {"Y", device_.y};
  out[2] = {"F", device_.f};
  return 3;
}

/// The contents and the output columns of Fig. 4.
template <>
inline std::size_t DeviceLine<GateNet>::registers(
    std::span<Register, kMaxRegisters> out) const {
  const DeviceRegisters now = device_.registers();
  const GateNet::Signals& signals = device_.signals();
  out[0] = {"X", now.x};
  out[1] = {"Y", now.y};
  out[2] = {"F", now.f};
  out[3] = {"AND4", signals.and4};
  out[4] = {"AND5", signals.and5};
  out[5] = {"T11", signals.trigger11};
  out[6] = {"AND19", signals.and19};
  return 7;
}

}  // namespace unstep::interpolation
