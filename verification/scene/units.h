#pragma once

#include "verification/scene/complaints.h"

#include <string>
#include <variant>

/// Numbers with units. units.cpp is the only unit that includes udunits2.
namespace wetfront::verification {

/// Reads "4.35 kPa" and converts it to `unit` ("Pa"); "1" wants a pure number: "0.25", "25 %". "Pa or m" takes a head
/// of water as well and makes pressures of it with `unit_weight`, rho g [Pa/m]; where that is not positive, heads are
/// refused.
/// The complaint's problem starts with the quoted text. Nothing is ever written to stderr.
std::variant<double, Complaint> read_quantity(const std::string& text, const std::string& unit, double unit_weight = 0);

/// What `unit` measures, with its article: "a pressure"; "a quantity in X" for a unit without a name here.
std::string dimension(const std::string& unit);

/// How a value of that dimension is written: "4.35 kPa".
std::string example_of(const std::string& unit);

}  // namespace wetfront::verification
