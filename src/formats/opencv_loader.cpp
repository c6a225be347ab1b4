#include "formats/opencv_loader.h"

#include <array>
#include <mutex>
#include <utility>

#include "formats/module_loader.h"

namespace unstep {
namespace {

struct OpencvModule {
  decltype(&unstep_opencv_decode) decode = nullptr;
  decltype(&unstep_opencv_release) release = nullptr;
};

Result<OpencvModule> opencv_module() {
  static std::mutex mutex;
  static OpencvModule module;
  const std::lock_guard lock(mutex);
  if (module.decode != nullptr) return module;
  const Result<void*> handle =
      load_module("unstep_opencv.so", "unstep_opencv_revision",
                  kOpencvModuleRevision, "BMP above 1 bit needs");
  if (!handle) return handle.error();
  using Decode = decltype(unstep_opencv_decode);
  using Release = decltype(unstep_opencv_release);
  module = {module_function<Decode>(*handle, "unstep_opencv_decode"),
            module_function<Release>(*handle, "unstep_opencv_release")};
  return module;
}

}  // namespace

Result<OpencvImage> OpencvImage::decode(std::span<const std::uint8_t> bytes) {
  const Result<OpencvModule> module = opencv_module();
  if (!module) return module.error();
  OpencvImage image;
  std::array<char, 300> reason{};
  if (module->decode(bytes.data(), bytes.size(), &image.image_, reason.data(),
                     reason.size()) != 0) {
    return Error{ErrorCode::corrupt, reason.data()};
  }
  return image;
}

OpencvImage::OpencvImage(OpencvImage&& other) noexcept
    : image_(std::exchange(other.image_, {})), y_(other.y_) {}

OpencvImage::~OpencvImage() {
  if (image_.owner == nullptr) return;
  // Loaded, because it made the image.
  if (const Result<OpencvModule> module = opencv_module(); module) {
    module->release(&image_);
  }
}

Status OpencvImage::start() {
  y_ = 0;
  return {};
}

Status OpencvImage::next(std::span<Colour> row) {
  const std::uint8_t* pixel = image_.pixels + image_.stride * y_++;
  for (Colour& colour : row) {
    if (image_.channels == 1) {
      colour = make_grey(widen(pixel[0]));
    } else {
      colour = make_colour(widen(pixel[2]), widen(pixel[1]), widen(pixel[0]));
    }
    pixel += image_.channels;
  }
  return {};
}

}  // namespace unstep
