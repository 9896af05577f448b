// The door through which libFuzzer comes: LOOMLIGHT_FUZZER is one of fuzzers.h.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzzers.h"

extern "C" __attribute__((visibility("default"))) int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  loomlight::fuzz::LOOMLIGHT_FUZZER({reinterpret_cast<const char*>(data), size});
  return 0;
}
