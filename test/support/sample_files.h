// SPDX-License-Identifier: MIT
//
// One small file of every format and encoding that can be read, as bytes. All hold the same four points: a
// tetrahedron, or its surface.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "tools/io/detail/codecs.h"

namespace sinkmesh::test {

inline const std::vector<Point3>& sample_points() {
  static const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {-0.25, 0, 1}};
  return points;
}

inline Surface3 sample_surface() {
  return {sample_points(), {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}}}};
}

template <int Dim = 3>
Mesh<Dim> sample_mesh() {
  Mesh<Dim> mesh;
  if constexpr (Dim == 3) {
    mesh.points = sample_points();
    mesh.points.push_back({0.5, 0.5, 2});
    mesh.simplices = {{0, 1, 2, 3}, {1, 2, 3, 4}};
    mesh.boundary = {{0, 2, 1}, {0, 1, 3}};
  } else {
    mesh.points = {{0, 0}, {1, 0}, {0, 1.5}, {-0.25, 1}};
    mesh.simplices = {{0, 1, 2}, {0, 2, 3}};
    mesh.boundary = {{0, 1}, {1, 2}};
  }
  mesh.simplex_fields.push_back({"label", {7, -3}});
  return mesh;
}

inline Surface2 sample_polygon() { return {{{0, 0}, {1, 0}, {0, 1.5}}, {{{0, 1}}, {{1, 2}}, {{2, 0}}}}; }

/// The same with all that a .poly file can say.
inline Surface2 sample_regions() {
  Surface2 surface = sample_polygon();
  surface.points.push_back({5, 5});
  surface.facet_tags = {4, 5, -6};
  surface.seeds = {{{3, 3}}, {{{0.25, 0.25}, 2}}};
  return surface;
}

/// Bytes of numbers, in either order.
class Bytes {
 public:
  explicit Bytes(std::endian order) : order_(order) {}
  Bytes& text(std::string_view words) {
    out_ += words;
    return *this;
  }
  template <class T>
  Bytes& number(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    std::string bytes(raw, sizeof(T));
    if (order_ != std::endian::native) bytes.assign(bytes.rbegin(), bytes.rend());
    out_ += bytes;
    return *this;
  }
  const std::string& str() const { return out_; }

 private:
  std::string out_;
  std::endian order_;
};

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
    }
  }
  return out;
}

/// @param header  80 bytes are made of it.
inline std::string binary_stl(const Surface3& surface, std::string header) {
  header.resize(80, ' ');
  Bytes out(std::endian::little);
  out.text(header).number(static_cast<std::uint32_t>(surface.facets.size()));
  for (const Surface3::Facet& facet : surface.facets) {
    for (int k = 0; k < 3; ++k) out.number(0.0F);
    for (const std::uint32_t v : facet) {
      for (const double x : surface.points[v]) out.number(static_cast<float>(x));
    }
    out.number(std::uint16_t{0});
  }
  return out.str();
}

inline std::string text_ply(const Surface3&) {
  return "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nproperty uchar red\nelement face 4\nproperty list uchar int "
         "vertex_index\nend_header\n"
         "0 0 0 255\n1 0 0 255\n0 1.5 0 255\n-0.25 0 1 255\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

/// With a property before the coordinates, an element to be passed over, and two lists in each face.
inline std::string binary_ply(const Surface3& surface, std::endian order) {
  Bytes out(order);
  out.text(order == std::endian::little ? "ply\nformat binary_little_endian 1.0\n"
                                        : "ply\nformat binary_big_endian 1.0\n");
  out.text("element vertex " + std::to_string(surface.points.size()) +
           "\nproperty short flag\nproperty double x\nproperty double y\nproperty double z\n"
           "element extra 1\nproperty list uchar float values\nelement face " +
           std::to_string(surface.facets.size()) +
           "\nproperty list uchar short texture\nproperty list int uint vertex_indices\nend_header\n");
  for (const Point3& p : surface.points) {
    out.number(std::int16_t{1});
    for (const double x : p) out.number(x);
  }
  out.number(std::uint8_t{2}).number(1.0F).number(2.0F);
  for (const Surface3::Facet& f : surface.facets) {
    out.number(std::uint8_t{1}).number(std::int16_t{9}).number(std::int32_t{3});
    for (const std::uint32_t v : f) out.number(v);
  }
  return out.str();
}

/// Legacy VTK in binary, version 3 with one list of cells, or 5.1 with offsets.
inline std::string binary_vtk(const Mesh3& mesh, int version) {
  const std::size_t n = mesh.simplices.size();
  Bytes out(std::endian::big);
  out.text(version == 3 ? "# vtk DataFile Version 3.0\n" : "# vtk DataFile Version 5.1\n");
  out.text("title\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS " + std::to_string(mesh.points.size()) +
           " double\n");
  for (const Point3& p : mesh.points) {
    for (const double x : p) out.number(x);
  }
  if (version == 3) {
    out.text("\nCELLS " + std::to_string(n) + ' ' + std::to_string(5 * n) + '\n');
    for (const auto& s : mesh.simplices) {
      out.number(std::int32_t{4});
      for (const std::uint32_t v : s) out.number(v);
    }
  } else {
    out.text("\nMETADATA\nINFORMATION 0\n\nCELLS " + std::to_string(n + 1) + ' ' + std::to_string(4 * n));
    out.text("\nOFFSETS vtktypeint64\n");
    for (std::size_t i = 0; i <= n; ++i) out.number(static_cast<std::int64_t>(4 * i));
    out.text("\nCONNECTIVITY vtktypeint64\n");
    for (const auto& s : mesh.simplices) {
      for (const std::uint32_t v : s) out.number(static_cast<std::int64_t>(v));
    }
  }
  out.text("\nCELL_TYPES " + std::to_string(n) + '\n');
  for (std::size_t i = 0; i < n; ++i) out.number(std::int32_t{10});
  out.text("\nCELL_DATA " + std::to_string(n) + "\nFIELD FieldData 1\nlabel 1 " + std::to_string(n) + " int\n");
  for (const std::int64_t value : mesh.simplex_fields.front().values)
    out.number(static_cast<std::int32_t>(value));
  return out.text("\n").str();
}

enum class VtuEncoding { text, base64, appended_base64, appended_raw_big };

/// VTK's XML format as other programs write it: 32-bit lengths, other types of numbers, other orders.
inline std::string vtu(const Mesh3& mesh, VtuEncoding encoding) {
  const bool is_appended =
      encoding == VtuEncoding::appended_base64 || encoding == VtuEncoding::appended_raw_big;
  const std::endian order = encoding == VtuEncoding::appended_raw_big ? std::endian::big : std::endian::little;
  std::string head;
  std::string data;
  const auto array = [&](const std::string& attributes, const Bytes& bytes, const std::string& words) {
    head += "<DataArray " + attributes + " format=\"";
    if (encoding == VtuEncoding::text) {
      head += "ascii\">\n" + words + "\n</DataArray>\n";
      return;
    }
    const std::string length = Bytes(order).number(static_cast<std::uint32_t>(bytes.str().size())).str();
    // Length and data as one block or as two: both are in use.
    const std::string code = encoding == VtuEncoding::base64            ? base64(length) + base64(bytes.str())
                             : encoding == VtuEncoding::appended_base64 ? base64(length + bytes.str())
                                                                        : length + bytes.str();
    if (is_appended) {
      head += "appended\" offset=\"" + std::to_string(data.size()) + "\"/>\n";
      data += code;
    } else {
      head += "binary\">\n  " + code + "\n</DataArray>\n";
    }
  };
  head += order == std::endian::big
              ? "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"BigEndian\">\n"
              : "<VTKFile type='UnstructuredGrid' version='0.1' byte_order='LittleEndian'>\n";
  head += "<!-- by hand --><UnstructuredGrid><Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) +
          "\" NumberOfCells=\"" + std::to_string(mesh.simplices.size()) + "\">\n<PointData/>\n<Cells>\n";
  Bytes connectivity(order);
  Bytes offsets(order);
  Bytes types(order);
  Bytes labels(order);
  Bytes points(order);
  std::string words[5];
  for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
    for (const std::uint32_t v : mesh.simplices[i]) {
      connectivity.number(v);
      words[0] += std::to_string(v) + ' ';
    }
    offsets.number(static_cast<std::int32_t>(4 * i + 4));
    types.number(std::uint8_t{10});
    labels.number(static_cast<std::int16_t>(mesh.simplex_fields.front().values[i]));
    words[1] += std::to_string(4 * i + 4) + ' ';
    words[2] += "10 ";
    words[3] += std::to_string(mesh.simplex_fields.front().values[i]) + ' ';
  }
  for (const Point3& p : mesh.points) {
    for (const double x : p) {
      points.number(x);
      words[4] += std::to_string(x) + ' ';
    }
  }
  array("type=\"UInt32\" Name=\"connectivity\"", connectivity, words[0]);
  array("type=\"Int32\" Name=\"offsets\"", offsets, words[1]);
  array("type=\"UInt8\" Name=\"types\"", types, words[2]);
  head += "</Cells>\n<CellData>\n";
  array("Name=\"label\" type=\"Int16\"", labels, words[3]);
  head += "</CellData>\n<Points>\n";
  array("type=\"Float64\" NumberOfComponents=\"3\"", points, words[4]);
  head += "</Points>\n</Piece></UnstructuredGrid>\n";
  if (is_appended) {
    head += encoding == VtuEncoding::appended_base64 ? "<AppendedData encoding=\"base64\">\n _" + data
                                                     : "<AppendedData encoding=\"raw\">_" + data;
    head += "\n</AppendedData>\n";
  }
  return head + "</VTKFile>\n";
}

}  // namespace sinkmesh::test
