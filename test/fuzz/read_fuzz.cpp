// SPDX-License-Identifier: MIT
//
// The readers of one format, in space and in the plane, and what the rest of the project makes of the result.
#include <string>
#include <string_view>

#include "test/fuzz/check.h"
#include "test/stress/io/pipeline.h"
#include "test/support/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sinkmesh;
  constexpr std::string_view kFormat = SINKMESH_FUZZ_FORMAT;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  stress::Counters counters;
  for (const test::Reader& reader : test::kReaders) {
    if (reader.name != kFormat && reader.name != std::string(kFormat) + '2') continue;
    const test::Reading reading = test::read_bytes(reader, bytes);
    if (!reading.defect.empty()) fuzz::fail(reading.defect + ": " + reading.message);
    try {
      if (reading.contents) stress::expect_usable(*reading.contents, counters);
    } catch (const std::exception& error) {
      fuzz::fail(error.what());
    }
  }
  return 0;
}
