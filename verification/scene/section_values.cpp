#include "verification/scene/section.h"
#include "verification/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// What SectionReader makes of single values: types, units, ranges.
namespace wetfront::verification {
namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
const std::string of_filling = "of filling";

/// Of the table's own texts. A head as default needs a weight of water, without which its key has no use: NaN.
double in_si(const std::string& text, const std::string& unit, double unit_weight) {
  const auto read = read_quantity(text, unit, unit_weight);
  const double* number = std::get_if<double>(&read);
  return number ? *number : absent;
}

}  // namespace

std::string SectionReader::text(const std::string& name) {
  const Value* value = raw(name);
  if (!value) return key(name).fallback;
  if (value->kind != Value::Kind::text || value->text.empty()) {
    complain(name, {shown(name) + " is not a text", key(name).meaning, "Write " + assignment(key(name))});
    return "";
  }
  return value->text;
}

std::string SectionReader::choice(const std::string& name) {
  const Key& wanted = key(name);
  const Value* value = raw(name);
  if (!value) return wanted.fallback;
  if (value->kind == Value::Kind::text &&
      std::find(wanted.choices.begin(), wanted.choices.end(), value->text) != wanted.choices.end())
    return value->text;
  const std::string near = nearest(value->text, wanted.choices);
  const bool list = near.empty() || wanted.choices.size() <= 8;
  complain(name, {shown(name) + " is not known", list ? "it is one of " + alternatives(wanted.choices) : "",
                  near.empty() ? "" : "Did you mean \"" + near + "\"?"});
  return "";
}

double SectionReader::number_of(const Key& wanted, const Value& written, const std::string& unit) {
  if (written.is_number() && unit == "1" && std::isfinite(written.number)) return written.number;
  const std::string given = wanted.name + " = " + written.shown();
  Complaint complaint{given + " is not a number with a unit", dimension(unit) + " is wanted",
                      "Write it as in \"" + example_of(unit) + "\"."};
  if (written.kind == Value::Kind::text) {
    const auto read = read_quantity(written.text, unit, unit_weight_);
    if (const double* number = std::get_if<double>(&read)) return *number;
    complaint = std::get<Complaint>(read);
    complaint.problem = wanted.name + " = " + complaint.problem;
  } else if (written.is_number() && !std::isfinite(written.number)) {
    complaint = {given + " is not a finite number", dimension(unit) + " is wanted",
                 "Write it as in \"" + example_of(unit) + "\"."};
  } else if (written.is_number()) {
    complaint = {given + " has no unit", dimension(unit) + " is wanted, and a bare number could be in any unit",
                 fmt::format("If it is in {0}, write \"{1} {0}\".", unit, written.shown())};
  }
  if (wanted.takes == Takes::quantity && complaint.suggestion.rfind("Write it", 0) == 0)
    complaint.suggestion = "Write it as in " + assignment(wanted);
  complaints_->add(written.place, complaint);
  return absent;
}

std::string SectionReader::range_missed(const std::string& name, double value) const {
  const Key& wanted = key(name);
  const auto bound = [&](const std::string& text) {
    return wanted.takes == Takes::count || wanted.takes == Takes::counts ? std::stod(text)
                                                                         : in_si(text, wanted.unit, unit_weight_);
  };
  const Range& range = wanted.range;
  const bool low = !range.from.empty() && (range.open_from ? value <= bound(range.from) : value < bound(range.from));
  const bool high = !range.to.empty() && (range.open_to ? value >= bound(range.to) : value > bound(range.to));
  return low || high ? bounds(range) : "";
}

bool SectionReader::in_range(const Key& wanted, double value, const Value& written) {
  const std::string missed = range_missed(wanted.name, value);
  if (!missed.empty())
    complaints_->add(written.place,
                     {wanted.name + " = " + written.shown() + " is out of range", "it must be " + missed,
                      (wanted.takes == Takes::quantity || wanted.takes == Takes::level) && wanted.unit != "1"
                          ? "Check the sign, the unit and the exponent."
                          : "Write it as in " + assignment(wanted)});
  return missed.empty();
}

double SectionReader::quantity(const std::string& name) {
  const Key& wanted = key(name);
  const Value* written = raw(name);
  if (!written) return wanted.fallback.empty() ? absent : in_si(wanted.fallback, wanted.unit, unit_weight_);
  const double value = number_of(wanted, *written, wanted.unit);
  return std::isfinite(value) && in_range(wanted, value, *written) ? value : absent;
}

int SectionReader::count(const std::string& name) {
  const Key& wanted = key(name);
  const Value* written = raw(name);
  if (!written) return wanted.fallback.empty() ? 0 : std::stoi(wanted.fallback);
  if (written->kind != Value::Kind::integer) {
    complain(name, {shown(name) + " is not a whole number", wanted.meaning, "Write " + assignment(wanted)});
    return 0;
  }
  return in_range(wanted, written->number, *written) ? static_cast<int>(written->number) : 0;
}

std::vector<double> SectionReader::vector(const std::string& name) {
  const Key& wanted = key(name);
  const Value* written = raw(name);
  std::vector<double> components;
  if (!written) {
    for (std::size_t from = 0; from < wanted.fallback.size(); from = wanted.fallback.find(',', from) + 1) {
      const auto comma = wanted.fallback.find(',', from);
      components.push_back(std::get<double>(read_quantity(wanted.fallback.substr(from, comma - from), wanted.unit)));
      if (comma == std::string::npos) break;
    }
    return components;
  }
  if (written->kind != Value::Kind::array || written->items.size() < 2 || written->items.size() > 3) {
    complain(name, {shown(name) + " is not a list of two or three quantities", wanted.meaning,
                    "Write " + assignment(wanted)});
    return {};
  }
  for (const Value& item : written->items) {
    const double value = number_of(wanted, item, wanted.unit);
    components.push_back(std::isfinite(value) && in_range(wanted, value, item) ? value : absent);
  }
  return components;
}

std::vector<double> SectionReader::range(const std::string& name) {
  const Key& wanted = key(name);
  const Value* written = raw(name);
  if (!written) return {};
  if (written->kind != Value::Kind::array || written->items.size() != 2) {
    complain(name, {shown(name) + " is not a list of two quantities", wanted.meaning, "Write " + assignment(wanted)});
    return {};
  }
  std::vector<double> ends;
  for (const Value& item : written->items) ends.push_back(item_in_range(name, item));
  if (ends[0] >= ends[1])
    complain(name,
             {shown(name) + " holds nothing", "the first is not below the second", "Write " + assignment(wanted)});
  return ends[0] < ends[1] ? ends : std::vector<double>{};
}

std::vector<int> SectionReader::counts(const std::string& name) {
  const Key& wanted = key(name);
  const Value* written = raw(name);
  if (!written) return {};
  const bool list = written->kind == Value::Kind::array && (written->items.size() == 2 || written->items.size() == 3) &&
                    std::all_of(written->items.begin(), written->items.end(),
                                [](const Value& item) { return item.kind == Value::Kind::integer; });
  if (!list) {
    complain(name, {shown(name) + " is not a list of two or three whole numbers", wanted.meaning,
                    "Write " + assignment(wanted)});
    return {};
  }
  std::vector<int> numbers;
  for (const Value& item : written->items)
    numbers.push_back(in_range(wanted, item.number, item) ? static_cast<int>(item.number) : 0);
  return numbers;
}

double SectionReader::item_in_range(const std::string& name, const Value& item) {
  const Key& wanted = key(name);
  const double value = number_of(wanted, item, wanted.unit);
  return std::isfinite(value) && in_range(wanted, value, item) ? value : absent;
}

double SectionReader::item_quantity(const std::string& name, const Value& item, const std::string& unit) {
  return number_of(key(name), item, unit);
}

std::optional<SceneTime> SectionReader::item_time(const std::string& name, const Value& item) {
  const Key& wanted = key(name);
  SceneTime time;
  time.origin = complaints_->origin(item.place);
  std::string text = item.text;
  const auto filling = text.find(of_filling);
  if (item.kind == Value::Kind::text && filling != std::string::npos && filling + of_filling.size() == text.size()) {
    time.of_filling = true;
    Value part = item;
    part.text = text.substr(0, filling);
    time.value = number_of(wanted, part, "1");
  } else if (item.kind == Value::Kind::text && text.find('%') != std::string::npos) {
    complaints_->add(item.place, {name + " = " + item.shown() + " is not a time", "a part needs a whole",
                                  "Write a time as in \"1800 s\", or \"25 % of filling\"."});
    return std::nullopt;
  } else {
    time.value = number_of(wanted, item, "s");
  }
  if (!std::isfinite(time.value)) return std::nullopt;
  const double most = time.of_filling ? 1e3 : 1e11;  // 3000 years
  if (time.value < 0 || time.value > most) {
    complaints_->add(item.place, {name + " = " + item.shown() + " is out of range",
                                  "the run starts at 0 s and must end", "Check the sign and the unit."});
    return std::nullopt;
  }
  return time;
}

std::optional<SceneTime> SectionReader::time(const std::string& name) {
  const Value* written = raw(name);
  return written ? item_time(name, *written) : std::nullopt;
}

std::vector<SceneTime> SectionReader::times(const std::string& name) {
  const Value* written = raw(name);
  if (!written) return {};
  if (written->kind != Value::Kind::array || written->items.empty()) {
    complain(name, {shown(name) + " is not a list of times", key(name).meaning, "Write " + assignment(key(name))});
    return {};
  }
  std::vector<SceneTime> times;
  for (const Value& item : written->items)
    if (const auto time = item_time(name, item)) times.push_back(*time);
  return times;
}

std::optional<SectionReader> SectionReader::table(const std::string& name) {
  const Value* written = raw(name);
  if (!written) return std::nullopt;
  if (written->kind != Value::Kind::table) {
    complain(name, {shown(name) + " is not a table", key(name).meaning, "Write " + assignment(key(name))});
    return std::nullopt;
  }
  SectionReader inner(*written, section_ + "." + name, table_->find(name)->place, *complaints_);
  inner.weigh_water(unit_weight_);
  return inner;
}

}  // namespace wetfront::verification
