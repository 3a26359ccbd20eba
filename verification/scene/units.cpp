#include "verification/scene/units.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

namespace wetfront::verification {
namespace {

const std::string pressure_or_head = "Pa or m";

struct Dimension {
  std::string unit, name, example;
  std::vector<std::string> common;  ///< units people write, for suggestions
};

const std::vector<Dimension>& dimensions() {
  static const std::vector<Dimension> all = {
      {"m", "a length", "1.2 m", {"m", "mm", "cm", "km"}},
      {"s", "a time", "1800 s", {"s", "min", "h", "d", "hour", "day"}},
      {"Pa", "a pressure", "4.35 kPa", {"Pa", "kPa", "MPa", "GPa", "bar"}},
      {"Pa or m", "a pressure or a head of water", "4.35 kPa", {"Pa", "kPa", "MPa", "GPa", "bar", "m", "mm", "cm"}},
      {"1/m", "a reciprocal length", "2.25 1/m", {"1/m", "1/cm"}},
      {"kg/m3", "a density", "1000 kg/m3", {"kg/m3", "g/cm3", "t/m3"}},
      {"Pa s", "a dynamic viscosity", "1e-6 kPa s", {"Pa s", "kPa s", "mPa s"}},
      {"m2", "an intrinsic permeability", "3e-11 m2", {"m2", "cm2", "mm2", "um2"}},
      {"m/s", "a rain intensity or conductivity", "100 mm/h", {"m/s", "mm/h", "cm/h", "cm/s", "m/d", "mm/d"}},
      {"m/s2", "an acceleration", "-9.81 m/s2", {"m/s2", "m/s^2"}},
      {"m2/s", "a kinematic viscosity", "1e-6 m2/s", {"m2/s"}},
      {"rad", "an angle", "30 deg", {"deg", "rad", "degree"}},
      {"1", "a pure number", "25 %", {"%"}},
  };
  return all;
}

struct FreeSystem {
  void operator()(ut_system* system) const { ut_free_system(system); }
};
struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

std::unique_ptr<ut_system, FreeSystem> open_system() {
  ut_set_error_message_handler(ut_ignore);  // udunits prints to stderr otherwise
  std::unique_ptr<ut_system, FreeSystem> system(ut_read_xml(nullptr));
  if (!system)
    throw std::runtime_error("the table of units cannot be read (udunits2.xml). Install the package libudunits2-data.");
  const Unit degree(ut_parse(system.get(), "degree", UT_UTF8));
  ut_map_name_to_unit("deg", UT_ASCII, degree.get());  // the one everyday name that udunits lacks
  return system;
}

Unit parse_unit(const std::string& name) {
  static const auto system = open_system();
  return Unit(ut_parse(system.get(), name.c_str(), UT_UTF8));
}

/// Factor from one unit to another; none where udunits converts by more than a factor (reciprocals,
/// logarithms, shifted zeros) or where an angle and a pure number would be taken for each other.
std::optional<double> factor(const std::string& from, const std::string& to) {
  const bool pure = from == "1" || from == "%" || from == "percent";
  if (pure != (to == "1")) return std::nullopt;
  const Unit have = parse_unit(from), want = parse_unit(to);
  if (!have || !want) return std::nullopt;
  const std::unique_ptr<cv_converter, FreeConverter> converter(ut_get_converter(have.get(), want.get()));
  if (!converter) return std::nullopt;
  const double one = cv_convert_double(converter.get(), 1.0);
  const bool linear = cv_convert_double(converter.get(), 0.0) == 0.0 &&
                      std::abs(cv_convert_double(converter.get(), 2.0) - 2 * one) <= 1e-12 * std::abs(one);
  return linear && std::isfinite(one) && one > 0 ? std::optional(one) : std::nullopt;
}

const Dimension* find_dimension(const std::string& unit) {
  for (const Dimension& candidate : dimensions())
    if (candidate.unit == unit) return &candidate;
  return nullptr;
}

std::string trimmed(const std::string& text) {
  const auto from = text.find_first_not_of(" \t\r\n");
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r\n") - from + 1);
}

std::string measured_by(const std::string& unit) {
  for (const Dimension& candidate : dimensions())
    if (factor(unit, candidate.unit)) return candidate.name;
  return "";
}

Complaint unknown_unit(const std::string& quoted, const std::string& name, const std::string& unit) {
  std::vector<std::string> common;
  if (const Dimension* wanted = find_dimension(unit)) common = wanted->common;
  const std::string near = nearest(name, common);
  return {fmt::format("{} has the unknown unit '{}'", quoted, name), "units are those of udunits2, and capitals count",
          near.empty() ? fmt::format("Write {} as in \"{}\".", dimension(unit), example_of(unit))
                       : fmt::format("Did you mean '{}'?", near)};
}

}  // namespace

std::string dimension(const std::string& unit) {
  const Dimension* found = find_dimension(unit);
  return found ? found->name : "a quantity in " + unit;
}

std::string example_of(const std::string& unit) {
  const Dimension* found = find_dimension(unit);
  return found ? found->example : "1 " + unit;
}

std::variant<double, Complaint> read_quantity(const std::string& text, const std::string& unit, double unit_weight) {
  const std::string quoted = '"' + shortened(text) + '"';
  const std::string body = trimmed(text);
  const std::string wanted = fmt::format("{} is wanted here", dimension(unit));
  double number = 0;
  const char* begin = body.data() + (!body.empty() && body[0] == '+' ? 1 : 0);
  const auto [end, status] = std::from_chars(begin, body.data() + body.size(), number);
  if (status == std::errc::result_out_of_range)
    return Complaint{quoted + " is not a number a computer can hold", wanted, "Check the exponent."};
  if (status != std::errc())
    return Complaint{quoted + " does not start with a number", wanted, "Write it as in \"" + example_of(unit) + "\"."};
  if (!std::isfinite(number))
    return Complaint{quoted + " is not a finite number", wanted, "Write it as in \"" + example_of(unit) + "\"."};
  const std::string name = trimmed(std::string(end, body.data() + body.size()));
  if (!name.empty() && (name[0] == ',' || name[0] == '_' || name[0] == '.'))
    return Complaint{quoted + " is not a number with a unit", "decimals follow a point and thousands have no separator",
                     "Write it as in \"" + example_of(unit) + "\"."};
  if (name.empty() && unit != "1")
    return Complaint{quoted + " has no unit", wanted + ", and a bare number could be in any unit",
                     fmt::format("If it is in {0}, write \"{1} {0}\".", unit, body)};
  const std::string unit_name = name.empty() ? "1" : name;
  // "5 3 m" and "5 m @ 2" are units to udunits: 3 m, and metres counted from 2. "5 1/m" is meant as it stands.
  const bool number_first = name.find_first_of("@+-0123456789") == 0 && name.rfind("1/", 0) != 0;
  if (number_first || name.find('@') != std::string::npos || !parse_unit(unit_name))
    return unknown_unit(quoted, name, unit);
  std::optional<double> scale = factor(unit_name, unit);
  if (unit == pressure_or_head) {
    const std::optional<double> metres = factor(unit_name, "m");
    if (metres && !(unit_weight > 0))
      return Complaint{quoted + " is a head of water", "p = rho g h, and there is no weight of water in this scene",
                       "Write a pressure as in \"4.35 kPa\"."};
    scale = metres ? std::optional(*metres * unit_weight) : factor(unit_name, "Pa");
  }
  if (!scale) {
    const std::string is = measured_by(unit_name);
    return Complaint{fmt::format("{} is {}", quoted, is.empty() ? "of another kind" : is), wanted,
                     "Write it as in \"" + example_of(unit) + "\"."};
  }
  if (!std::isfinite(number * *scale))
    return Complaint{quoted + " is not a number a computer can hold", wanted, "Check the exponent."};
  return number * *scale;
}

}  // namespace wetfront::verification
