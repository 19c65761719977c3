#pragma once

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/io/file/toml_document.hpp"
#include "tests/temporary_folder.hpp"

// Programs as started by a user, for end-to-end tests.

namespace fs = std::filesystem;

struct Ended {
  int code{};
  std::string out;
  std::string err;
};

/// Output files of a program: appended to, and possibly the same file.
struct Streams {
  fs::path out{"/dev/null"};
  fs::path err{"/dev/null"};
};

/// A started program. Killed if the test does not wait for its end.
class StartedProgram {
 public:
  /// `environment` is added to that of the test, or replaces entries of it. Errors: boost::process::process_error if it
  /// cannot be started, std::system_error if a file cannot be opened.
  StartedProgram(const std::string& program, const std::vector<std::string>& arguments, const Streams& streams = {},
                 const std::map<std::string, std::string>& environment = {});
  ~StartedProgram();
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;

  void send(int signal) const;
  bool is_running();
  int wait();       ///< exit status as given by waitpid
  int exit_code();  ///< waits; the test fails if a signal ended it

 private:
  struct Child;
  std::unique_ptr<Child> child_;
};

/// Runs a program with its output in files; `stdout_to` replaces stdout's file, `path` replaces PATH.
Ended ran(const std::string& program, const std::vector<std::string>& arguments, const std::string& stdout_to = "",
          const char* path = nullptr);

inline Ended talus_ran(const std::vector<std::string>& arguments, const std::string& stdout_to = "") {
  return ran(TALUS_EXECUTABLE, arguments, stdout_to);
}

inline std::string scene(const char* name) { return (fs::path{TALUS_CASES} / name).string(); }

inline bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// The text with `by` in place of the first `what`, which it must contain.
inline std::string replaced(std::string text, std::string_view what, std::string_view by) {
  const std::size_t offset = text.find(what);
  BOOST_REQUIRE(offset != std::string::npos);
  return text.replace(offset, what.size(), by);
}

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
