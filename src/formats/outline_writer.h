#pragma once

#include "formats/format_writer.h"

namespace unstep {

/// Grid units that a written arc may deviate by for a short text.
inline constexpr double kArcLimit = 1.0 / 1024;

/// A format that draws outlines, chains as well as paths, its y growing to one
/// side whatever the drawing's does.
class OutlineWriter : public FormatWriter {
 public:
  explicit OutlineWriter(YAxis axis) : axis_(axis) {}

  Status begin_page(const PageHead& head) final;
  Status add(const Path& path) final;
  Status add(const Chain& chain) final;

 protected:
  /// The box is in the y direction of the format.
  virtual Status begin(const PageHead& head) = 0;
  virtual Status draw(const Outline& outline) = 0;

 private:
  YAxis axis_;
  YAxis drawing_axis_ = YAxis::down;
  std::int32_t scale_ = 1;
  Frame frame_;
  Outline outline_;  ///< reused
};

}  // namespace unstep
