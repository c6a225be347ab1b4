#include "cli/file_output.h"

#include <cstdint>
#include <span>
#include <utility>

namespace unstep::cli {

FileOutput::FileOutput(std::string path, bool force)
    : path_(std::move(path)), force_(force) {}

ByteSink FileOutput::sink() {
  return [this](std::string_view bytes) {
    status_ = write(bytes);
    return status_;
  };
}

Status FileOutput::write(std::string_view bytes) {
  if (!file_) {
    Result<FileWriter> file = FileWriter::create(path_, force_);
    if (!file) return file.error();
    file_.emplace(std::move(*file));
  }
  return file_->write(
      {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

Status FileOutput::commit() {
  if (!file_) status_ = write({});
  if (status_) status_ = file_->commit();
  return status_;
}

}  // namespace unstep::cli
