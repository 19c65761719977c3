/// talus_guided_reader: a libFuzzer target (LLVM), which searches for inputs that lead a reader along new code paths.
/// The environment selects the reader: TALUS_READER=NAME, as listed by `talus_mutate_inputs --list`.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/fuzz/readers.hpp"

namespace {

namespace fs = std::filesystem;
using talus::fuzz::Reader;

constexpr int wrong_usage = 2, failed = 4;

/// The reader and a folder for its inputs, in memory (/dev/shm) where available; removed when the process ends.
class Target {
 public:
  Target() : folder_{root() / fmt::format("talus_guided_{}", ::getpid())} {
    fs::create_directories(folder_ / "input");
    fs::create_directories(folder_ / "runs");
    const char* const name = std::getenv("TALUS_READER");
    std::string known;
    for (Reader& reader : talus::fuzz::all_readers(folder_ / "runs")) {
      known += (known.empty() ? "" : ", ") + reader.name;
      if (name != nullptr && reader.name == name) reader_ = std::move(reader);
    }
    if (reader_) return;
    fmt::print(stderr, "talus_guided_reader: TALUS_READER: found '{}'; it must be one of {}\n",
               name == nullptr ? "" : name, known);
    remove();
    std::_Exit(wrong_usage);
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  ~Target() { remove(); }

  /// Describes what is wrong with how the reader ended; empty if nothing is.
  std::string case_error(std::string input) const {
    if (reader_->seal) reader_->seal(input);
    return talus::fuzz::read(*reader_, talus::fuzz::put(*reader_, input, folder_ / "input")).flaw;
  }

 private:
  static fs::path root() { return fs::is_directory("/dev/shm") ? fs::path{"/dev/shm"} : fs::temp_directory_path(); }
  void remove() const {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  fs::path folder_;
  std::optional<Reader> reader_;
};

const Target& target() {
  static const Target one = [] {
    try {
      return Target{};
    } catch (const std::exception& error) {
      fmt::print(stderr, "talus_guided_reader: {}\n", error.what());
      std::_Exit(failed);
    }
  }();
  return one;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string flaw = target().case_error({reinterpret_cast<const char*>(data), size});
  if (flaw.empty()) return 0;
  fmt::print(stderr, "talus_guided_reader: {}\n", flaw);
  std::abort();
}
