#include "verification/suites/run_suite.h"

#include "reports/junit.h"
#include "reports/write.h"
#include "verification/compare/verdict.h"

#include <fmt/format.h>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <new>
#include <stdexcept>

namespace wetfront::verification {
namespace {

/// Numbers handed out across processes.
class SharedCounter {
 public:
  SharedCounter() {
    void* page = mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) throw std::runtime_error("no memory to share between processes");
    count_ = new (page) std::atomic<int>(0);
  }
  ~SharedCounter() { munmap(count_, sizeof(std::atomic<int>)); }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  std::size_t next() { return static_cast<std::size_t>((*count_)++); }

 private:
  std::atomic<int>* count_;
};

std::vector<Case> chosen(const std::vector<Case>& suite, const SuiteOptions& options) {
  std::vector<Case> cases;
  for (const Case& test : suite)
    if ((options.heavy || test.effort != Effort::heavy) && test.name.find(options.only) != std::string::npos)
      cases.push_back(test);
  if (cases.empty())
    throw std::invalid_argument("no case's name contains '" + options.only + "'" +
                                (options.heavy ? "" : " (heavy cases run with --heavy)") +
                                ". There are cases such as " + suite.front().name);
  return cases;
}

void print_line(const reports::Record& record) {
  std::string text =
      fmt::format("{:<12} {:<34} {:7.2f} CPU-s\n", word(record.verdict), record.case_name, record.cpu_seconds);
  for (const auto& finding : record.findings)
    if (finding.verdict == reports::Verdict::fail)
      text += fmt::format("             {}: {:.3g}, tolerance {:.3g}. {}\n", finding.description, finding.error,
                          finding.tolerance, finding.explanation);
  std::fwrite(text.data(), 1, text.size(), stdout);  // in one piece: another process may print too
  std::fflush(stdout);
}

/// Takes cases until there are none left. An exit code.
int work(const std::vector<Case>& cases, const std::vector<std::size_t>& order, const SuiteOptions& options,
         SharedCounter& counter) {
  try {
    for (std::size_t n = counter.next(); n < order.size(); n = counter.next()) {
      const reports::Record record = run_case(cases[order[n]]);
      reports::write_result(record, options.out / record.case_name);
      print_line(record);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "wetfront: {}\n", error.what());
    return 1;
  }
  return 0;
}

/// Runs `work` in several processes: forked before any library has started threads, so that each has a whole copy.
void work_side_by_side(const std::vector<Case>& cases, const std::vector<std::size_t>& order,
                       const SuiteOptions& options) {
  SharedCounter counter;
  std::fflush(nullptr);
  std::vector<pid_t> workers;
  for (int i = 0; i < options.processes; ++i) {
    const pid_t worker = fork();
    if (worker < 0) throw std::runtime_error("cannot start another process");
    if (worker == 0) {
      const int code = work(cases, order, options, counter);
      std::fflush(nullptr);
      _exit(code);
    }
    workers.push_back(worker);
  }
  bool sound = true;
  for (const pid_t worker : workers) {
    int status = 0;
    waitpid(worker, &status, 0);
    sound = sound && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  if (!sound) throw std::runtime_error("a process of the suite ended before its cases did");
}

}  // namespace

bool run_suite(const std::vector<Case>& suite, const SuiteOptions& options, const std::string& title) {
  const std::vector<Case> cases = chosen(suite, options);
  for (const Case& test : cases) reports::make_writable(options.out / test.name);
  std::vector<std::size_t> order(cases.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  // What takes longest first, so that no process waits for another at the end.
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cases[a].effort > cases[b].effort; });
  work_side_by_side(cases, order, options);
  std::vector<std::filesystem::path> folders;
  int failed = 0;
  for (const Case& test : cases) {
    folders.push_back(options.out / test.name);
    failed += reports::read_result(folders.back() / "result.json").verdict == reports::Verdict::fail;
  }
  reports::write_index(folders, options.out / "index.html", title);
  reports::write_junit({{"", folders}}, options.out / "junit.xml");
  fmt::print("{} cases, {} failed; index of all cases -> {}\n", cases.size(), failed,
             (options.out / "index.html").string());
  return failed == 0;
}

}  // namespace wetfront::verification
