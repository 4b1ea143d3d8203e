// SPDX-License-Identifier: MIT
//
// Damaged files: whatever bytes are lost or changed, a reader returns something valid or throws FileError. It
// neither crashes nor hangs, and what a count claims is not allocated unless the bytes for it are there.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <new>
#include <random>

#include "test/support/sample_files.h"

namespace {

// The largest single allocation since it was last set to 0.
std::atomic<std::size_t> largest_allocation{0};

}  // namespace

// Not inlined: the compiler would take the two halves for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (size > largest_allocation) largest_allocation = size;
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const memory = operator new(size, std::nothrow);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace sinkmesh {
namespace {

using io_detail::Source;
using test::sample_mesh;
using test::sample_polygon;
using test::sample_surface;

template <std::size_t Dim, class Cells>
void check_arrays(const std::vector<std::array<double, Dim>>& points, const Cells& cells) {
  for (const auto& p : points) {
    for (const double x : p) ASSERT_TRUE(std::isfinite(x));
  }
  for (const auto& cell : cells) {
    for (const std::uint32_t v : cell) ASSERT_LT(v, points.size());
  }
}

void check(const Mesh3& mesh) {
  check_arrays(mesh.points, mesh.simplices);
  check_arrays(mesh.points, mesh.boundary);
  for (const auto& field : mesh.simplex_fields) ASSERT_EQ(field.values.size(), mesh.simplices.size());
}

void check_lines(const SourceLines& lines, std::size_t points, std::size_t facets, std::string_view bytes) {
  ASSERT_TRUE(lines.points.empty() || lines.points.size() == points);
  ASSERT_TRUE(lines.facets.empty() || lines.facets.size() == facets);
  const auto last = static_cast<std::size_t>(
      1 + std::count_if(bytes.begin(), bytes.end(), [](char c) { return c == '\n' || c == '\r'; }));
  for (const std::size_t line : lines.points) ASSERT_TRUE(1 <= line && line <= last);
  for (const std::size_t line : lines.facets) ASSERT_TRUE(1 <= line && line <= last);
}

using Decode = std::function<void(const Source&)>;

Decode surface_decoder(Surface3 (*decode)(const Source&)) {
  return [decode](const Source& source) {
    SourceLines lines;
    const Surface3 surface = decode({source.bytes, source.file, &lines});
    check_arrays(surface.points, surface.facets);
    check_lines(lines, surface.points.size(), surface.facets.size(), source.bytes);
  };
}
Decode mesh_decoder(Mesh3 (*decode)(const Source&)) {
  return [decode](const Source& source) { check(decode(source)); };
}

struct Sample {
  std::string name;
  std::string bytes;
  Decode decode;
};

void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

std::vector<Sample> samples() {
  const Surface3 surface = sample_surface();
  const Mesh3 mesh = sample_mesh();
  const auto decode_points = [](const Source& source) {
    SourceLines lines;
    const auto points = io_detail::decode_xyz<3>({source.bytes, source.file, &lines});
    check_arrays(points, std::vector<std::array<std::uint32_t, 3>>());
    check_lines(lines, points.size(), 0, source.bytes);
  };
  const auto decode_node = [](const Source& source) {
    check_arrays(io_detail::decode_node<3>(source).points, std::vector<std::array<std::uint32_t, 3>>());
  };
  const auto decode_ele = [points = mesh.points](const Source& source) {
    Mesh3 result;
    result.points = points;
    io_detail::decode_ele<3>(source, 0, result);
    check(result);
  };
  const auto decode_face = [points = mesh.points](const Source& source) {
    Mesh3 result;
    result.points = points;
    io_detail::decode_face<3>(source, 0, result);
    check(result);
  };
  const auto decode_poly = [](const Source& source) {
    const Surface2 polygon = io_detail::decode_poly(source, std::nullopt);
    check_arrays(polygon.points, polygon.facets);
  };
  const Decode off = surface_decoder(io_detail::decode_off);
  const Decode stl = surface_decoder(io_detail::decode_stl);
  const Decode ply = surface_decoder(io_detail::decode_ply);
  const Decode vtk = mesh_decoder(io_detail::decode_vtk<3>);
  const Decode vtu = mesh_decoder(io_detail::decode_vtu<3>);
  const Decode msh = mesh_decoder(io_detail::decode_msh<3>);
  return {
      {"off", io_detail::encode_off(surface), off},
      {"coff", "COFF # colors\r\n3 1 0\r\n0 0 0 1 1 1 1\r\n1 0 0 1 1 1 1\r\n0 1 0 1 1 1 1\r\n3 0 1 2 255 0 0",
       off},
      {"obj", "mtllib a.mtl\nvn 0 0 1\n" + io_detail::encode_obj(surface) + "f -1/2/3 -2//1 -3\n",
       surface_decoder(io_detail::decode_obj)},
      {"stl_text", io_detail::encode_stl(surface), stl},
      {"stl_binary", test::binary_stl(surface, "solid, and yet binary"), stl},
      {"ply_text", test::text_ply(surface), ply},
      {"ply_little", test::binary_ply(surface, std::endian::little), ply},
      {"ply_big", test::binary_ply(surface, std::endian::big), ply},
      {"ply_written", io_detail::encode_ply(surface), ply},
      {"xyz", "x,y,z,w\n0,0,0,a\n1e0, -2.5e-3 ,+3;b\n4\t5\t6\tc\n", decode_points},
      {"node", io_detail::encode_node<3>(mesh.points), decode_node},
      {"ele", io_detail::encode_ele(mesh), decode_ele},
      {"face", io_detail::encode_face(mesh), decode_face},
      {"poly", io_detail::encode_poly(sample_polygon()), decode_poly},
      {"medit", io_detail::encode_medit(mesh), mesh_decoder(io_detail::decode_medit<3>)},
      {"msh41", io_detail::encode_msh41(mesh), msh},
      {"msh22", io_detail::encode_msh22(mesh), msh},
      {"vtk_text", io_detail::encode_vtk(mesh), vtk},
      {"vtk_binary_3", test::binary_vtk(mesh, 3), vtk},
      {"vtk_binary_5", test::binary_vtk(mesh, 5), vtk},
      {"vtu_written", io_detail::encode_vtu(mesh), vtu},
      {"vtu_text", test::vtu(mesh, test::VtuEncoding::text), vtu},
      {"vtu_base64", test::vtu(mesh, test::VtuEncoding::base64), vtu},
      {"vtu_appended_base64", test::vtu(mesh, test::VtuEncoding::appended_base64), vtu},
      {"vtu_appended_raw", test::vtu(mesh, test::VtuEncoding::appended_raw_big), vtu},
  };
}

class Damage : public ::testing::TestWithParam<Sample> {
 protected:
  /// @return whether the bytes were accepted.
  static bool read(const std::string& bytes) {
    // A copy without a byte to spare, so that the sanitizers see any step beyond its end.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    largest_allocation = 0;
    bool accepted = true;
    try {
      GetParam().decode({{exact.data(), exact.size()}, "file"});
    } catch (const FileError& error) {
      accepted = false;
      check_message(error.what());
    }
    // A facet in text takes few bytes more than its size in memory; vectors double.
    EXPECT_LE(largest_allocation, 65536 + 32 * bytes.size());
    return accepted;
  }

  static void check_message(const std::string& message) {
    EXPECT_TRUE(message.starts_with("file:")) << message;
    EXPECT_GT(message.size(), 25U) << message;
    EXPECT_LT(message.size(), 400U) << message;
    for (const char c : message) ASSERT_TRUE(c >= 0x20 && c < 0x7f) << message;
  }
};

TEST_P(Damage, TheWholeFileIsAccepted) { EXPECT_TRUE(read(GetParam().bytes)); }

TEST_P(Damage, TruncationAnywhere) {
  const std::string& bytes = GetParam().bytes;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    SCOPED_TRACE(size);
    read(bytes.substr(0, size));
    if (HasFatalFailure()) return;
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
      if (HasFatalFailure()) return;
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
      if (HasFatalFailure()) return;
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
      if (HasFatalFailure()) return;
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
        if (HasFatalFailure()) return;
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
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Damage, ::testing::ValuesIn(samples()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sinkmesh
