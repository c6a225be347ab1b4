#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "formats/colour_rows.h"
#include "formats/opencv_module.h"
#include "unstep/result.h"

namespace unstep {

/// An image decoded by the OpenCV module, as rows.
class OpencvImage final : public ColourRows {
 public:
  /// Loads the module if it is not loaded. unsupported if it cannot be had,
  /// corrupt if OpenCV refuses the bytes.
  static Result<OpencvImage> decode(std::span<const std::uint8_t> bytes);
  ~OpencvImage() override;
  OpencvImage(OpencvImage&& other) noexcept;
  OpencvImage& operator=(OpencvImage&&) = delete;

  [[nodiscard]] std::int32_t width() const { return image_.width; }
  [[nodiscard]] std::int32_t height() const { return image_.height; }
  Status start() override;
  Status next(std::span<Colour> row) override;

 private:
  OpencvImage() = default;

  unstep_opencv_image image_{};
  std::size_t y_ = 0;
};

}  // namespace unstep
