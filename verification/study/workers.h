#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// A program to run, and the file that takes what it says.
struct Work {
  std::vector<std::string> command;
  std::filesystem::path log;
};

/// Runs all of them, `jobs` at a time; `done` is called with the number and the exit status (as waitpid gives it) of
/// each as it ends. They end with this process, however it ends. Throws std::runtime_error where none can be started.
void run_side_by_side(const std::vector<Work>& work, int jobs, const std::function<void(std::size_t, int)>& done);

/// The processors that this process may use.
int processors();

/// The program that is running.
std::filesystem::path this_program();

}  // namespace wetfront::verification
