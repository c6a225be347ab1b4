#include <string>

#include "unstep/reverse.h"

namespace unstep {

Result<std::vector<Segment>> reverse_device(std::span<const Step> steps) {
  std::vector<Segment> segments;
  DeviceReverse device;
  Segment closed;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    switch (device.push(steps[i], closed)) {
      case Pushed::open: break;
      case Pushed::segment: segments.push_back(closed); break;
      case Pushed::refused:
        return Error{ErrorCode::invalid_argument,
                     "step " + std::to_string(i) + " has code " +
                         std::to_string(steps[i]) +
                         ": the device takes 0, 2, 4 and 6 only"};
    }
  }
  if (device.finish(closed)) segments.push_back(closed);
  return segments;
}

}  // namespace unstep
