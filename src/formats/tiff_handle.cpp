#include "formats/tiff_handle.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <exception>

namespace unstep {
namespace {

int keep_error(TIFF* /*tiff*/, void* data, const char* /*module*/,
               const char* format, va_list arguments) {
  auto* log = static_cast<TiffLog*>(data);
  if (!log->has_error()) {
    std::vsnprintf(log->error.data(), log->error.size(), format, arguments);
  }
  return 1;
}

int keep_warning(TIFF* /*tiff*/, void* data, const char* /*module*/,
                 const char* format, va_list arguments) {
  auto* log = static_cast<TiffLog*>(data);
  if (log->warning_count < log->warnings.size()) {
    TiffLog::Line& line = log->warnings[log->warning_count];
    std::vsnprintf(line.data(), line.size(), format, arguments);
  }
  ++log->warning_count;
  return 1;
}

tmsize_t read_input(thandle_t handle, void* out, tmsize_t size) {
  auto* input = static_cast<TiffInput*>(handle);
  if (size < 0 || input->position >= input->bytes.size()) return 0;
  const auto at = static_cast<std::size_t>(input->position);
  const std::size_t count =
      std::min(static_cast<std::size_t>(size), input->bytes.size() - at);
  std::memcpy(out, input->bytes.data() + at, count);
  input->position += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t write_nothing(thandle_t /*handle*/, void* /*data*/,
                       tmsize_t /*size*/) {
  return -1;
}

toff_t move(std::uint64_t& position, std::uint64_t size, toff_t offset,
            int whence) {
  if (whence == SEEK_SET) position = offset;
  if (whence == SEEK_CUR) position += offset;
  if (whence == SEEK_END) position = size + offset;
  return position;
}

toff_t seek_input(thandle_t handle, toff_t offset, int whence) {
  auto* input = static_cast<TiffInput*>(handle);
  return move(input->position, input->bytes.size(), offset, whence);
}

toff_t input_size(thandle_t handle) {
  return static_cast<TiffInput*>(handle)->bytes.size();
}

/// libtiff only reads what it "maps", but its interface has no const.
int map_input(thandle_t handle, void** base, toff_t* size) {
  auto* input = static_cast<TiffInput*>(handle);
  *base = const_cast<std::uint8_t*>(input->bytes.data());
  *size = input->bytes.size();
  return 1;
}

void unmap_input(thandle_t /*handle*/, void* /*base*/, toff_t /*size*/) {}

int close_nothing(thandle_t /*handle*/) { return 0; }

tmsize_t read_output(thandle_t handle, void* out, tmsize_t size) {
  auto* output = static_cast<TiffOutput*>(handle);
  TiffInput view{output->bytes, output->position};
  const tmsize_t count = read_input(&view, out, size);
  output->position = view.position;
  return count;
}

tmsize_t write_output(thandle_t handle, void* data, tmsize_t size) {
  auto* output = static_cast<TiffOutput*>(handle);
  if (size < 0) return -1;
  const auto count = static_cast<std::size_t>(size);
  const auto at = static_cast<std::size_t>(output->position);
  try {
    if (at + count > output->bytes.size()) output->bytes.resize(at + count);
  } catch (const std::exception&) {
    return -1;
  }
  std::memcpy(output->bytes.data() + at, data, count);
  output->position += count;
  return size;
}

toff_t seek_output(thandle_t handle, toff_t offset, int whence) {
  auto* output = static_cast<TiffOutput*>(handle);
  return move(output->position, output->bytes.size(), offset, whence);
}

toff_t output_size(thandle_t handle) {
  return static_cast<TiffOutput*>(handle)->bytes.size();
}

struct OptionsDeleter {
  void operator()(TIFFOpenOptions* options) const {
    TIFFOpenOptionsFree(options);
  }
};
using Options = std::unique_ptr<TIFFOpenOptions, OptionsDeleter>;

Options make_options(TiffLog& log) {
  Options options(TIFFOpenOptionsAlloc());
  if (options != nullptr) {
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_error, &log);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keep_warning, &log);
  }
  return options;
}

}  // namespace

TiffHandle open_tiff_input(TiffInput& input, TiffLog& log,
                           std::uint64_t max_bytes) {
  const Options options = make_options(log);
  if (options == nullptr) return nullptr;
  constexpr std::uint64_t kMax = INT64_MAX;
  TIFFOpenOptionsSetMaxSingleMemAlloc(
      options.get(), static_cast<tmsize_t>(std::min(max_bytes, kMax)));
  return TiffHandle(TIFFClientOpenExt(
      "memory", "r", &input, read_input, write_nothing, seek_input,
      close_nothing, input_size, map_input, unmap_input, options.get()));
}

TiffHandle open_tiff_output(TiffOutput& output, TiffLog& log) {
  const Options options = make_options(log);
  if (options == nullptr) return nullptr;
  return TiffHandle(TIFFClientOpenExt(
      "memory", "wl", &output, read_output, write_output, seek_output,
      close_nothing, output_size, nullptr, nullptr, options.get()));
}

}  // namespace unstep
