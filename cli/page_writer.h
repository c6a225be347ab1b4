#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/options.h"
#include "cli/output_format.h"
#include "unstep/codec.h"
#include "unstep/formats.h"
#include "unstep/result.h"

/// Pages of any kind to a file of any format.
namespace unstep::cli {

/// Turns pages into the bytes of one file. Rasters get ink, drawn if need be;
/// vector formats get chains and paths, of ink its contours, one by one as they
/// are traced.
class PageWriter {
 public:
  /// `lines`: what ink and chains become on their way to a vector format.
  static Result<PageWriter> create(OutputFormat format, ByteSink sink,
                                   const LineOptions& lines, Effort effort,
                                   const DecodeLimits& limits);
  ~PageWriter();
  PageWriter(PageWriter&&) noexcept;
  PageWriter& operator=(PageWriter&&) noexcept;

  /// Appends what the format cannot carry, and what was decided, to `notes`.
  Status add(Page page, std::vector<std::string>& notes);
  Status finish();

 private:
  struct Impl;
  explicit PageWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace unstep::cli
