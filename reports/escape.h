#pragma once

#include <string>
#include <string_view>

/// Text made safe for the place it is put in. Every text of a record passes through one of these.
namespace wetfront::reports {

/// For HTML and XML text and quoted attributes: & < > " ' become references, control characters that XML
/// forbids are dropped, bytes that are not UTF-8 become U+FFFD.
std::string html(std::string_view text);

/// For gnuplot, as a single-quoted string (in which gnuplot substitutes nothing); line breaks become blanks.
std::string gnuplot_string(std::string_view text);

/// For a CSV cell (RFC 4180): quoted when it holds a comma, a quote or a line break.
std::string csv_cell(std::string_view text);

/// JSON as the content of a <script> element: no '<', so that neither a closing tag nor a comment inside a string can
/// end it.
std::string script_json(std::string json);

/// A relative path as a URL: everything but unreserved characters and '/' percent-encoded.
std::string url_path(std::string_view path);

/// Whether a text can be the stem of a file's name anywhere: letters, digits, '_' and '-', at least one.
bool is_stem(std::string_view text);

/// A text as part of an id: lower-case letters and digits, '-' for all else.
std::string anchor(std::string_view text);

/// Number of characters (code points) of a UTF-8 text, to estimate its width.
std::size_t characters(std::string_view text);

/// Wraps at blanks into lines of at most `width` characters; a longer word stands alone.
std::string wrap(std::string_view text, std::size_t width, char separator = '\n');

}  // namespace wetfront::reports
