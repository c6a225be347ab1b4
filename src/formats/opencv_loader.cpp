#include "formats/opencv_loader.h"

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <mutex>
#include <string>
#include <utility>

namespace unstep {
namespace {

constexpr const char* kModuleName = "unstep_opencv.so";

struct Module {
  decltype(&unstep_opencv_decode) decode = nullptr;
  decltype(&unstep_opencv_release) release = nullptr;
};

#ifdef UNSTEP_MODULE_INSTALL_DIR
/// The folder of the library or program that holds this code.
std::string own_folder() {
  static const char anchor = 0;
  Dl_info about{};
  if (::dladdr(&anchor, &about) == 0 || about.dli_fname == nullptr) return {};
  const std::string path = about.dli_fname;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}
#endif

/// Where the module may be, first choice first.
std::vector<std::string> module_folders() {
  std::vector<std::string> folders;
  if (const char* chosen = std::getenv("UNSTEP_MODULE_DIR");
      chosen != nullptr && *chosen != '\0') {
    folders.emplace_back(chosen);
  }
#ifdef UNSTEP_MODULE_INSTALL_DIR
  if (const std::string own = own_folder(); !own.empty()) {
    folders.push_back(own + "/unstep");
    folders.push_back(own + "/" UNSTEP_MODULE_RELATIVE_DIR);
  }
  folders.emplace_back(UNSTEP_MODULE_BUILD_DIR);
  folders.emplace_back(UNSTEP_MODULE_INSTALL_DIR);
#endif
  return folders;
}

/// Null if it is not there or of another revision.
void* open_module(const std::string& path, std::string& reason) {
  void* handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* error = ::dlerror();
    reason = error != nullptr ? error : "cannot load " + path;
    return nullptr;
  }
  const auto revision = reinterpret_cast<decltype(&unstep_opencv_revision)>(
      ::dlsym(handle, "unstep_opencv_revision"));
  if (revision == nullptr || revision() != kOpencvModuleRevision) {
    reason = path + " is of another version";
    ::dlclose(handle);
    return nullptr;
  }
  return handle;
}

Result<Module> load_module() {
  static std::mutex mutex;
  static Module module;
  const std::lock_guard lock(mutex);
  if (module.decode != nullptr) return module;
  std::string reason = "built without it";
  for (const std::string& folder : module_folders()) {
    void* handle = open_module(folder + "/" + kModuleName, reason);
    if (handle == nullptr) continue;
    const auto decode = reinterpret_cast<decltype(module.decode)>(
        ::dlsym(handle, "unstep_opencv_decode"));
    const auto release = reinterpret_cast<decltype(module.release)>(
        ::dlsym(handle, "unstep_opencv_release"));
    if (decode == nullptr || release == nullptr) continue;
    module = {decode, release};
    return module;
  }
  return Error{ErrorCode::unsupported,
               "BMP and JPEG need the OpenCV module, which cannot be loaded (" +
                   reason + "); UNSTEP_MODULE_DIR names its folder"};
}

}  // namespace

Result<OpencvImage> OpencvImage::decode(std::span<const std::uint8_t> bytes) {
  const Result<Module> module = load_module();
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
  if (const Result<Module> module = load_module(); module) {
    module->release(&image_);
  }
}

Status OpencvImage::start() {
  y_ = 0;
  return {};
}

Status OpencvImage::next(std::span<Colour> row) {
  const std::uint8_t* pixel = image_.pixels + image_.stride * y_++;
  constexpr auto widen = [](unsigned sample) { return sample * 257; };
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
