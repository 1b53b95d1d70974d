// Any bytes are a picture or an error, never a crash.

#include "renderer/image/image.hpp"

#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  try {
    rt::decode({reinterpret_cast<const char*>(data), size}, "fuzz");
  } catch (const std::runtime_error&) {
  }
  return 0;
}
