#pragma once

#include <cstddef>
#include <cstdint>

#include "unstep/program.h"

namespace unstep {

/// Finds the lines that follow each other with nothing between that would have
/// to stay there: text, other motions, a change of feed, spindle or modes.
class RunFinder {
 public:
  /// `program` must outlive the finder. Extrusion per length may vary by the
  /// share `extrusion_tolerance` within a run.
  RunFinder(const Program& program, double extrusion_tolerance)
      : in_(program), extrusion_tolerance_(extrusion_tolerance) {}

  /// One past the last line of the run that begins with item `begin`; `begin`
  /// if it is none.
  [[nodiscard]] std::size_t run_end(std::size_t begin) const;

  /// Program units of filament between two items.
  [[nodiscard]] std::int64_t extruded(const ProgramItem& from,
                                      const ProgramItem& to) const;

 private:
  /// Extrusion per length so far.
  struct Extrusion {
    double length = 0;
    double amount = 0;
    bool any = false;
  };

  [[nodiscard]] const ProgramItem& before(std::size_t index) const;
  [[nodiscard]] bool others_rest(const ProgramItem& from,
                                 const ProgramItem& to) const;
  [[nodiscard]] bool is_mergeable(std::size_t index) const;
  bool continues(Extrusion& so_far, std::size_t index) const;

  const Program& in_;
  double extrusion_tolerance_;
};

}  // namespace unstep
