#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "unstep/result.h"

/// What the verbs share on the way out.
namespace unstep::cli {

/// Refuses early what writing would refuse in the end: output_exists unless
/// `force`; invalid_argument if the output is the input itself.
Status may_write(const std::string& output, const std::string& input,
                 bool force);

/// JSON with an indent of two; bytes of file names that are not UTF-8 become
/// replacement characters.
[[nodiscard]] std::string dump(const nlohmann::ordered_json& json);

}  // namespace unstep::cli
