#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "unstep/formats.h"
#include "unstep/result.h"

/// A file that writers of pages fill piece by piece.
namespace unstep::cli {

/// Created with the first bytes, so that a page that cannot be written leaves
/// an existing file alone; renamed to its name by commit().
class FileOutput {
 public:
  FileOutput(std::string path, bool force);

  /// Takes the bytes; must not outlive this object.
  [[nodiscard]] ByteSink sink();

  Status commit();

  /// What went wrong with the file itself so far.
  [[nodiscard]] const Status& status() const { return status_; }

 private:
  Status write(std::string_view bytes);

  std::string path_;
  bool force_;
  std::optional<FileWriter> file_;
  Status status_;
};

}  // namespace unstep::cli
