#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wetfront::reports {

/// RFC 4648, section 4, with padding.
std::string base64(std::span<const unsigned char> bytes);
/// Back again. Throws std::runtime_error for what is no base64.
std::vector<unsigned char> from_base64(std::string_view text);
/// The bytes of text that others wrote: padding ends a part, which another may follow (a length and its data, written
/// one after the other); what is no digit is passed over.
std::vector<unsigned char> from_base64_parts(std::string_view text);

}  // namespace wetfront::reports
