#include "formats/imaging_loader.h"

#include <array>
#include <mutex>

#include "formats/imaging_module.h"
#include "formats/module_loader.h"

namespace unstep::imaging {
namespace {

struct ImagingModule {
  decltype(&unstep_imaging_threshold) threshold = nullptr;
  decltype(&unstep_imaging_skew) skew = nullptr;
  decltype(&unstep_imaging_turn) turn = nullptr;
  decltype(&unstep_imaging_remove) remove = nullptr;
};

Result<ImagingModule> imaging_module() {
  static std::mutex mutex;
  static ImagingModule module;
  const std::lock_guard lock(mutex);
  if (module.threshold != nullptr) return module;
  const Result<void*> handle = load_module(
      "unstep_imaging.so", "unstep_imaging_revision", kImagingModuleRevision,
      "local thresholds, deskew, despeckle and fill-holes need");
  if (!handle) return handle.error();
  module = {module_function<decltype(unstep_imaging_threshold)>(
                *handle, "unstep_imaging_threshold"),
            module_function<decltype(unstep_imaging_skew)>(
                *handle, "unstep_imaging_skew"),
            module_function<decltype(unstep_imaging_turn)>(
                *handle, "unstep_imaging_turn"),
            module_function<decltype(unstep_imaging_remove)>(
                *handle, "unstep_imaging_remove")};
  return module;
}

/// Calls a function of the module with a reason.
template <class Call>
Status call(const Call& function) {
  const Result<ImagingModule> module = imaging_module();
  if (!module) return module.error();
  std::array<char, 300> reason{};
  if (function(*module, unstep_reason{reason.data(), reason.size()}) == 0) {
    return {};
  }
  return Error{ErrorCode::limit_exceeded,
               "OpenCV: " + std::string(reason.data())};
}

unstep_plane plane_of(GreyPage& grey) {
  return {grey.width(), grey.height(), static_cast<std::size_t>(grey.width()),
          grey.pixels().data()};
}

unstep_bits bits_of(Bitmap& ink) {
  return {ink.width(), ink.height(), ink.words_per_row(), ink.row(0).data()};
}

}  // namespace

Result<PageLight> threshold(GreyPage& grey, Threshold::Kind kind, Bitmap& ink) {
  const std::int32_t method =
      kind == Threshold::Kind::sauvola ? UNSTEP_METHOD_SAUVOLA
      : kind == Threshold::Kind::local ? UNSTEP_METHOD_LOCAL
                                       : UNSTEP_METHOD_LOCAL_IF_FIT;
  const unstep_plane plane = plane_of(grey);
  unstep_bits bits = bits_of(ink);
  unstep_page_light light{};
  Status done = call([&](const ImagingModule& module, unstep_reason reason) {
    return module.threshold(&plane, method, &light, &bits, reason);
  });
  if (!done) return done.error();
  return PageLight{light.noise, light.contrast, light.darkest, light.lightest,
                   light.fits != 0};
}

Result<double> skew(GreyPage& grey, int level) {
  const unstep_plane plane = plane_of(grey);
  double degrees = 0;
  Status done = call([&](const ImagingModule& module, unstep_reason reason) {
    return module.skew(&plane, level, &degrees, reason);
  });
  if (!done) return done.error();
  return degrees;
}

Status turn(GreyPage& grey, double degrees, std::uint8_t paper, GreyPage& out) {
  const unstep_plane plane = plane_of(grey);
  unstep_plane turned = plane_of(out);
  return call([&](const ImagingModule& module, unstep_reason reason) {
    return module.turn(&plane, degrees, paper, &turned, reason);
  });
}

Result<Removed> remove_small_pieces(Bitmap& ink, std::uint64_t area,
                                    bool of_paper) {
  unstep_bits bits = bits_of(ink);
  Removed removed;
  Status done = call([&](const ImagingModule& module, unstep_reason reason) {
    return module.remove(&bits, area, of_paper ? 1 : 0, &removed.pieces,
                         &removed.pixels, reason);
  });
  if (!done) return done.error();
  return removed;
}

}  // namespace unstep::imaging
