#include "verification/scene/set_value.h"

#include "verification/scene/document.h"
#include "verification/scene/keys.h"
#include "verification/scene/read.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace wetfront::verification {
namespace {

[[noreturn]] void refuse(const std::string& path, const Complaint& complaint) {
  throw SceneError({"--set " + path + ": " + complaint.text()});
}

/// `soil[sand].retention.lambda` -> {soil, sand, retention, lambda}. Dots within brackets belong to a name.
std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps(1);
  bool inside = false;
  for (const char c : path) {
    if (c == '[' && !inside) {
      inside = true;
      if (!steps.back().empty()) steps.emplace_back();
    } else if (c == ']' && inside) {
      inside = false;
    } else if (c == '.' && !inside) {
      steps.emplace_back();
    } else {
      steps.back() += c;
    }
  }
  if (inside || std::ranges::any_of(steps, [](const auto& step) { return step.empty(); }))
    refuse(path, {"this is no path to a value", "keys are joined by dots, and brackets are closed",
                  "Write e.g. rain.intensity or soil[sand].porosity."});
  return steps;
}

/// Bytes before a place: toml++ counts columns in code points.
std::size_t offset(const std::string& text, Place place) {
  std::size_t at = 0;
  for (int line = 1; line < place.line; ++line) {
    const std::size_t next = text.find('\n', at);
    if (next == std::string::npos) return text.size();
    at = next + 1;
  }
  for (int column = 1; column < place.column && at < text.size(); ++column) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
  }
  return at;
}

std::size_t start_of_line(const std::string& text, std::size_t at) {
  return text.rfind('\n', at) + 1;  // npos + 1: the first line
}

std::size_t end_of_line(const std::string& text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

/// Of what is no number: whether a scene writes it without quotation marks.
bool bare(const std::string& value) {
  return value == "true" || value == "false" || value.front() == '[' || value.front() == '{' || value.front() == '"';
}

/// The value as a scene writes it. A number keeps the unit of the text that it replaces, and stays a text where that is
/// no number.
std::string literal(const std::string& value, const Value* old) {
  const auto [number, unit] = number_and_unit(value);
  if (number.empty() || !unit.empty()) return bare(value) ? value : '"' + value + '"';
  if (old == nullptr || old->kind != Value::Kind::text) return value;
  const NumberAndUnit before = number_and_unit(old->text);
  if (before.number.empty()) return '"' + value + '"';
  return before.unit.empty() ? value : '"' + value + ' ' + before.unit + '"';
}

/// What a table of a list may be told by, besides its number.
std::vector<std::string> called(const Value& table) {
  std::vector<std::string> names;
  for (const char* key : {"name", "side", "quantity"})
    if (const Entry* entry = table.find(key)) names.push_back(entry->value.text);
  return names;
}

/// Which of the tables of a list a step means; nothing: it names none of them.
std::optional<std::size_t> chosen(const Value& list, const std::string& step) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
  if (error == std::errc{} && end == step.data() + step.size())
    return index < list.items.size() ? std::optional(index) : std::nullopt;
  for (std::size_t i = 0; i < list.items.size(); ++i)
    if (std::ranges::count(called(list.items[i]), step) > 0) return i;
  return {};
}

std::string one_of(const Value& list, const std::string& section) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const std::vector<std::string> own = called(list.items[i]);
    names.push_back(section + "[" + (own.empty() ? std::to_string(i) : own.front()) + "]");
  }
  return alternatives(names);
}

std::vector<std::string> keys_and_sections(const std::string& section) {
  std::vector<std::string> names;
  for (const Key* key : keys_of(section)) names.push_back(key->name);
  for (const Section& other : sections())
    if (section.empty() && !other.name.empty() && other.name.find('.') == std::string::npos)
      names.push_back(other.name);
  return names;
}

/// Follows a path through a document and edits the text where it ends.
class Editor {
 public:
  Editor(const std::string& text, const Setting& setting, const Value& root)
      : text_(text), setting_(setting), root_(root), steps_(steps_of(setting.path)) {}

  std::string edited() {
    if (steps_.size() == 2 && steps_[1] == "+") return with_entry();
    const Value* at = &root_;
    const Entry* entry = nullptr;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      at = in_list(at, i);
      if (i == steps_.size()) return without_section(*at);
      if (at->kind == Value::Kind::array) {
        at = item(*at, steps_[i]);
        entry = nullptr;
        continue;
      }
      if (at->kind != Value::Kind::table)
        refuse(setting_.path, {"nothing lies below " + at->shown(), "it is a value", "Shorten the path."});
      entry = at->find(steps_[i]);
      if (!entry) return with_new(*at, i);
      section_ += (section_.empty() ? "" : ".") + steps_[i];
      at = &entry->value;
    }
    if (in_several(*at)) refuse_which(*at);
    if (setting_.value.empty()) return without(*at, entry);
    unit_ = number_and_unit(at->text).unit;
    if (at->kind == Value::Kind::table && setting_.value.front() != '{')
      refuse(setting_.path, {"this is a section", "only values can be set",
                             "Name a key in it: " + alternatives(keys_and_sections(section_)) + "."});
    return replaced(offset(text_, at->place), offset(text_, at->end), literal(setting_.value, at));
  }

  /// Of the value that was there; after edited().
  const std::string& unit() const { return unit_; }

 private:
  std::string replaced(std::size_t from, std::size_t to, const std::string& by) const {
    return text_.substr(0, from) + by + text_.substr(to);
  }

  /// Into the table of a list that step i tells, or into the only one. Moves past that step.
  const Value* in_list(const Value* at, std::size_t& i) const {
    if (!in_several(*at)) return at;
    if (const auto index = chosen(*at, steps_[i])) {
      at = &at->items[*index];
      if (++i == steps_.size() && !setting_.value.empty())
        refuse(setting_.path, {"this is a section", "only values can be set", "Name a key in it."});
      return at;
    }
    const bool number = std::ranges::all_of(steps_[i], [](unsigned char c) { return std::isdigit(c); });
    if (at->items.size() == 1 && !number) return &at->items.front();
    refuse_which(*at);
  }

  /// A list of sections.
  static bool in_several(const Value& value) {
    return value.kind == Value::Kind::array && !value.items.empty() && value.items.front().kind == Value::Kind::table;
  }

  [[noreturn]] void refuse_which(const Value& list) const {
    refuse(setting_.path,
           {"it is not said which [[" + section_ + "]] is meant", "the scene has " + std::to_string(list.items.size()),
            "Write " + one_of(list, section_) + " and then the key."});
  }

  const Value* item(const Value& list, const std::string& step) const {
    if (const auto index = chosen(list, step)) return &list.items[*index];
    refuse(setting_.path,
           {"there is no entry " + step, "the list has " + std::to_string(list.items.size()) + ", counted from 0",
            "Use a smaller number."});
  }

  /// A key, or a section with a key, that the scene does not have yet.
  std::string with_new(const Value& table, std::size_t step) const {
    const std::string& name = steps_[step];
    const std::vector<std::string> known = keys_and_sections(section_);
    if (std::ranges::find(known, name) == known.end())
      refuse(setting_.path,
             {"there is no '" + name + "' in " + (section_.empty() ? "a scene" : "[" + section_ + "]"),
              known.size() > 12 ? "what nothing reads would change nothing" : "known are " + alternatives(known),
              suggest(name, known)});
    if (setting_.value.empty()) return text_;  // left out already
    const bool last = step + 1 == steps_.size();
    const std::string inner = section_.empty() ? name : section_ + "." + name;
    const std::string key = last ? name : steps_.back();
    const Key* row = last ? find_key(section_, name) : find_key(inner, key);
    if (step + 2 < steps_.size() || !row || (row->takes == Takes::table && !(last && setting_.value.front() == '{')))
      refuse(setting_.path, {"the scene has no [" + inner + "] in which this could be set",
                             "too much would have to be made up", "Write that part into the scene first."});
    const std::string line = key + " = " + literal(setting_.value, nullptr);
    if (last) return inserted(table, line);
    if (find_key(section_, name)) return inserted(table, name + " = { " + line + " }");
    return text_ + (text_.empty() || text_.back() == '\n' ? "" : "\n") + "\n[" + inner + "]\n" + line + "\n";
  }

  /// One more of what there may be several of: `boundary[+]` set to `{ side = "left", skeleton = "roller" }`.
  std::string with_entry() const {
    const auto found = std::ranges::find(sections(), steps_[0], &Section::name);
    const std::string& value = setting_.value;
    if (found == sections().end() || !found->list || value.size() < 2 || value.front() != '{' || value.back() != '}')
      refuse(setting_.path, {"nothing can be added like this", "[+] adds one of what there may be several of",
                             "Write e.g. boundary[+]={ side = \"left\", water = \"impermeable\" }."});
    std::string lines;
    for (const std::string& line : split_at_commas(value.substr(1, value.size() - 2))) lines += line + "\n";
    return text_ + (text_.empty() || text_.back() == '\n' ? "" : "\n") + "\n[[" + steps_[0] + "]]\n" + lines;
  }

  std::string inserted(const Value& table, const std::string& line) const {
    if (&table == &root_) return line + "\n" + text_;
    const std::size_t at = offset(text_, table.place);
    if (text_[at] == '{') {
      const bool empty = table.entries.empty();
      return replaced(at + 1, at + 1, " " + line + (empty ? " " : ","));
    }
    const std::size_t end = end_of_line(text_, at);
    return replaced(end, end, "\n" + line);
  }

  /// Without a key: its line goes, or its place between commas.
  std::string without(const Value& value, const Entry* entry) const {
    if (!entry)
      refuse(setting_.path,
             {"an entry of a list cannot be left out", "the others would change their places", "Set the whole list."});
    const std::size_t from = offset(text_, entry->place), to = offset(text_, value.end);
    const std::size_t start = start_of_line(text_, from);
    const bool own_line = text_.find_first_not_of(" \t", start) == from;
    if (own_line && (value.kind != Value::Kind::table || text_[from] != '['))
      return replaced(start, std::min(end_of_line(text_, to) + 1, text_.size()), "");
    if (text_[offset(text_, value.place)] == '[' && value.kind == Value::Kind::table) return without_section(value);
    std::size_t after = text_.find_first_not_of(" \t", to);
    if (after != std::string::npos && text_[after] == ',') return replaced(from, after + 1, "");
    const std::size_t comma = text_.find_last_not_of(" \t", from - 1);
    return replaced(comma != std::string::npos && text_[comma] == ',' ? comma : from, to, "");
  }

  /// Without a section, `tolerance[front_position]` of several: its header, keys and sections below it.
  std::string without_section(const Value& table) const {
    const std::size_t start = start_of_line(text_, offset(text_, table.place));
    const std::size_t end = std::min(end_of_line(text_, end_of(table)) + 1, text_.size());
    const std::string own = "[" + section_ + ".", list = "[[" + section_ + ".";
    bool scattered = text_[start] != '[';
    for (std::size_t at = end_of_line(text_, start) + 1; at < end; at = end_of_line(text_, at) + 1)
      scattered = scattered || (text_[at] == '[' && text_.compare(at, own.size(), own) != 0 &&
                                text_.compare(at, list.size(), list) != 0);
    if (scattered)
      refuse(setting_.path, {"this section cannot be left out", "it is not written in one piece under its header",
                             "Leave out its keys."});
    return replaced(start, end, "");
  }

  /// Where the last key of a section ends, as bytes before it.
  std::size_t end_of(const Value& value) const {
    std::size_t last = offset(text_, value.end);
    for (const Entry& entry : value.entries) last = std::max(last, end_of(entry.value));
    for (const Value& inner : value.items) last = std::max(last, end_of(inner));
    return last;
  }

  const std::string& text_;
  const Setting& setting_;
  const Value& root_;
  std::vector<std::string> steps_;
  std::string section_, unit_;
};

}  // namespace

std::string with_value(const std::string& text, const std::string& file, const Setting& setting) {
  const Value root = parse_document(text, file);
  return Editor(text, setting, root).edited();
}

std::string written_unit(const std::string& text, const std::string& path) {
  const Setting probe{path, "1"};
  const Value root = parse_document(text, "the scene");
  Editor editor(text, probe, root);
  editor.edited();
  return editor.unit();
}

}  // namespace wetfront::verification
