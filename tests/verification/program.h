#pragma once

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

/// The program as a user calls it.
namespace wetfront::verification::test {

struct Output {
  int code;
  std::string text;  ///< stdout and stderr
};

/// A fresh folder for each test, in which the program is called.
class Program : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::path(testing::TempDir()) / ("wetfront_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  Output wetfront(const std::string& arguments) const {
    const std::string command = "cd " + folder.string() + " && " WETFRONT_PROGRAM " " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer;
    while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), size);
    return {WEXITSTATUS(pclose(pipe)), text};
  }

  std::filesystem::path folder;
};

}  // namespace wetfront::verification::test
