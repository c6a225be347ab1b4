#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "cli/content.h"
#include "unstep/codec.h"

/// What `info --json` says of a file.
namespace unstep::cli {

[[nodiscard]] nlohmann::ordered_json to_json(const std::string& path,
                                             const FileInfo& info,
                                             const Contents& held,
                                             std::uint64_t bytes);

}  // namespace unstep::cli
