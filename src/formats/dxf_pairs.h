#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "unstep/result.h"

namespace unstep {

/// A group of an ASCII DXF file: a code and a value, a line each.
struct DxfPair {
  int code = 0;
  std::string_view value;
};

/// The groups from one "0" group to the next: an entity, a table entry, the
/// begin of a section.
class DxfRecord {
 public:
  std::string_view kind;
  std::uint64_t line = 0;
  std::vector<DxfPair> pairs;

  /// The first value of that code.
  [[nodiscard]] std::optional<std::string_view> text(int code) const;
  [[nodiscard]] double real(int code, double missing) const;
  [[nodiscard]] int integer(int code, int missing) const;
};

[[nodiscard]] std::optional<double> dxf_number(std::string_view value);

/// Walks the records of a file, comments left out.
class DxfRecords {
 public:
  /// A place to come back to.
  struct Place {
    std::size_t offset = 0;
    std::uint64_t line = 0;
  };

  explicit DxfRecords(std::string_view text) : text_(text) {}

  [[nodiscard]] Place place() const { return place_; }
  void go_to(Place place) { place_ = place; }

  /// bad_magic if the text does not begin with a group, corrupt for a code that
  /// is no number, truncated at the end of the text.
  Status next(DxfRecord& record);

 private:
  std::optional<std::string_view> line();
  /// False at the end of the text.
  Result<bool> pair(DxfPair& pair);

  std::string_view text_;
  Place place_;
};

}  // namespace unstep
