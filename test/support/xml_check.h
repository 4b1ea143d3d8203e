// SPDX-License-Identifier: MIT
//
// Is a text well-formed XML? As far as a writer can go wrong: nesting, quotes, stray characters, double ids.
#pragma once

#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace sinkmesh::test {

/// What is wrong first, with its position; empty if nothing is.
inline std::string xml_error(std::string_view text) {
  std::vector<std::string> open;
  std::set<std::string> ids;
  bool had_root = false;
  std::size_t at = 0;
  const auto error = [&](const std::string& what) { return what + " at byte " + std::to_string(at); };
  const auto is_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == ':' || c == '_';
  };
  const auto name = [&] {
    const std::size_t start = at;
    while (at < text.size() && is_name(text[at])) ++at;
    return std::string(text.substr(start, at - start));
  };
  while (at < text.size()) {
    if (text[at] == '&') {
      const std::size_t end = text.find(';', at);
      if (end == std::string_view::npos || end > at + 8) return error("bare &");
    }
    if (text[at] != '<') {
      if (open.empty() && std::isspace(static_cast<unsigned char>(text[at])) == 0) return error("text outside");
      ++at;
      continue;
    }
    ++at;
    const bool is_end = at < text.size() && text[at] == '/';
    if (is_end) ++at;
    const std::string tag = name();
    if (tag.empty()) return error("< without a name");
    if (is_end) {
      if (open.empty() || open.back() != tag) return error("unexpected end of " + tag);
      open.pop_back();
      if (at >= text.size() || text[at] != '>') return error("unclosed end of " + tag);
      ++at;
      continue;
    }
    if (open.empty() && had_root) return error("second root");
    had_root = true;
    std::set<std::string> attributes;
    while (at < text.size() && text[at] == ' ') {
      ++at;
      const std::string attribute = name();
      if (attribute.empty() || !attributes.insert(attribute).second) return error("attribute " + attribute);
      if (text.substr(at, 2) != "=\"") return error("value of " + attribute);
      at += 2;
      const std::size_t end = text.find('"', at);
      if (end == std::string_view::npos) return error("open quote");
      const std::string value(text.substr(at, end - at));
      if (value.find('<') != std::string::npos) return error("< in a value");
      if (attribute == "id" && !ids.insert(value).second) return error("double id " + value);
      at = end + 1;
    }
    if (text.substr(at, 2) == "/>") {
      at += 2;
    } else if (at < text.size() && text[at] == '>') {
      ++at;
      open.push_back(tag);
    } else {
      return error("unclosed " + tag);
    }
  }
  if (!open.empty()) return error("missing end of " + open.back());
  return had_root ? "" : "empty";
}

}  // namespace sinkmesh::test
