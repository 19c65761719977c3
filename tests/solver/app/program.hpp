#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "solver/io/file/toml_document.hpp"
#include "tests/solver/io/folder.hpp"

// Programs as a user starts them, for tests from end to end.

namespace fs = std::filesystem;

struct Ended {
  int code{};
  std::string out;
  std::string err;
};

/// Runs a program with its output in files; `stdout_to` in place of one of them.
inline Ended ran(const std::string& program, std::vector<std::string> arguments, const std::string& stdout_to = "",
                 const char* path = nullptr) {
  const Folder folder;
  const std::string out = stdout_to.empty() ? (folder.path / "out").string() : stdout_to;
  const std::string err = (folder.path / "err").string();
  const pid_t child = ::fork();
  BOOST_REQUIRE(child >= 0);
  if (child == 0) {
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    if (path != nullptr) ::setenv("PATH", path, 1);
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (std::string& argument : arguments)
      words.push_back(argument.data());
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    ::_exit(127);
  }
  int status = 0;
  BOOST_REQUIRE(::waitpid(child, &status, 0) == child);
  BOOST_REQUIRE(WIFEXITED(status));
  return {WEXITSTATUS(status), stdout_to.empty() ? talus::read_text(out) : "", talus::read_text(err)};
}

inline Ended talus_ran(std::vector<std::string> arguments, const std::string& stdout_to = "") {
  return ran(TALUS_EXECUTABLE, std::move(arguments), stdout_to);
}

inline std::string scene(const char* name) { return (fs::path{TALUS_CASES} / name).string(); }

inline bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// All files below a folder, by name.
inline std::map<std::string, std::string> files(const fs::path& folder) {
  std::map<std::string, std::string> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder}) {
    if (entry.is_regular_file()) found[fs::relative(entry.path(), folder).string()] = talus::read_text(entry.path());
  }
  return found;
}

inline void same_files(const fs::path& one, const fs::path& other) {
  const auto left = files(one), right = files(other);
  BOOST_TEST(left.size() == right.size());
  for (const auto& [name, text] : left)
    BOOST_TEST((right.contains(name) && right.at(name) == text), name);
}
