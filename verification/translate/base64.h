#pragma once

#include <string>

namespace wetfront::verification {

/// The bytes that a text in base64 stands for. Padding ends a part, which another may follow (a length and its data,
/// written one after the other); what is no digit is passed over.
std::string from_base64(const std::string& text);

}  // namespace wetfront::verification
