// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "test/stress/io/pipeline.h"
#include "test/stress/io/suites.h"
#include "test/stress/text.h"
#include "test/support/readers.h"

namespace sinkmesh::stress {
namespace {

constexpr std::array kPieces{"\n",   " ",   "-",     "#",      "\"", "<",  ">",     "0",
                             "9",    "1e",  "1e999", "nan",    "\t", "\r", "-1",    "4294967296",
                             "\xff", "inf", "0x1p3", "1e-400", "$",  ",",  "end\n", "3 0 1 2\n"};
constexpr std::array kNumbers{"0",     "1",      "2",          "3",          "4",
                              "-1",    "5",      "1.5",        "-0.0",       "4294967295",
                              "1e308", "1e-308", "2147483648", "1e22",       "9007199254740993",
                              "nan",   "7",      "10",         "4294967296", "18446744073709551615"};

/// [first, last)
struct Range {
  std::size_t first;
  std::size_t last;
};

std::vector<Range> lines_of(const std::string& bytes) {
  std::vector<Range> lines;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
    lines.push_back({at, end});
    at = end;
  }
  return lines;
}

std::vector<Range> numbers_of(const std::string& bytes) {
  constexpr std::string_view kPartOfNumber = "0123456789.eE+-";
  std::vector<Range> numbers;
  for (std::size_t at = bytes.find_first_of("0123456789"); at != std::string::npos;) {
    const std::size_t end = std::min(bytes.find_first_not_of(kPartOfNumber, at), bytes.size());
    numbers.push_back({at, end});
    at = bytes.find_first_of("0123456789", end);
  }
  return numbers;
}

std::string part(const std::string& bytes, const Range& range) {
  return bytes.substr(range.first, range.last - range.first);
}

enum Edit : std::size_t {
  kFlip,
  kTruncate,
  kInsert,
  kErase,
  kNumber,
  kSwapLines,
  kRepeatLine,
  kDropLine,
  kEdits
};

/// One change. Places beyond the end begin anew, so that any three numbers mean something.
void edit(std::string& bytes, std::size_t what, std::size_t at, std::size_t how) {
  if (bytes.empty()) return;
  const std::size_t place = at % bytes.size();
  switch (what % kEdits) {
    case kFlip:
      bytes[place] = static_cast<char>(bytes[place] ^ (1U << how % 8));
      break;
    case kTruncate:
      bytes.resize(place);
      break;
    case kInsert:
      bytes.insert(at % (bytes.size() + 1), kPieces[how % kPieces.size()]);
      break;
    case kErase:
      bytes.erase(place, 1 + how % 16);
      break;
    case kNumber: {
      const auto numbers = numbers_of(bytes);
      if (numbers.empty()) break;
      const Range number = numbers[at % numbers.size()];
      bytes.replace(number.first, number.last - number.first, kNumbers[how % kNumbers.size()]);
      break;
    }
    case kSwapLines:
    case kRepeatLine: {
      const auto lines = lines_of(bytes);
      Range a = lines[at % lines.size()];
      Range b = lines[how % lines.size()];
      if (a.first > b.first) std::swap(a, b);
      if (what % kEdits == kRepeatLine) {
        bytes.insert(a.first, part(bytes, b));
      } else if (a.first != b.first) {
        bytes = bytes.substr(0, a.first) + part(bytes, b) + part(bytes, {a.last, b.first}) + part(bytes, a) +
                bytes.substr(b.last);
      }
      break;
    }
    default: {
      const auto lines = lines_of(bytes);
      const Range line = lines[at % lines.size()];
      bytes.erase(line.first, line.last - line.first);
    }
  }
}

/// A case is a sample and edits, one in each row.
class DamageSuite : public Suite {
 public:
  std::string name() const override { return "damage"; }

  void generate(Random& random, Case& c) override {
    const auto& sample = samples_[random() % samples_.size()];
    c.set("sample", sample.name);
    c.rows.clear();
    const int edits = random() % 2 == 0 ? 1 : test::uniform_int(random, 2, 5);
    for (int i = 0; i < edits; ++i) {
      c.rows.push_back({static_cast<double>(random() % kEdits),
                        static_cast<double>(random() % (sample.bytes.size() + 1)),
                        static_cast<double>(random() % 1024)});
    }
  }

  bool accepts(const Case& c) const override {
    return find(c) != nullptr && std::all_of(c.rows.begin(), c.rows.end(), [](const auto& row) {
             return row.size() == 3 && std::all_of(row.begin(), row.end(), [](double x) {
                      return 0 <= x && x < 0x1p32 && x == std::floor(x);
                    });
           });
  }

  std::string check(const Case& c, Counters& counters) override {
    const test::SampleFile& sample = *find(c);
    std::string bytes = sample.bytes;
    for (const auto& row : c.rows) {
      edit(bytes, static_cast<std::size_t>(row[0]), static_cast<std::size_t>(row[1]),
           static_cast<std::size_t>(row[2]));
    }
    // Without a byte to spare, so that the sanitizers see any step beyond the end.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    const test::Reading reading =
        test::read_bytes(test::reader_named(sample.reader), {exact.data(), exact.size()});
    ++counters.comparisons;
    if (!reading.defect.empty()) return "reader: " + reading.defect + ": " + reading.message;
    ++counters.named[reading.contents ? 0 : 1];
    if (reading.contents) expect_usable(*reading.contents, counters);
    return "";
  }

  std::vector<NamedCounter> counters() const override { return {{"read", 0.1}, {"refused", 0.3}}; }

 private:
  const test::SampleFile* find(const Case& c) const {
    const auto found = std::find_if(samples_.begin(), samples_.end(),
                                    [&](const auto& sample) { return sample.name == c.setting("sample"); });
    return found == samples_.end() ? nullptr : &*found;
  }

  const std::vector<test::SampleFile> samples_ = test::sample_files();
};

}  // namespace

std::unique_ptr<Suite> make_damage_suite() { return std::make_unique<DamageSuite>(); }

}  // namespace sinkmesh::stress
