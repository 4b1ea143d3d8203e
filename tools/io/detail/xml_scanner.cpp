// SPDX-License-Identifier: MIT
//
// A scanner, not a parser: damage shows as missing tags, which the caller reports.
#include "tools/io/detail/xml_scanner.h"

#include <charconv>
#include <utility>

namespace sinkmesh::io_detail {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr std::size_t kNone = std::string_view::npos;

// Where the tag that starts at `start` ends, quoted '>' not counted.
std::size_t end_of_tag(std::string_view text, std::size_t start) {
  char quote = '\0';
  for (std::size_t i = start; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i;
    }
  }
  return kNone;
}

}  // namespace

bool XmlScanner::next(XmlTag& tag) {
  while (true) {
    const std::size_t start = text_.find('<', at_);
    if (start == kNone) return false;
    if (text_.substr(start).starts_with("<!--")) {
      const std::size_t end = text_.find("-->", start);
      if (end == kNone) return false;
      at_ = end + 3;
      continue;
    }
    const std::size_t end = end_of_tag(text_, start);
    if (end == kNone) return false;
    at_ = end + 1;
    std::string_view inside = text_.substr(start + 1, end - start - 1);
    if (inside.starts_with('?') || inside.starts_with('!')) continue;
    tag.closes_itself = inside.ends_with('/');
    if (tag.closes_itself) inside.remove_suffix(1);
    const std::size_t space = inside.find_first_of(kSpace);
    tag.name = inside.substr(0, space);
    tag.attributes = space == kNone ? std::string_view() : inside.substr(space);
    tag.content = text_.substr(at_, text_.find('<', at_) - at_);
    tag.offset = start;
    return true;
  }
}

std::string_view XmlTag::attribute(std::string_view key) const {
  std::string_view rest = attributes;
  while (true) {
    const std::size_t start = rest.find_first_not_of(kSpace);
    if (start == kNone) return {};
    rest.remove_prefix(start);
    const std::size_t equals = rest.find('=');
    if (equals == kNone) return {};
    std::string_view found = rest.substr(0, equals);
    found = found.substr(0, found.find_last_not_of(kSpace) + 1);
    rest.remove_prefix(equals + 1);
    const std::size_t open = rest.find_first_not_of(kSpace);
    if (open == kNone || (rest[open] != '"' && rest[open] != '\'')) return {};
    const std::size_t close = rest.find(rest[open], open + 1);
    if (close == kNone) return {};
    if (found == key) return rest.substr(open + 1, close - open - 1);
    rest.remove_prefix(close + 1);
  }
}

std::string xml_unescaped(std::string_view text) {
  static constexpr std::pair<std::string_view, char> kNames[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};
  std::string out;
  while (!text.empty()) {
    std::size_t used = 1;
    char c = text.front();
    if (c == '&') {
      for (const auto& [name, meaning] : kNames) {
        if (text.starts_with(name)) {
          c = meaning;
          used = name.size();
        }
      }
      int code = 0;
      if (text.starts_with("&#")) {
        const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), code);
        if (error == std::errc() && end != text.data() + text.size() && *end == ';' && code > 0 && code < 128) {
          c = static_cast<char>(code);
          used = static_cast<std::size_t>(end - text.data()) + 1;
        }
      }
    }
    out += c;
    text.remove_prefix(used);
  }
  return out;
}

}  // namespace sinkmesh::io_detail
