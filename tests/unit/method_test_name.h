#pragma once

#include <gtest/gtest.h>

#include <string>

#include "unstep/interpolate.h"

namespace unstep::oracle {

/// The name of a parameter of a value-parametrised test.
inline std::string test_name(const testing::TestParamInfo<Method>& parameter) {
  std::string name(method_info(parameter.param).name);
  std::erase(name, '-');
  return name;
}

}  // namespace unstep::oracle
