#pragma once

#include <optional>
#include <string>

#include "unstep/codec.h"
#include "unstep/result.h"

/// Where two programs differ. What is not understood is left out.
namespace unstep::cli {

/// The first motion that differs, in words; nothing if none does.
/// REQUIRES: both pages are programs.
[[nodiscard]] std::optional<std::string> first_motion(const Page& a,
                                                      const Page& b);

/// A program measured against the one that it stands for.
struct ProgramVerdict {
  bool within = false;
  /// "deviates by up to 0.00431 mm, of 0.005 mm allowed, at (12.3, 4.5, -1),
  /// line 204", or what else differs.
  std::string text;
};
/// REQUIRES: both pages are programs. out_of_range for the bound.
Result<ProgramVerdict> judge_program(const Page& original, const Page& shorter,
                                     double bound_mm);

}  // namespace unstep::cli
