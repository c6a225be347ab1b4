#pragma once

#include <string_view>
#include <vector>

#include "unstep/formats.h"

/// The readers of vector formats; read_vector chooses among them.
namespace unstep {

Result<std::vector<VectorPage>> read_svg(std::string_view bytes,
                                         const VectorReadOptions& options);
Result<std::vector<VectorPage>> read_dxf(std::string_view bytes,
                                         const VectorReadOptions& options);
Result<std::vector<VectorPage>> read_hpgl(std::string_view bytes,
                                          const VectorReadOptions& options);
Result<std::vector<VectorPage>> read_json(std::string_view bytes,
                                          const VectorReadOptions& options);

}  // namespace unstep
