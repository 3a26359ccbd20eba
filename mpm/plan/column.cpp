#include "mpm/plan/column.h"

#include "mpm/plan/long_zeros.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace wetfront::mpm {

void Column::fill(double value) {
  std::fill(values_.begin(), values_.end(), value);
}

double Column::sum() const {
  return std::accumulate(values_.begin(), values_.end(), 0.0);
}

void ColumnSet::begin_plan() {
  for (auto& column : columns_) column->provided_by_.clear();
}

Column& ColumnSet::provide(const ColumnSpec& spec, const std::string& effect) {
  Column& column = get_or_make(spec.name);
  if (!column.provided_by_.empty())
    throw std::logic_error("column '" + spec.name + "' is provided twice (by '" + column.provided_by_ + "' and by '" +
                           effect + "'; a column has one owner). Let one of them require it");
  const bool other_shape = column.allocated() && column.spec_.components != spec.components;
  if (other_shape) std::vector<double>().swap(column.values_);
  column.spec_ = spec;
  column.provided_by_ = effect;
  return column;
}

Column& ColumnSet::require(const std::string& name) {
  return get_or_make(name);
}

void ColumnSet::allocate() {
  std::vector<Column*> fresh;
  std::vector<std::size_t> counts;
  for (auto& column : columns_)
    if (!column->provided_by_.empty() && column->values_.empty()) {
      fresh.push_back(column.get());
      counts.push_back(size_ * static_cast<std::size_t>(column->spec_.components));
    }
  auto values = long_zeros(counts);
  for (std::size_t k = 0; k < fresh.size(); ++k) fresh[k]->values_ = std::move(values[k]);
}

void ColumnSet::resize(std::size_t size) {
  size_ = size;
  std::vector<std::size_t> counts;
  for (const auto& column : columns_)
    counts.push_back(size * (column->allocated() ? static_cast<std::size_t>(column->spec_.components) : 0));
  auto values = long_zeros(counts);
  for (std::size_t k = 0; k < counts.size(); ++k) columns_[k]->replace(std::move(values[k]), size);
}

void ColumnSet::free_unprovided() {
  std::erase_if(columns_, [](const auto& column) { return column->provided_by_.empty(); });
}

Column* ColumnSet::find(const std::string& name) {
  for (auto& column : columns_)
    if (column->spec_.name == name) return column.get();
  return nullptr;
}

const Column* ColumnSet::find(const std::string& name) const {
  return const_cast<ColumnSet*>(this)->find(name);
}

Column* ColumnSet::find_allocated(const std::string& name) {
  Column* column = find(name);
  return column != nullptr && column->allocated() ? column : nullptr;
}

const Column* ColumnSet::find_allocated(const std::string& name) const {
  return const_cast<ColumnSet*>(this)->find_allocated(name);
}

Column& ColumnSet::at(const std::string& name) {
  Column* column = find_allocated(name);
  if (column == nullptr) throw std::out_of_range("no column '" + name + "' in this plan");
  return *column;
}

Column& ColumnSet::get_or_make(const std::string& name) {
  if (Column* column = find(name)) return *column;
  columns_.push_back(std::make_unique<Column>(name, size_));
  return *columns_.back();
}

}  // namespace wetfront::mpm
