#include "formats/gcode_parameters.h"

#include <utility>

namespace unstep {
namespace {

bool is_global(const std::string& name) { return name.starts_with('_'); }

}  // namespace

const GcodeParameters::Names& GcodeParameters::names_of(
    const std::string& name) const {
  return is_global(name) ? global_ : local_;
}

GcodeNumber GcodeParameters::value_of(const GcodeParameter& parameter) const {
  if (!parameter.known) return {0, false};
  if (parameter.named) {
    const Names& names = names_of(parameter.name);
    const auto found = names.find(parameter.name);
    return found == names.end() ? GcodeNumber{0, false}
                                : GcodeNumber{found->second, true};
  }
  const auto found = numbered_.find(parameter.number);
  return found == numbered_.end() ? GcodeNumber{0, false}
                                  : GcodeNumber{found->second, true};
}

GcodeNumber GcodeParameters::exists(const GcodeParameter& parameter) const {
  if (value_of(parameter).known) return {1, true};
  return {0, parameter.known && parameter.named && !is_global(parameter.name)};
}

void GcodeParameters::assign(const GcodeParameter& target,
                             const GcodeNumber& value) {
  if (!target.known) {
    // Any of them may have changed.
    numbered_.clear();
  } else if (target.named) {
    Names& names = is_global(target.name) ? global_ : local_;
    if (value.known) {
      names[target.name] = value.value;
    } else {
      names.erase(target.name);
    }
  } else if (value.known) {
    numbered_[target.number] = value.value;
  } else {
    numbered_.erase(target.number);
  }
}

void GcodeParameters::enter(std::span<const double> arguments) {
  Scope& caller = callers_.emplace_back();
  caller.names = std::exchange(local_, {});
  for (std::size_t i = 0; i < kArguments; ++i) {
    const auto number = static_cast<std::uint32_t>(i + 1);
    const auto found = numbered_.find(number);
    if (found != numbered_.end()) caller.arguments[i] = found->second;
    numbered_[number] = i < arguments.size() ? arguments[i] : 0;
  }
}

void GcodeParameters::leave() {
  Scope& caller = callers_.back();
  local_ = std::move(caller.names);
  for (std::size_t i = 0; i < kArguments; ++i) {
    const auto number = static_cast<std::uint32_t>(i + 1);
    if (caller.arguments[i]) {
      numbered_[number] = *caller.arguments[i];
    } else {
      numbered_.erase(number);
    }
  }
  callers_.pop_back();
}

}  // namespace unstep
