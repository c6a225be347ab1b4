#pragma once

#include <cstddef>
#include <cstdint>

/// The C interface of the module that holds OpenCV. The library loads the
/// module when the first BMP needs it, so that nothing else pays for
/// it. No exception crosses the interface.
extern "C" {

/// Grey (1 channel) or blue, green, red (3 channels), 8 bits a sample.
struct unstep_opencv_image {
  std::int32_t width;
  std::int32_t height;
  std::int32_t channels;
  std::size_t stride;  ///< bytes from row to row
  const std::uint8_t* pixels;
  void* owner;
};

/// The revision of this interface that the module was built with.
int unstep_opencv_revision();

/// Decodes a file. 0, or 1 with a reason (one
/// line, cut to its buffer).
int unstep_opencv_decode(const std::uint8_t* bytes, std::size_t size,
                         unstep_opencv_image* image, char* reason,
                         std::size_t reason_size);

void unstep_opencv_release(unstep_opencv_image* image);

}  // extern "C"

namespace unstep {
inline constexpr int kOpencvModuleRevision = 1;
}
