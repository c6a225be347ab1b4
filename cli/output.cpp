#include "cli/output.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

namespace unstep::cli {

Status may_write(const std::string& output, const std::string& input,
                 bool force) {
  if (output == "-") return {};
  std::error_code failure;
  if (input != "-" && std::filesystem::equivalent(output, input, failure)) {
    return Error{ErrorCode::invalid_argument, "is the input itself"};
  }
  const auto status = std::filesystem::status(output, failure);
  if (std::filesystem::is_directory(status)) {
    return Error{ErrorCode::io_error, "is a folder"};
  }
  if (!force && std::filesystem::is_regular_file(status)) {
    return Error{ErrorCode::output_exists, "exists; --force overwrites it"};
  }
  return {};
}

std::string dump(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false,
                   nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace unstep::cli
