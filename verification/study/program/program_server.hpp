#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "verification/record/json_node.hpp"
#include "verification/study/program/program_run.hpp"

/// The built program `talus_serve`, used as by a client of UM-Bridge.
namespace talus::verification::problems {

/// Answer of a server; the status is 0 without one.
struct ServerAnswer {
  int status{};
  records::Json body{};
};

/// A server of a sweep in a folder, until the destructor ends it.
class ProgramServer {
 public:
  /// Starts it at a free port. The folder must exist for as long.
  ProgramServer(const TemporaryFolder& folder, const std::string& sweep);
  ProgramServer(const ProgramServer&) = delete;
  ProgramServer& operator=(const ProgramServer&) = delete;
  ~ProgramServer();

  /// Requests by GET, and by POST with a body. Both throw std::runtime_error if the server does not listen within a
  /// minute of the first request.
  [[nodiscard]] ServerAnswer get(const std::string& path);
  [[nodiscard]] ServerAnswer post(const std::string& path, const records::Json& body);

 private:
  int port();

  const TemporaryFolder* folder_;
  int port_{};
  std::atomic<bool> ends_{false};
  std::thread running_;
};

}  // namespace talus::verification::problems
