// SPDX-License-Identifier: MIT
//
// Base64, as VTK writes it: a block may end with padding and be followed by another.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sinkmesh::io_detail {

/// Decodes one block, up to `limit` bytes: until enough bytes, padding, or a character that is not base64.
/// Blanks are passed over. `text` is advanced past what was read, in whole groups of four characters.
std::string decode_base64(std::string_view& text, std::size_t limit);

/// Encodes all bytes as one block, padded to whole groups, without line breaks.
std::string encode_base64(std::string_view bytes);

}  // namespace sinkmesh::io_detail
