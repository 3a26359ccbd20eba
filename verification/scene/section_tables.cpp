#include "verification/scene/section_tables.h"

#include "verification/scene/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

bool names_a_file(const Value& value) {
  return value.kind == Value::Kind::text && value.text.size() > 4 && value.text.ends_with(".csv");
}

CsvForm form_of(const Key& key) {
  std::string row;
  for (std::size_t i = 0; i < key.columns.size(); ++i) row += i == 0 ? "0" : ", 1";
  return {"file of " + key.name, {key.columns}, row};
}

/// Rows [time, ...]: no value out of the key's range, no time before the run.
void check_rows(SectionReader& reader, const std::string& name, Rows& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t c = 1; c < rows.column.size(); ++c) {
      const std::string missed = reader.range_missed(name, rows.column[c][i]);
      if (!missed.empty())
        rows.complain(i, {fmt::format("{} is out of range", name), "it must be " + missed,
                          "Check the sign, the unit and the exponent."});
    }
    if (rows.column[0][i] < 0)
      rows.complain(i, {fmt::format("the record of {} starts before the run", name),
                        fmt::format("at {:g} s", rows.column[0][i]), "The run starts at 0 s."});
  }
}

}  // namespace

void Rows::complain(std::size_t row, const Complaint& complaint) {
  if (file_.empty())
    complaints_->add(place_[row], complaint);
  else
    complaints_->add_elsewhere(place_.front(), file_, {line_[row], 1}, complaint);
}

Rows read_pairs(SectionReader& reader, const std::string& name, const std::filesystem::path& folder) {
  const Value* written = reader.raw(name);
  const Key& key = reader.key(name);
  Rows rows;
  rows.complaints_ = &reader.complaints();
  if (!written) return rows;
  if (names_a_file(*written)) {
    CsvTable table =
        read_csv(folder / written->text, form_of(key), reader.unit_weight(), written->place, reader.complaints());
    rows.place_ = {written->place};
    rows.file_ = (folder / written->text).string();
    rows.line_ = table.line;
    if (table.sound) rows.column = table.column;
    return rows;
  }
  const std::size_t columns = key.columns.size();
  std::vector<std::vector<double>> read(columns);
  const bool list = written->kind == Value::Kind::array && !written->items.empty() &&
                    std::all_of(written->items.begin(), written->items.end(), [&](const Value& row) {
                      return row.kind == Value::Kind::array && row.items.size() == columns;
                    });
  if (!list) {
    std::string names;
    for (const TableColumn& column : key.columns) names += (names.empty() ? "" : ", ") + column.name;
    reader.complain(name, {reader.shown(name) + " is neither a list of [" + names + "] nor the name of a .csv file",
                           key.meaning, "Write " + assignment(key)});
    return rows;
  }
  bool sound = true;
  for (const Value& row : written->items) {
    rows.place_.push_back(row.place);
    for (std::size_t i = 0; i < columns; ++i) {
      read[i].push_back(reader.item_quantity(name, row.items[i], key.columns[i].unit));
      sound = sound && std::isfinite(read[i].back());
    }
  }
  if (sound) rows.column = read;
  return rows;
}

bool takes_rows(SectionReader& reader, const std::string& name) {
  const Value* written = reader.has(name) ? reader.raw(name) : nullptr;
  return written && (written->kind == Value::Kind::array || names_a_file(*written));
}

Rows read_record(SectionReader& reader, const std::string& name, const std::filesystem::path& folder) {
  const Value* written = reader.raw(name);
  if (written && !takes_rows(reader, name)) {
    Rows rows;
    rows.complaints_ = &reader.complaints();
    rows.place_ = {written->place};
    const double value = reader.item_in_range(name, *written);
    if (std::isfinite(value)) rows.column = {{0.0}, {value}};
    return rows;
  }
  Rows rows = read_pairs(reader, name, folder);
  check_rows(reader, name, rows);
  return rows;
}

Rows read_vectors(SectionReader& reader, const std::string& name, const std::filesystem::path& folder) {
  const Value* written = reader.raw(name);
  const bool rows_written =
      written && (names_a_file(*written) ||
                  (written->kind == Value::Kind::array && std::ranges::any_of(written->items, [](const Value& item) {
                     return item.kind == Value::Kind::array;
                   })));
  if (!written || rows_written) {
    Rows rows = read_pairs(reader, name, folder);
    check_rows(reader, name, rows);
    return rows;
  }
  Rows rows;
  rows.complaints_ = &reader.complaints();
  rows.place_ = {written->place};
  const Key& key = reader.key(name);
  if (written->kind != Value::Kind::array || written->items.size() != 2) {
    reader.complain(name, {reader.shown(name) + " is not a list of x and y", "soil that deforms lies in the plane x, y",
                           "Write " + assignment(key)});
    return rows;
  }
  const double x = reader.item_in_range(name, written->items[0]), y = reader.item_in_range(name, written->items[1]);
  if (std::isfinite(x) && std::isfinite(y)) rows.column = {{0.0}, {x}, {y}};
  return rows;
}

void check_ascending(Rows& rows, std::size_t c, bool strictly, const std::string& what) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double before = rows.column[c][i - 1], here = rows.column[c][i];
    if (here < before || (strictly && here == before))
      rows.complain(i, {what + " do not ascend", fmt::format("{:g} follows {:g}", here, before),
                        strictly ? "Sort the rows, each value once." : "Sort the rows."});
  }
}

}  // namespace wetfront::verification
