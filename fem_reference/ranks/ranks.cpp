#include "fem_reference/ranks/ranks.h"

#include <mpi.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace wetfront::fem_reference {

struct Ranks::Links {
  struct Neighbour {
    int rank;
    std::vector<int> send;     ///< own unknowns that it has as ghosts
    std::vector<int> receive;  ///< ghosts that it owns
    std::vector<double> out, in;
  };
  int rank = 0, ranks = 1, own = 0, ghosts = 0;
  long total = 0;
  std::vector<Neighbour> neighbours;
  std::vector<int> global;
  std::vector<MPI_Request> requests;

  void find_neighbours(const std::vector<long long>& id);
};

namespace {

template <class T>
std::vector<T> from_all(T value, MPI_Datatype type, int ranks) {
  std::vector<T> all(ranks);
  MPI_Allgather(&value, 1, type, all.data(), 1, type, MPI_COMM_WORLD);
  return all;
}

std::vector<int> offsets(const std::vector<int>& counts) {
  std::vector<int> offset(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), offset.begin() + 1);
  return offset;
}

}  // namespace

// Who holds which ghosts is known to the holder: he asks the owner, whose ids are a range.
void Ranks::Links::find_neighbours(const std::vector<long long>& id) {
  const long long last = own > 0 ? *std::max_element(id.begin(), id.begin() + own) : -1;
  std::vector<long long> end = from_all(last + 1, MPI_LONG_LONG, ranks);
  for (int r = 1; r < ranks; ++r) end[r] = std::max(end[r], end[r - 1]);  // a rank may own nothing
  std::vector<std::vector<int>> wanted(ranks);
  for (int g = own; g < own + ghosts; ++g) {
    wanted[std::upper_bound(end.begin(), end.end(), id[g]) - end.begin()].push_back(g);
  }
  std::vector<int> asks(ranks), asked(ranks);
  std::vector<long long> names;
  for (int r = 0; r < ranks; ++r) {
    asks[r] = static_cast<int>(wanted[r].size());
    for (int g : wanted[r]) names.push_back(id[g]);
  }
  MPI_Alltoall(asks.data(), 1, MPI_INT, asked.data(), 1, MPI_INT, MPI_COMM_WORLD);
  const std::vector<int> from = offsets(asks), to = offsets(asked);
  std::vector<long long> answer(to.back());
  MPI_Alltoallv(names.data(), asks.data(), from.data(), MPI_LONG_LONG, answer.data(), asked.data(), to.data(),
                MPI_LONG_LONG, MPI_COMM_WORLD);
  std::unordered_map<long long, int> mine;
  for (int i = 0; i < own; ++i) mine[id[i]] = i;
  for (int r = 0; r < ranks; ++r) {
    if (asks[r] == 0 && asked[r] == 0) continue;
    Neighbour neighbour{r, {}, wanted[r], {}, {}};
    for (int k = to[r]; k < to[r + 1]; ++k) neighbour.send.push_back(mine.at(answer[k]));
    neighbour.out.resize(neighbour.send.size());
    neighbour.in.resize(neighbour.receive.size());
    neighbours.push_back(std::move(neighbour));
  }
}

Ranks::Ranks(const std::vector<long long>& id, int own) : links_(std::make_shared<Links>()) {
  Links& links = *links_;
  MPI_Comm_rank(MPI_COMM_WORLD, &links.rank);
  MPI_Comm_size(MPI_COMM_WORLD, &links.ranks);
  links.own = own;
  links.ghosts = static_cast<int>(id.size()) - own;
  links.find_neighbours(id);
  const std::vector<int> first = offsets(from_all(own, MPI_INT, links.ranks));
  links.total = first.back();
  std::vector<double> number(id.size());
  for (int i = 0; i < own; ++i) number[i] = first[links.rank] + i;
  refresh(number);
  links.global.assign(number.begin(), number.end());
}

int Ranks::count() const {
  return links_ ? links_->ranks : 1;
}

int Ranks::rank() const {
  return links_ ? links_->rank : 0;
}

int Ranks::ghosts() const {
  return links_ ? links_->ghosts : 0;
}

const std::vector<int>& Ranks::global() const {
  return links_->global;
}

long Ranks::total() const {
  return links_->total;
}

void Ranks::refresh(std::span<double> values) const {
  if (!links_) return;
  auto& requests = links_->requests;
  requests.clear();
  for (Links::Neighbour& n : links_->neighbours) {
    for (std::size_t k = 0; k < n.send.size(); ++k) n.out[k] = values[n.send[k]];
    MPI_Irecv(n.in.data(), static_cast<int>(n.in.size()), MPI_DOUBLE, n.rank, 0, MPI_COMM_WORLD,
              &requests.emplace_back());
    MPI_Isend(n.out.data(), static_cast<int>(n.out.size()), MPI_DOUBLE, n.rank, 0, MPI_COMM_WORLD,
              &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (const Links::Neighbour& n : links_->neighbours) {
    for (std::size_t k = 0; k < n.receive.size(); ++k) values[n.receive[k]] = n.in[k];
  }
}

std::vector<double> Ranks::with_ghosts(std::span<const double> own) const {
  std::vector<double> values(own.begin(), own.end());
  if (!links_) return values;
  values.resize(links_->own + links_->ghosts);
  refresh(values);
  return values;
}

bool Ranks::any(bool value) const {
  double flag = value ? 1 : 0;
  max(std::span(&flag, 1));
  return flag > 0;
}

void Ranks::max(std::span<double> values) const {
  if (!links_) return;
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
}

std::string Ranks::text_of_largest(double weight, std::string text) const {
  if (!links_) return text;
  struct {
    double weight;
    int rank;
  } best{weight, links_->rank};
  MPI_Allreduce(MPI_IN_PLACE, &best, 1, MPI_DOUBLE_INT, MPI_MAXLOC, MPI_COMM_WORLD);
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, best.rank, MPI_COMM_WORLD);
  text.resize(length);
  MPI_Bcast(text.data(), length, MPI_CHAR, best.rank, MPI_COMM_WORLD);
  return text;
}

double Ranks::sum(double value) const {
  sum(std::span(&value, 1));
  return value;
}

void Ranks::sum(std::span<double> values) const {
  if (!links_) return;
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

std::vector<double> Ranks::gather(std::span<const double> values) const {
  std::vector<double> all(values.begin(), values.end());
  if (!links_) return all;
  const std::vector<int> counts = from_all(static_cast<int>(values.size()), MPI_INT, links_->ranks);
  const std::vector<int> first = offsets(counts);
  all.resize(first.back());
  MPI_Allgatherv(values.data(), counts[links_->rank], MPI_DOUBLE, all.data(), counts.data(), first.data(), MPI_DOUBLE,
                 MPI_COMM_WORLD);
  return all;
}

}  // namespace wetfront::fem_reference
