#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace unstep {

/// A number of a program, unless it depends on what only the control knows.
struct GcodeNumber {
  double value = 0;
  bool known = true;
};

/// What "#7" or "#<name>" says; names in capitals without blanks.
struct GcodeParameter {
  bool named = false;
  std::uint32_t number = 0;
  std::string name;
  bool known = true;  ///< else any number
};

/// The parameters that a program has set. LinuxCNC's scopes: a subroutine has
/// #1 ... #30 of its own, its arguments and then zeros, and its own names but
/// those that begin with "_".
class GcodeParameters {
 public:
  static constexpr std::size_t kArguments = 30;

  [[nodiscard]] GcodeNumber value_of(const GcodeParameter& parameter) const;
  /// EXISTS[]: what the program did not set the control may have, but no name
  /// of a scope.
  [[nodiscard]] GcodeNumber exists(const GcodeParameter& parameter) const;
  void assign(const GcodeParameter& target, const GcodeNumber& value);

  /// A call with these arguments, at most kArguments, and its end.
  void enter(std::span<const double> arguments);
  /// REQUIRES: a call has been entered.
  void leave();

 private:
  using Names = std::map<std::string, double, std::less<>>;
  struct Scope {
    std::array<std::optional<double>, kArguments> arguments;
    Names names;
  };
  [[nodiscard]] const Names& names_of(const std::string& name) const;

  std::unordered_map<std::uint32_t, double> numbered_;
  /// LinuxCNC has these two before any call.
  Names global_{{"_VALUE", 0}, {"_VALUE_RETURNED", 0}};
  Names local_;
  std::vector<Scope> callers_;
};

}  // namespace unstep
