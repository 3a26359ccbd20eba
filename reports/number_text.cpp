#include "reports/number_text.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace wetfront::reports {

namespace {

const std::string minus = "\u2212";

std::string fixed(double value, int decimals) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  std::string text = buffer;
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

}  // namespace

std::string power_of_ten(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

std::string number_text(double value, int digits) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? minus + "∞" : "∞";
  if (value == 0) return "0";
  const std::string sign = value < 0 ? minus : "";
  // Digits before the decimal point are never rounded away: 1772 s stays 1772 s.
  if (std::abs(value) >= std::pow(10, digits - 1) && std::abs(value) < 99999.5) return sign + fixed(std::abs(value), 0);
  char rounded[64];
  std::snprintf(rounded, sizeof rounded, "%.*e", digits - 1, std::abs(value));
  const std::string text = rounded;
  const int exponent = std::stoi(text.substr(text.find('e') + 1));
  const double magnitude = std::strtod(text.c_str(), nullptr);
  if (exponent >= -3 && exponent < 5) return sign + fixed(magnitude, std::max(0, digits - 1 - exponent));
  const std::string mantissa = fixed(std::strtod(text.substr(0, text.find('e')).c_str(), nullptr), digits - 1);
  return sign + (mantissa == "1" ? "" : mantissa + "\u202f×\u202f") + power_of_ten(exponent);
}

std::string quantity_text(double value, const std::string& unit, int digits) {
  if (unit != "1" && !unit.empty()) return number_text(value, digits) + "\u00a0" + unit;
  if (!std::isfinite(value)) return number_text(value);
  if (value == 0) return "0";
  if (std::abs(value) < 1e-5) return number_text(value, digits);
  return number_text(100 * value, digits) + "\u00a0%";
}

std::string exact_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return std::string(buffer, end);
}

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds < 100) return number_text(seconds) + "\u00a0s";
  const long whole = std::lround(seconds);
  char buffer[64];
  if (whole < 3600)
    std::snprintf(buffer, sizeof buffer, "%ld\u00a0min %02ld\u00a0s", whole / 60, whole % 60);
  else
    std::snprintf(buffer, sizeof buffer, "%ld\u00a0h %02ld\u00a0min", whole / 3600, whole % 3600 / 60);
  return buffer;
}

}  // namespace wetfront::reports
