// SPDX-License-Identifier: MIT
//
// One input of a stress suite, and the small text file that reproduces it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh::stress {

/// What a check looks at: all of it is in here, so that the check is a function of the case alone. Rows are
/// mostly points; a suite may give them other meanings, by its settings.
struct Case {
  std::string suite;
  std::uint64_t seed = 0;    ///< of the run
  std::uint64_t number = 0;  ///< within the run of its suite, from 1
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<std::vector<double>> rows;

  bool operator==(const Case&) const = default;

  /// The value of a setting; empty if there is none.
  std::string_view setting(std::string_view key) const;
  /// The same as a number; 0 if there is none.
  std::uint64_t number_setting(std::string_view key) const;
  void set(std::string_view key, std::string_view value);
  void set(std::string_view key, std::uint64_t value) { set(key, std::to_string(value)); }

  /// The rows as points. Requires rows of Dim numbers.
  template <int Dim>
  std::vector<Point<Dim>> points() const {
    std::vector<Point<Dim>> result(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < Dim; ++k) result[i][k] = rows[i].at(k);
    }
    return result;
  }
  template <int Dim>
  void set_points(const std::vector<Point<Dim>>& points) {
    rows.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) rows[i].assign(points[i].begin(), points[i].end());
  }
};

/// A file that is no case; the message names file and line.
class CaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One item per line: `suite NAME`, `seed N`, `case N`, `set KEY VALUE`, `row X Y Z`, with numbers in
/// hexadecimal notation, so that every bit comes back.
std::string to_text(const Case& c);
/// @throws CaseError
Case parse_case(const std::string& text, const std::string& file);
/// @throws CaseError
Case read_case(const std::filesystem::path& file);
/// @throws CaseError if the file cannot be written.
void write_case(const std::filesystem::path& file, const Case& c);

}  // namespace sinkmesh::stress
