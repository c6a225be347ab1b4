#pragma once

#include <cstddef>

#include "unstep/codec.h"
#include "unstep/result.h"

/// Pages of any kind on their way into a .ustp file.
namespace unstep::cli {

Status store_page(UstpWriter& writer, const Page& page);

/// Bytes of a file of this page alone.
Result<std::size_t> stored_size(const Page& page, Effort effort);

}  // namespace unstep::cli
