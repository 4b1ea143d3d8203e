// SPDX-License-Identifier: MIT
//
// Just enough XML for VTK: tags, attributes, and the text between tags.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sinkmesh::io_detail {

struct XmlTag {
  std::string_view name;        // "/Cells" for </Cells>
  std::string_view attributes;  // unparsed
  std::string_view content;     // up to the next tag
  bool closes_itself = false;   // <Points/>
  std::size_t offset = 0;

  /// The value between quotes, as it stands; empty if there is none.
  std::string_view attribute(std::string_view key) const;
};

/// Finds tags one after the other; comments and declarations are passed over.
class XmlScanner {
 public:
  explicit XmlScanner(std::string_view text) : text_(text) {}

  /// False at the end, or at a tag that never ends.
  bool next(XmlTag& tag);
  /// Offset after the last tag: where its content begins.
  std::size_t offset() const { return at_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// With &lt; &#10; and their like replaced by what they stand for.
std::string xml_unescaped(std::string_view text);

}  // namespace sinkmesh::io_detail
