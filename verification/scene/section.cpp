#include "verification/scene/section.h"

#include "verification/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace wetfront::verification {
namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
const std::string of_filling = "of filling";

std::string head(const std::string& section, bool list) {
  return section.empty() ? "the scene" : list ? "[[" + section + "]]" : "[" + section + "]";
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string> names_in(const std::string& section) {
  std::vector<std::string> names;
  for (const Key* key : keys_of(section)) names.push_back(key->name);
  if (section.empty())
    for (const Section& other : sections())
      if (!other.name.empty() && other.name.find('.') == std::string::npos) names.push_back(other.name);
  return names;
}

std::string bounds(const Range& range) {
  const std::string from = (range.open_from ? "above " : "at least ") + range.from;
  const std::string to = (range.open_to ? "below " : "at most ") + range.to;
  return range.from.empty() ? to : range.to.empty() ? from : from + " and " + to;
}

}  // namespace

SectionReader::SectionReader(const Value& table, const std::string& section, Place place, Complaints& complaints)
    : table_(&table), section_(section), place_(place), complaints_(&complaints) {
  check_names();
  check_presence();
}

const Key& SectionReader::key(const std::string& name) const {
  const Key* found = find_key(section_, name);
  if (!found) throw std::logic_error("'" + name + "' is not in the table of keys of [" + section_ + "]");
  return *found;
}

Place SectionReader::place_of(const std::string& name) const {
  const Entry* entry = table_->find(name);
  return entry ? entry->value.place : place_;
}

std::string SectionReader::shown(const std::string& name) const {
  const Entry* entry = table_->find(name);
  return entry ? name + " = " + entry->value.shown() : name;
}

void SectionReader::check_names() {
  const std::vector<std::string> names = names_in(section_);
  const bool list = section_named(section_).list;
  for (const Entry& entry : table_->entries) {
    if (contains(names, entry.key)) continue;
    std::string suggestion = suggest(entry.key, names, "Known are");
    if (suggestion.find("Did you mean") == std::string::npos)
      for (const Section& other : sections())
        if (find_key(other.name, entry.key))
          suggestion = "'" + entry.key + "' belongs into " + head(other.name, other.list) + ".";
    complaints_->add(entry.place, {fmt::format("unknown key '{}' in {}", entry.key, head(section_, list)),
                                   "a key that nothing reads would change nothing", suggestion});
  }
}

void SectionReader::check_presence() {
  for (const Key* key : keys_of(section_)) {
    const std::string& selector = key->with_key;
    if (selector.empty()) {
      if (key->presence == Presence::required && !has(key->name)) missing(key->name, key->meaning);
      continue;
    }
    const Key& selecting = this->key(selector);
    const Entry* entry = table_->find(selector);
    const std::string chosen = entry ? entry->value.text : selecting.fallback;
    if (entry && !contains(selecting.choices, chosen)) continue;  // complained of elsewhere
    const bool counts = contains(key->with_choices, chosen);
    if (counts && key->presence == Presence::required && !has(key->name)) missing(key->name, key->meaning);
    if (!counts && has(key->name))
      unused(key->name, fmt::format("it counts only with {} = {}", selector, alternatives(key->with_choices)),
             "Remove it, or change " + selector + ".");
  }
  const std::vector<std::string>& one_of = section_named(section_).one_of;
  std::vector<std::string> given;
  for (const std::string& name : one_of)
    if (has(name)) given.push_back(name);
  if (!one_of.empty() && given.empty())
    complaints_->add(
        place_, {fmt::format("{} gives none of {}", head(section_, section_named(section_).list), alternatives(one_of)),
                 "one of them is needed", fmt::format("Add {}", assignment(key(one_of[0])))});
  for (std::size_t i = 1; i < given.size(); ++i)
    complaints_->add(place_of(given[i]), {fmt::format("{} is given beside {}", given[i], given[0]),
                                          "they say the same thing in two ways", "Keep one of the two."});
}

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
  if (value->kind == Value::Kind::text && contains(wanted.choices, value->text)) return value->text;
  const std::string near = nearest(value->text, wanted.choices);
  complain(name, {shown(name) + " is not known", "it is one of " + alternatives(wanted.choices),
                  near.empty() ? "" : "Did you mean \"" + near + "\"?"});
  return "";
}

double SectionReader::number_of(const Key& wanted, const Value& written, const std::string& unit) {
  if (written.is_number() && unit == "1" && std::isfinite(written.number)) return written.number;
  const std::string given = wanted.name + " = " + written.shown();
  Complaint complaint{given + " is not a number with a unit", dimension(unit) + " is wanted",
                      "Write it as in \"" + example_of(unit) + "\"."};
  if (written.kind == Value::Kind::text) {
    const auto read = read_quantity(written.text, unit);
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
  complaints_->add(written.place, complaint);
  return absent;
}

bool SectionReader::in_range(const Key& wanted, double value, const Value& written) {
  const auto bound = [&](const std::string& text) {
    return wanted.takes == Takes::count ? std::stod(text) : std::get<double>(read_quantity(text, wanted.unit));
  };
  const Range& range = wanted.range;
  const bool low = !range.from.empty() && (range.open_from ? value <= bound(range.from) : value < bound(range.from));
  const bool high = !range.to.empty() && (range.open_to ? value >= bound(range.to) : value > bound(range.to));
  if (low || high)
    complaints_->add(
        written.place,
        {wanted.name + " = " + written.shown() + " is out of range", "it must be " + bounds(range),
         wanted.takes == Takes::quantity && wanted.unit != "1" ? "Check the sign, the unit and the exponent."
                                                               : "Write it as in " + assignment(wanted)});
  return !low && !high;
}

double SectionReader::quantity(const std::string& name) {
  const Key& wanted = key(name);
  const Value* written = raw(name);
  if (!written) return wanted.fallback.empty() ? absent : std::get<double>(read_quantity(wanted.fallback, wanted.unit));
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
  return SectionReader(*written, section_ + "." + name, table_->find(name)->place, *complaints_);
}

const Value* SectionReader::raw(const std::string& name) {
  key(name);
  read_.insert(name);
  const Entry* entry = table_->find(name);
  return entry ? &entry->value : nullptr;
}

void SectionReader::complain(const std::string& name, const Complaint& complaint) {
  read_.insert(name);
  complaints_->add(place_of(name), complaint);
}

void SectionReader::unused(const std::string& name, const std::string& why, const std::string& suggestion) {
  read_.insert(name);
  const Entry* entry = table_->find(name);
  if (entry) complaints_->add(entry->place, {"the value of '" + name + "' is not used", why, suggestion});
}

void SectionReader::missing(const std::string& name, const std::string& why) {
  read_.insert(name);
  complaints_->add(place_, {fmt::format("{} has no '{}'", head(section_, section_named(section_).list), name), why,
                            "Add " + assignment(key(name))});
}

void SectionReader::finish() {
  for (const Key* key : keys_of(section_))
    if (has(key->name) && !read_.count(key->name)) unused(key->name, "nothing in this scene asks for it", "Remove it.");
}

std::vector<SectionReader> sections_of(const Value& root, const std::string& name, Complaints& complaints) {
  const Section& section = section_named(name);
  const Entry* entry = root.find(name);
  std::vector<SectionReader> readers;
  const std::string header = head(name, section.list);
  if (!entry) {
    if (section.needed)
      complaints.add({1, 1}, {"the scene has no " + header, section.meaning,
                              "Add it; `wetfront new NAME` writes a scene to start from."});
    return readers;
  }
  const bool is_list = entry->value.kind == Value::Kind::array && !entry->value.items.empty() &&
                       std::all_of(entry->value.items.begin(), entry->value.items.end(),
                                   [](const Value& item) { return item.kind == Value::Kind::table; });
  if (section.list != is_list || (!section.list && entry->value.kind != Value::Kind::table)) {
    complaints.add(entry->place, {"'" + name + "' is not written as " + header,
                                  section.list ? "there may be several of it" : "there is only one of it",
                                  "Start the section with the line " + header + "."});
    return readers;
  }
  if (!section.list) readers.emplace_back(entry->value, name, entry->place, complaints);
  for (const Value& item : entry->value.items) readers.emplace_back(item, name, item.place, complaints);
  return readers;
}

std::optional<SectionReader> section_of(const Value& root, const std::string& name, Complaints& complaints) {
  std::vector<SectionReader> found = sections_of(root, name, complaints);
  return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

}  // namespace wetfront::verification
