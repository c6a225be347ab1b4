#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "formats/colour_rows.h"
#include "unstep/codec.h"
#include "unstep/result.h"

namespace unstep {

/// The pixels of a JPEG file, decoded row by row by libjpeg. Whatever libjpeg
/// would go on from with pixels made up (coded data that end early, codes that
/// do not exist, bytes that belong to nothing) is an error.
class JpegRows final : public ColourRows {
 public:
  /// The bytes must outlive the object.
  explicit JpegRows(std::span<const std::uint8_t> bytes);
  ~JpegRows() override;
  JpegRows(const JpegRows&) = delete;
  JpegRows& operator=(const JpegRows&) = delete;

  /// Reads the header. limit_exceeded, out_of_range, or what is wrong with it.
  Status open(const DecodeLimits& limits);

  [[nodiscard]] std::int32_t width() const;
  [[nodiscard]] std::int32_t height() const;
  /// Bytes held while rows are read, the file's too.
  [[nodiscard]] std::uint64_t memory() const;
  /// What is odd but harmless, one line each.
  [[nodiscard]] const std::vector<std::string>& notes() const;

  Status start() override;
  Status next(std::span<Colour> row) override;
  /// Of YCbCr the Y as it is stored, which is Rec. 601's luminance.
  Status next_luminance(std::span<std::uint8_t> row) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unstep
