#pragma once

#include "verification/scene/document.h"
#include "verification/scene/keys.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wetfront::verification {

/// One section of a scene seen through the table of keys: checks what is written, converts it to SI and
/// complains. Values that are absent and have no default, or that were complained of, come back as NaN,
/// "" or empty, so that reading goes on and finds the other mistakes too: compare such that NaN is harmless.
class SectionReader {
 public:
  /// Complains at once of unknown keys, missing required ones and of alternatives given twice or not at all.
  SectionReader(const Value& table, const std::string& section, Place place, Complaints& complaints);

  bool has(const std::string& name) const { return table_->find(name) != nullptr; }
  Place place() const { return place_; }
  /// Of the value, or of the section where it is absent.
  Place place_of(const std::string& name) const;
  Origin origin() const { return complaints_->origin(place_); }
  Origin origin_of(const std::string& name) const { return complaints_->origin(place_of(name)); }
  /// `name = "as written"`.
  std::string shown(const std::string& name) const;

  /// rho g [Pa/m], with which "Pa or m" reads heads; to be said before any is read. Tables inside inherit it.
  void weigh_water(double unit_weight) { unit_weight_ = unit_weight; }

  std::string text(const std::string& name);
  std::string choice(const std::string& name);
  double quantity(const std::string& name);
  int count(const std::string& name);
  std::vector<double> vector(const std::string& name);
  /// Two numbers, the second above the first; empty when absent or wrong.
  std::vector<double> range(const std::string& name);
  std::vector<int> counts(const std::string& name);
  std::optional<SceneTime> time(const std::string& name);
  std::vector<SceneTime> times(const std::string& name);
  std::optional<SectionReader> table(const std::string& name);
  /// Its row in the table of keys.
  const Key& key(const std::string& name) const;
  Complaints& complaints() { return *complaints_; }
  double unit_weight() const { return unit_weight_; }
  /// The value itself, for keys with a grammar of their own; nullptr when absent.
  const Value* raw(const std::string& name);

  void complain(const std::string& name, const Complaint& complaint);
  void complain_at(Place place, const Complaint& complaint) { complaints_->add(place, complaint); }
  /// The key is given but does nothing here.
  void unused(const std::string& name, const std::string& why, const std::string& suggestion);
  /// A key that circumstances require is absent.
  void missing(const std::string& name, const std::string& why);
  /// Complains of every value that nothing has read. To be called last.
  void finish();

  /// "" when the key's range holds the value [SI], else the range: "at least 0 m/s and at most 0.1 m/s".
  std::string range_missed(const std::string& name, double value) const;
  /// Of an item of a list, e.g. one time of a series.
  double item_quantity(const std::string& name, const Value& item, const std::string& unit);
  /// The same, and within the range of the key.
  double item_in_range(const std::string& name, const Value& item);
  std::optional<SceneTime> item_time(const std::string& name, const Value& item);

 private:
  void check_names();
  void check_presence();
  bool in_range(const Key& key, double value, const Value& written);
  double number_of(const Key& key, const Value& written, const std::string& unit);

  const Value* table_;
  std::string section_;
  double unit_weight_ = 0;
  Place place_;
  Complaints* complaints_;
  std::set<std::string> read_;
  std::set<std::string> misspelt_;  ///< known keys that an unknown one was probably meant to be
};

/// The sections of that name at the top of the document: none, one, or as many as [[name]] were written.
std::vector<SectionReader> sections_of(const Value& root, const std::string& name, Complaints& complaints);
/// For a section that stands at most once.
std::optional<SectionReader> section_of(const Value& root, const std::string& name, Complaints& complaints);

}  // namespace wetfront::verification
