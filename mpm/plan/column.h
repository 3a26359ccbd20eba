#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// Structure-of-arrays fields. A field exists only when an effect provides it: an effect that no scene
/// entry calls for has no column.
namespace wetfront::mpm {

enum class Lifetime {
  carried,  ///< part of the state of a run
  step,     ///< holds nothing of value between two steps, or can be rebuilt from carried columns
};

struct ColumnSpec {
  std::string name, symbol, unit;
  int components = 1;
  Lifetime lifetime = Lifetime::carried;
};

/// One field over `size` points (or nodes): component c of item i is `column[c][i]`.
class Column {
 public:
  Column(std::string name, std::size_t size) : size_(size) { spec_.name = std::move(name); }

  const ColumnSpec& spec() const { return spec_; }
  /// The effect that provides it in the present plan; empty: nobody does.
  const std::string& provided_by() const { return provided_by_; }
  bool allocated() const { return !values_.empty() || size_ == 0; }
  std::size_t size() const { return size_; }

  double* operator[](int component) { return values_.data() + static_cast<std::size_t>(component) * size_; }
  const double* operator[](int component) const { return values_.data() + static_cast<std::size_t>(component) * size_; }
  std::span<double> values() { return values_; }
  std::span<const double> values() const { return values_; }
  void fill(double value);
  /// Of all its values.
  double sum() const;
  /// New values for another number of items.
  void replace(std::vector<double> values, std::size_t size) {
    values_ = std::move(values);
    size_ = size;
  }

 private:
  friend class ColumnSet;
  ColumnSpec spec_;
  std::string provided_by_;
  std::size_t size_;
  std::vector<double> values_;
};

/// The columns over one kind of item. Addresses of columns are stable: kernels keep references.
class ColumnSet {
 public:
  explicit ColumnSet(std::size_t size) : size_(size) {}

  /// Forgets who provides what, keeps the data: the first act of making a plan.
  void begin_plan();
  /// Announces a column; one that already holds data keeps it. Throws std::logic_error when two effects
  /// provide the same column.
  Column& provide(const ColumnSpec& spec, const std::string& effect);
  /// A reference to a column that some effect of the plan has to provide, before or later.
  Column& require(const std::string& name);
  /// Gives memory (zeros) to every provided column that has none.
  void allocate();
  /// Frees every column that nobody provides.
  void free_unprovided();

  Column* find(const std::string& name);
  const Column* find(const std::string& name) const;
  /// The column where it holds data, of this plan or of one before; nullptr elsewhere.
  Column* find_allocated(const std::string& name);
  const Column* find_allocated(const std::string& name) const;
  /// The column, allocated and provided; throws std::out_of_range naming it otherwise.
  Column& at(const std::string& name);

  std::size_t size() const { return size_; }
  /// Another number of items from now on; what its columns hold is replaced by zeros.
  void resize(std::size_t size);
  /// The same for columns yet to come; those that hold data have been given it in the new size already.
  void set_size(std::size_t size) { size_ = size; }
  const std::vector<std::unique_ptr<Column>>& all() const { return columns_; }

 private:
  Column& get_or_make(const std::string& name);
  std::size_t size_;
  std::vector<std::unique_ptr<Column>> columns_;
};

}  // namespace wetfront::mpm
