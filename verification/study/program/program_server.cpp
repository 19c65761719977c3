#include "verification/study/program/program_server.hpp"

#include <httplib.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <stdexcept>

#include "reports/base/process.hpp"

namespace talus::verification::problems {
namespace {

constexpr const char* server_output = "server.txt";

/// The answer to what `request` sends, for which a busy machine has a minute.
template <class Request>
ServerAnswer answer_of(int port, Request&& request) {
  httplib::Client client{"127.0.0.1", port};
  client.set_read_timeout(std::chrono::minutes{1});
  const httplib::Result result = request(client);
  if (!result) return {};
  return {result->status, records::Json::parse(result->body)};
}

}  // namespace

ProgramServer::ProgramServer(const TemporaryFolder& folder, const std::string& sweep)
    : folder_{&folder}, running_{[this, sweep] {
        // The shell writes what the server prints to a file, which can be read while the server runs.
        const std::string script = std::string{"exec \"$0\" \"$1\" --port 0 > "} + server_output;
        try {
          (void)reports::run({.program = "/bin/sh",
                              .arguments = {"-c", script, TALUS_SERVE, sweep},
                              .folder = folder_->path(),
                              .environment = {}},
                             [this] { return ends_ ? SIGTERM : 0; });
        } catch (const std::exception&) {
          // port() then finds that the server does not listen.
        }
      }} {}

ProgramServer::~ProgramServer() {
  ends_ = true;
  running_.join();
}

int ProgramServer::port() {
  const std::string start = "listening on http://127.0.0.1:";
  for (int i = 0; i < 3000 && port_ == 0; ++i) {
    const std::string line =
        std::filesystem::exists(folder_->path() / server_output) ? folder_->read(server_output) : "";
    if (line.starts_with(start) && line.ends_with('\n')) {
      port_ = std::stoi(line.substr(start.size()));
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
  }
  if (port_ == 0) throw std::runtime_error{"talus_serve does not listen"};
  return port_;
}

ServerAnswer ProgramServer::get(const std::string& path) {
  return answer_of(port(), [&](httplib::Client& client) { return client.Get(path); });
}

ServerAnswer ProgramServer::post(const std::string& path, const records::Json& body) {
  return answer_of(port(), [&](httplib::Client& client) { return client.Post(path, body.dump(), "application/json"); });
}

}  // namespace talus::verification::problems
