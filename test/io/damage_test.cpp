// SPDX-License-Identifier: MIT
//
// Damaged files: whatever bytes are lost or changed, a reader returns something valid or throws FileError. It
// neither crashes nor hangs, and what a count claims is not allocated unless the bytes for it are there.
#include <gtest/gtest.h>

#include <random>

#include "test/support/heap.h"
#include "test/support/readers.h"

namespace sinkmesh {
namespace test {

void PrintTo(const SampleFile& sample, std::ostream* out) { *out << sample.name; }

}  // namespace test
namespace {

using test::SampleFile;

class Damage : public ::testing::TestWithParam<SampleFile> {
 protected:
  /// @return whether the bytes were accepted.
  static bool read(const std::string& bytes) {
    // A copy without a byte to spare, so that the sanitizers see any step beyond its end.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    test::heap::forget_largest();
    const test::Reading reading =
        test::read_bytes(test::reader_named(GetParam().reader), {exact.data(), exact.size()});
    EXPECT_EQ(reading.defect, "") << reading.message;
    // A facet in text takes few bytes more than its size in memory; vectors double.
    EXPECT_LE(test::heap::largest(), 65536 + 32 * bytes.size());
    return reading.contents.has_value();
  }
};

TEST_P(Damage, TheWholeFileIsAccepted) { EXPECT_TRUE(read(GetParam().bytes)); }

TEST_P(Damage, TruncationAnywhere) {
  const std::string& bytes = GetParam().bytes;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    SCOPED_TRACE(size);
    read(bytes.substr(0, size));
    if (HasFailure()) return;
  }
}

TEST_P(Damage, AnyByteChanged) {
  std::string bytes = GetParam().bytes;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    SCOPED_TRACE(at);
    const char before = bytes[at];
    for (const int flip : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
      bytes[at] = static_cast<char>(before ^ flip);
      read(bytes);
      if (HasFailure()) return;
    }
    bytes[at] = before;
  }
}

TEST_P(Damage, AnyByteLostOrReplacedByWhatBreaksNumbers) {
  const std::string& bytes = GetParam().bytes;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    SCOPED_TRACE(at);
    for (const char* instead :
         {"", "9999999", "-1", "\n", " ", "#", "\"", "1e999", "99999999999999999999999"}) {
      read(std::string(bytes).replace(at, 1, instead));
      if (HasFailure()) return;
    }
  }
}

// Every number in the text becomes 2^60; what is allocated must not follow.
TEST_P(Damage, AnyNumberClaimsFarTooMuch) {
  const std::string& bytes = GetParam().bytes;
  constexpr std::string_view kDigits = "0123456789";
  for (std::size_t at = bytes.find_first_of(kDigits); at != std::string::npos;) {
    SCOPED_TRACE(at);
    const std::size_t end = std::min(bytes.find_first_not_of(kDigits, at), bytes.size());
    for (const char* claim : {"1152921504606846976", "4294967294", "4294967296", "18446744073709551615"}) {
      read(std::string(bytes).replace(at, end - at, claim));
      if (HasFailure()) return;
    }
    at = bytes.find_first_of(kDigits, end);
  }
}

TEST_P(Damage, AnyFourOrEightBytesClaimFarTooMuch) {
  const std::string& bytes = GetParam().bytes;
  for (const std::size_t width : {std::size_t{4}, std::size_t{8}}) {
    for (std::size_t at = 0; at + width <= bytes.size(); ++at) {
      SCOPED_TRACE(at);
      for (const char fill : {'\xff', '\x7f', '\x0f'}) {
        read(std::string(bytes).replace(at, width, width, fill));
        if (HasFailure()) return;
      }
    }
  }
}

TEST_P(Damage, PiecesMoved) {
  const std::string& bytes = GetParam().bytes;
  std::mt19937 random(11);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    std::string damaged = bytes;
    for (std::size_t n = 1 + below(3); n != 0; --n) {
      const std::size_t from = below(bytes.size());
      const std::size_t to = below(damaged.size() + 1);
      const std::string piece = bytes.substr(from, 1 + below(40));
      damaged.replace(to, below(2) == 0 ? 0 : std::min(piece.size(), damaged.size() - to), piece);
    }
    read(damaged);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Damage, ::testing::ValuesIn(test::sample_files()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sinkmesh
