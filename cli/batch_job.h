#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/file_set.h"
#include "cli/options.h"
#include "cli/output_format.h"
#include "cli/pack.h"
#include "unstep/codec.h"

/// One file of a batch.
namespace unstep::cli {

/// File metadata that a batch leaves in what it writes, so that --resume knows
/// which source a finished file came from.
inline constexpr const char* kSourceSizeKey = "unstep:source-size";
inline constexpr const char* kSourceCrcKey = "unstep:source-crc32";

struct JobOptions {
  std::string output_folder;
  InputOptions read;
  PackOptions pack;
  std::optional<OutputFormat> to;  ///< decompressing: instead of by name
  int jobs = 1;                    ///< threads for one file
  bool force = false;
  bool resume = false;
  bool record = true;  ///< store the source's size and CRC
};

struct JobResult {
  enum class Status : std::uint8_t { not_run, done, skipped, failed };
  Status status = Status::not_run;
  std::vector<std::string> outputs;
  std::uint64_t input_bytes = 0;
  std::uint64_t output_bytes = 0;
  std::uint64_t pages = 0;
  std::uint64_t pixels = 0;
  bool lossless = true;
  std::vector<std::string> pixel_work;  ///< Packed
  std::vector<std::string> notes;
  std::string failed_path;  ///< what the error is about: input or output
  Error error;
};

/// The outputs of one batch, so that no two inputs write to one name. Safe to
/// use from several threads.
class Claims {
 public:
  /// False if the path was claimed before.
  bool claim(const std::string& path);

 private:
  std::mutex mutex_;
  std::set<std::string> paths_;
};

/// Writes the .ustp file of one drawing: NAME becomes NAME.ustp.
JobResult compress_job(const BatchInput& input, const JobOptions& options,
                       const Listener& listener);

/// The way back: NAME.ustp becomes NAME if NAME ends in .png, .pbm, .tif,
/// .tiff or .fc and that format holds the pages; otherwise NAME.png, .tif or
/// .fc as natural_format() says.
JobResult decompress_job(const BatchInput& input, const JobOptions& options,
                         Claims& claims, const Listener& listener);

}  // namespace unstep::cli
