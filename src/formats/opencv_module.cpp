#include "formats/opencv_module.h"

#include <algorithm>
#include <climits>
#include <cstdio>
#include <exception>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

namespace {

int fail(char* reason, std::size_t size, const std::string& text) {
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::snprintf(reason, size, "%s", line.c_str());
  return 1;
}

}  // namespace

int unstep_opencv_revision() { return unstep::kOpencvModuleRevision; }

int unstep_opencv_decode(const std::uint8_t* bytes, std::size_t size,
                         unstep_opencv_image* image, char* reason,
                         std::size_t reason_size) {
  try {
    if (size > INT_MAX) return fail(reason, reason_size, "file above 2 GiB");
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    // cv::Mat has no const data; imdecode only reads it.
    const cv::Mat input(1, static_cast<int>(size), CV_8UC1,
                        const_cast<std::uint8_t*>(bytes));
    auto decoded =
        std::make_unique<cv::Mat>(cv::imdecode(input, cv::IMREAD_ANYCOLOR));
    if (decoded->empty()) {
      return fail(reason, reason_size, "OpenCV cannot decode the image");
    }
    if (decoded->depth() != CV_8U ||
        (decoded->channels() != 1 && decoded->channels() != 3)) {
      return fail(reason, reason_size, "unexpected kind of pixels");
    }
    image->width = decoded->cols;
    image->height = decoded->rows;
    image->channels = decoded->channels();
    image->stride = decoded->step[0];
    image->pixels = decoded->data;
    image->owner = decoded.release();
    return 0;
  } catch (const std::exception& error) {
    return fail(reason, reason_size, error.what());
  }
}

void unstep_opencv_release(unstep_opencv_image* image) {
  delete static_cast<cv::Mat*>(image->owner);
  image->owner = nullptr;
}
