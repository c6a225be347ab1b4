#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "unstep/result.h"

namespace unstep {

/// A zlib stream, made piece by piece. After finish() the next begins.
class Deflater {
 public:
  Deflater();
  ~Deflater();
  Status add(std::string_view bytes, std::string& out);
  Status finish(std::string& out);

 private:
  struct Stream;
  Status run(std::string_view bytes, int flush, std::string& out);
  std::unique_ptr<Stream> stream_;
};

}  // namespace unstep
