#include "fem_reference/problem_message.h"

#include <cstring>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace wetfront::fem_reference {
namespace {

// One description of every type serves both ways. Structured bindings stop compiling when a type grows an entry, so
// none can be forgotten here.
class Writer {
 public:
  std::vector<char> bytes;

  template <class... T>
  void operator()(const T&... values) {
    (one(values), ...);
  }
  void raw(const void* data, std::size_t size) {
    const char* from = static_cast<const char*>(data);
    bytes.insert(bytes.end(), from, from + size);
  }

 private:
  template <class T>
  void one(const T& value);
};

class Reader {
 public:
  explicit Reader(const std::vector<char>& bytes) : bytes_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (one(values), ...);
  }
  void raw(void* data, std::size_t size) {
    if (at_ + size > bytes_.size()) throw std::logic_error("a message between ranks is too short");
    std::memcpy(data, bytes_.data() + at_, size);
    at_ += size;
  }
  bool done() const { return at_ == bytes_.size(); }

 private:
  template <class T>
  void one(T& value);

  const std::vector<char>& bytes_;
  std::size_t at_ = 0;
};

template <class T, class U>
concept Is = std::is_same_v<std::remove_const_t<T>, U>;

void visit(auto& archive, Is<TabulatedRetention> auto& value) {
  auto& [head, content] = value;
  archive(head, content);
}
void visit(auto& archive, Is<TabulatedConductivity> auto& value) {
  auto& [head, relative] = value;
  archive(head, relative);
}
void visit(auto& archive, Is<Soil> auto& value) {
  auto& [name, retention, conductivity, saturated, storage, porosity, anisotropy, modulus, bishop] = value;
  archive(name, retention, conductivity, saturated, storage, porosity, anisotropy, modulus, bishop);
}
void visit(auto& archive, Is<TimeRecord> auto& value) {
  auto& [time, values] = value;
  archive(time, values);
}
void visit(auto& archive, Is<meshes::RainRecord> auto& value) {
  auto& [start, intensity] = value;
  archive(start, intensity);
}
void visit(auto& archive, Is<RainSide> auto& value) {
  auto& [side, rain, evaporation, minimum_head] = value;
  archive(side, rain, evaporation, minimum_head);
}
void visit(auto& archive, Is<FluxSide> auto& value) {
  auto& [side, inflow, minimum_head] = value;
  archive(side, inflow, minimum_head);
}
void visit(auto& archive, Is<HeadSide> auto& value) {
  auto& [side, head, record, total, initial, varying] = value;  // `varying` stays behind
  archive(side, head, record, total, initial);
}
void visit(auto& archive, Is<WaterLevelSide> auto& value) {
  auto& [side, level, rain] = value;
  archive(side, level, rain);
}
void visit(auto& archive, Is<PeriodicSides> auto& value) {
  auto& [side, partner] = value;
  archive(side, partner);
}
void visit(auto& archive, Is<FreeDrainageSide> auto& value) {
  auto& [side] = value;
  archive(side);
}
void visit(auto& archive, Is<Gauge> auto& value) {
  auto& [name, position] = value;
  archive(name, position);
}
void visit(auto& archive, Is<Adaptivity> auto& value) {
  auto& [levels, threshold] = value;
  archive(levels, threshold);
}
void visit(auto& archive, Is<meshes::Side> auto& value) {
  auto& [name, faces] = value;
  archive(name, faces);
}
void visit(auto& archive, Is<meshes::Mesh> auto& value) {
  auto& [dim, nodes, cells, region, region_names, sides] = value;
  archive(dim, nodes, cells, region, region_names, sides);
}
void visit(auto& archive, Is<RichardsProblem> auto& value) {
  auto& [mesh, gravity, weight, soils, factor, boundary, head, end, times, gauges, integrator, tolerance, degree,
         adaptivity, source] = value;  // `source` stays behind
  archive(mesh, gravity, weight, soils, factor, boundary, head, end, times, gauges, integrator, tolerance, degree,
          adaptivity);
}

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVariant : std::false_type {};
template <class... T>
struct IsVariant<std::variant<T...>> : std::true_type {};

template <class T>
void Writer::one(const T& value) {
  if constexpr (std::is_same_v<T, std::string> || IsVector<T>::value) {
    const std::size_t size = value.size();
    raw(&size, sizeof size);
    if constexpr (std::is_trivially_copyable_v<typename T::value_type>) {
      raw(value.data(), size * sizeof(typename T::value_type));
    } else {
      for (const auto& entry : value) one(entry);
    }
  } else if constexpr (IsVariant<T>::value) {
    const std::size_t index = value.index();
    raw(&index, sizeof index);
    std::visit([&](const auto& held) { one(held); }, value);
  } else if constexpr (IsOptional<T>::value) {
    one(value.has_value());
    if (value) visit(*this, *value);  // entry by entry: a struct's padding has no meaning
  } else if constexpr (std::is_empty_v<T>) {
    // its one byte has no meaning either
  } else if constexpr (std::is_trivially_copyable_v<T>) {  // numbers, and structs of nothing but doubles
    raw(&value, sizeof value);
  } else {
    visit(*this, value);
  }
}

template <std::size_t I = 0, class... T>
void choose(std::variant<T...>& value, std::size_t index) {
  if constexpr (I < sizeof...(T)) {
    if (index == I) {
      value = std::variant_alternative_t<I, std::variant<T...>>{};
    } else {
      choose<I + 1>(value, index);
    }
  }
}

template <class T>
void Reader::one(T& value) {
  if constexpr (std::is_same_v<T, std::string> || IsVector<T>::value) {
    std::size_t size = 0;
    raw(&size, sizeof size);
    value.resize(size);
    if constexpr (std::is_trivially_copyable_v<typename T::value_type>) {
      raw(value.data(), size * sizeof(typename T::value_type));
    } else {
      for (auto& entry : value) one(entry);
    }
  } else if constexpr (IsVariant<T>::value) {
    std::size_t index = 0;
    raw(&index, sizeof index);
    choose(value, index);
    std::visit([&](auto& held) { one(held); }, value);
  } else if constexpr (IsOptional<T>::value) {
    bool given = false;
    one(given);
    if (given) visit(*this, value.emplace());
  } else if constexpr (std::is_empty_v<T>) {
    // its one byte has no meaning either
  } else if constexpr (std::is_trivially_copyable_v<T>) {  // numbers, and structs of nothing but doubles
    raw(&value, sizeof value);
  } else {
    visit(*this, value);
  }
}

}  // namespace

std::vector<char> pack(const RichardsProblem& problem) {
  Writer writer;
  writer(problem);
  return std::move(writer.bytes);
}

RichardsProblem unpack(const std::vector<char>& message) {
  RichardsProblem problem;
  Reader reader(message);
  reader(problem);
  if (!reader.done()) throw std::logic_error("a message between ranks is too long");
  return problem;
}

}  // namespace wetfront::fem_reference
