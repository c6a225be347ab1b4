#pragma once

#include <cstdint>
#include <string>

/// Numbers of G-code, as short as they can be.
namespace unstep {

/// Appends `number` / 1e7 without trailing zeros: "12.5", "-0.001", "3".
void append_number(std::string& out, std::int64_t number);

/// `number` / 1e7 rounded to so many decimals, 0..7; halves away from 0.
[[nodiscard]] std::int64_t round_number(std::int64_t number, int decimals);

}  // namespace unstep
