#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace wetfront::mpm {

/// Threads that share loops. They are kept between loops and wait for the next one: a moment spinning, then asleep.
class Team {
 public:
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;

  /// body(k) for every k < count, in any order and by any thread; returns when all are done. `body` must not throw.
  template <class Body>
  void run(std::size_t count, const Body& body) {
    if (workers_.empty() || count < 2) {
      for (std::size_t k = 0; k < count; ++k) body(k);
      return;
    }
    share({[](const void* b, std::size_t k) { (*static_cast<const Body*>(b))(k); }, &body, count});
  }

 private:
  struct Loop {
    void (*call)(const void* body, std::size_t k) = nullptr;
    const void* body = nullptr;
    std::size_t count = 0;
  };
  void share(const Loop& loop);
  void work();
  void wait_for_loops();

  Loop loop_;
  std::atomic<std::size_t> next_{0};
  std::atomic<int> busy_{0};
  std::atomic<unsigned> loops_{0};
  std::atomic<bool> over_{false};
  std::vector<std::thread> workers_;
};

}  // namespace wetfront::mpm
