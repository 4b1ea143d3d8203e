// SPDX-License-Identifier: MIT
#include "test/stress/case.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace sinkmesh::stress {
namespace {

auto find_setting(auto& settings, std::string_view key) {
  return std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.first == key; });
}

std::uint64_t parse_count(const std::string& word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size())
    throw std::invalid_argument("'" + word + "' is no number");
  return value;
}

double parse_double(const std::string& word) {
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') throw std::invalid_argument("'" + word + "' is no number");
  return x;
}

void parse_line(const std::string& line, Case& c) {
  std::istringstream words(line);
  std::string item;
  std::string word;
  words >> item;
  if (item == "row") {
    auto& row = c.rows.emplace_back();
    while (words >> word) row.push_back(parse_double(word));
  } else if (item == "set") {
    std::string value;
    if (!(words >> word)) throw std::invalid_argument("a setting without a key");
    std::getline(words >> std::ws, value);
    c.set(word, value);
  } else if (!(words >> word)) {
    throw std::invalid_argument("'" + item + "' needs a value");
  } else if (item == "suite") {
    c.suite = word;
  } else if (item == "seed") {
    c.seed = parse_count(word);
  } else if (item == "case") {
    c.number = parse_count(word);
  } else {
    throw std::invalid_argument("'" + item + "' is none of suite, seed, case, set, row");
  }
}

}  // namespace

std::string_view Case::setting(std::string_view key) const {
  const auto found = find_setting(settings, key);
  return found == settings.end() ? std::string_view{} : std::string_view(found->second);
}

std::uint64_t Case::number_setting(std::string_view key) const {
  const std::string_view value = setting(key);
  return value.empty() ? 0 : parse_count(std::string(value));
}

void Case::set(std::string_view key, std::string_view value) {
  const auto found = find_setting(settings, key);
  if (found == settings.end()) {
    settings.emplace_back(key, value);
  } else {
    found->second = value;
  }
}

std::string to_text(const Case& c) {
  std::string text = "# Replay with --replay FILE.\n";
  text += "suite " + c.suite + "\n";
  text += "seed " + std::to_string(c.seed) + "\n";
  text += "case " + std::to_string(c.number) + "\n";
  for (const auto& [key, value] : c.settings) text += "set " + key + " " + value + "\n";
  for (const auto& row : c.rows) {
    text += "row";
    for (const double x : row) {
      char buffer[40];
      std::snprintf(buffer, sizeof buffer, " %a", x);
      text += buffer;
    }
    text += "\n";
  }
  return text;
}

Case parse_case(const std::string& text, const std::string& file) {
  Case c;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
    try {
      parse_line(line, c);
    } catch (const std::invalid_argument& error) {
      throw CaseError(file + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  if (c.suite.empty()) throw CaseError(file + ": names no suite");
  return c;
}

Case read_case(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  if (!in || !text) throw CaseError(file.string() + ": cannot be read");
  return parse_case(text.str(), file.string());
}

void write_case(const std::filesystem::path& file, const Case& c) {
  std::ofstream out(file);
  out << to_text(c) << std::flush;
  if (!out) throw CaseError(file.string() + ": cannot be written");
}

}  // namespace sinkmesh::stress
