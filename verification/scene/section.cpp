#include "verification/scene/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace wetfront::verification {
namespace {

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
    const std::string near = nearest(entry.key, names);
    misspelt_.insert(near);
    std::string suggestion = near.empty() ? "" : "Did you mean '" + near + "'?";
    for (const Section& other : sections())
      if (find_key(other.name, entry.key)) {
        suggestion = (near.empty() ? "" : suggestion + " Or ") + "'" + entry.key + "' belongs in " +
                     head(other.name, other.list) + ".";
        break;
      }
    if (suggestion.empty()) suggestion = "Known are " + alternatives(names) + ".";
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
    if (entry && !contains(selecting.choices, chosen)) {  // complained of when it is read
      read_.insert(key->name);
      continue;
    }
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
  if (misspelt_.count(name)) return;  // said already, where it stands
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
