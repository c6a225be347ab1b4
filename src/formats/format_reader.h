#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "unstep/formats.h"

/// The readers of vector formats; read_vector chooses among them.
namespace unstep {

/// So many kinds of what is left out are named, the rest is "other".
inline constexpr std::size_t kNamedKinds = 12;

Result<std::vector<VectorPage>> read_svg(std::string_view bytes,
                                         const VectorReadOptions& options);
Result<std::vector<VectorPage>> read_dxf(std::string_view bytes,
                                         const VectorReadOptions& options);
Result<std::vector<VectorPage>> read_hpgl(std::string_view bytes,
                                          const VectorReadOptions& options);
Result<std::vector<VectorPage>> read_json(std::string_view bytes,
                                          const VectorReadOptions& options);

}  // namespace unstep
