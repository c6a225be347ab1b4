#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "unstep/result.h"

/// Other programs that read what no library of ours does.
namespace unstep {

/// A folder of our own below $TMPDIR or /tmp, removed with all in it when the
/// object ends.
class TemporaryFolder {
 public:
  static Result<TemporaryFolder> create();
  ~TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

struct RunLimits {
  std::uint64_t output_bytes = 16U << 20;             ///< of what it prints
  std::uint64_t file_bytes = std::uint64_t{1} << 30;  ///< of a file it writes
  unsigned seconds = 600;                             ///< of a processor
};

/// Runs a program, found along $PATH, with these arguments (the first is its
/// name) and no shell, in the C locale, and returns what it printed.
/// unsupported if it is not installed; corrupt, with the first line of its
/// errors, if it fails; limit_exceeded.
Result<std::string> run_program(const std::vector<std::string>& arguments,
                                const RunLimits& limits);

}  // namespace unstep
