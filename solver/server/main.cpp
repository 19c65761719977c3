/// talus_serve: the runs of a sweep as a model that clients of UM-Bridge evaluate. A program beside `talus`, which
/// starts in half of the time without the network's libraries.

#include <fmt/format.h>
#include <httplib.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <semaphore>
#include <string>
#include <thread>

#include "solver/app/interruption.hpp"
#include "solver/base/error.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/server/um_bridge.hpp"
#include "solver/version/version.hpp"
#include "verification/record/utf8.hpp"

namespace talus::server {
namespace {

struct ServeOptions {
  std::string file;
  std::string host{"127.0.0.1"};
  int port{4242};
  unsigned threads{std::max(1U, std::thread::hardware_concurrency())};
};

/// One of the runs at a time, from its construction to its end.
class Turn {
 public:
  explicit Turn(std::counting_semaphore<>& turns) : turns_{&turns} { turns.acquire(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  ~Turn() { turns_->release(); }

 private:
  std::counting_semaphore<>* turns_;
};

int serve(const ServeOptions& options) {
  const app::SweepFunction function{options.file};
  const UmBridge bridge{function};
  app::Interruption interruption;
  const auto interrupted = [&] { return interruption.signal() != 0; };
  std::counting_semaphore<> turns{static_cast<std::ptrdiff_t>(options.threads)};
  httplib::Server server;
  // Not SO_REUSEPORT, the library's choice: a second server would share the port without a word.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  // Connections that are kept occupy a thread each; runs take turns.
  const std::size_t connections = 8 + 4 * std::size_t{options.threads};
  server.new_task_queue = [connections] { return new httplib::ThreadPool{connections}; };
  constexpr std::size_t largest_request = 1 << 20;
  server.set_payload_max_length(largest_request);
  const auto send = [](httplib::Response& response, const Answer& answer) {
    response.status = answer.status;
    response.set_content(answer.body, "application/json");
  };
  server.Get("/Info", [&](const httplib::Request&, httplib::Response& response) { send(response, bridge.info()); });
  server.Get("/Quantities",
             [&](const httplib::Request&, httplib::Response& response) { send(response, bridge.quantities()); });
  server.Post("/ModelInfo", [&](const httplib::Request& request, httplib::Response& response) {
    send(response, bridge.model_info(request.body));
  });
  server.Post("/InputSizes", [&](const httplib::Request& request, httplib::Response& response) {
    send(response, bridge.input_sizes(request.body));
  });
  server.Post("/OutputSizes", [&](const httplib::Request& request, httplib::Response& response) {
    send(response, bridge.output_sizes(request.body));
  });
  server.Post("/Evaluate", [&](const httplib::Request& request, httplib::Response& response) {
    const Turn turn{turns};
    send(response, bridge.evaluate(request.body, interrupted));
  });
  for (const char* const feature : {"Gradient", "ApplyJacobian", "ApplyHessian"}) {
    server.Post(fmt::format("/{}", feature),
                [&, feature](const httplib::Request& request, httplib::Response& response) {
                  send(response, bridge.unsupported(feature, request.body));
                });
  }
  const int port = options.port == 0                                 ? server.bind_to_any_port(options.host)
                   : server.bind_to_port(options.host, options.port) ? options.port
                                                                     : -1;
  if (port < 0) throw IoError{"the address cannot be bound; give --host one of this machine and --port a free one"};
  fmt::print("listening on http://{}:{}, model '{}': {} inputs, {} outputs\n", options.host, port, UmBridge::model,
             function.inputs().size(), function.outputs().size());
  std::fflush(stdout);
  std::atomic<bool> has_ended{false};
  std::thread watcher{[&] {
    constexpr auto interval = std::chrono::milliseconds{20};
    // Until the server has started, it cannot be stopped.
    for (; !has_ended; std::this_thread::sleep_for(interval))
      if (interrupted()) server.stop();
  }};
  const bool is_served = server.listen_after_bind();
  has_ended = true;
  watcher.join();
  if (interrupted()) return 128 + interruption.signal();
  if (!is_served) throw IoError{"connections cannot be accepted any more"};
  return app::ok;
}

void describe(CLI::App& program, ServeOptions& options) {
  program.description("Talus: the runs of a sweep as a model that clients of UM-Bridge evaluate.");
  program.add_option("SWEEP", options.file, "the sweep (.toml): base, outputs, and axes, whose fields are the inputs")
      ->required();
  program.add_option("--host", options.host,
                     "address to listen on; default 127.0.0.1, for this machine alone. There is no authentication: "
                     "give others only in a network that you trust");
  program.add_option("--port", options.port, "default 4242; 0: one that is free")->check(whole_between(0, 65535));
  program.add_option("--threads", options.threads, "number of runs at a time; default: all threads")
      ->check(whole_between(1, 1024));
  program.set_version_flag("--version", version_text("talus_serve"));
  program.footer(
      "Example:\n"
      "  talus_serve cases/sweeps/rock.toml --port 4242\n"
      "The model is called forward. The address is printed once it is ready; SIGINT and SIGTERM end it.");
  refuse_empty_values(program);
}

int fail(app::ExitCode code, const char* message) {
  fmt::print(stderr, "talus_serve: {}\n", records::shown_lines(message));
  return code;
}

int run(int count, const char* const* arguments) {
  CLI::App program{"", "talus_serve"};
  ServeOptions options;
  describe(program, options);
  try {
    program.parse(count, arguments);
  } catch (const CLI::ParseError& wrong) {
    return exit_of_parse(program, wrong);
  }
  try {
    return serve(options);
  } catch (const InputError& wrong) {
    return fail(app::bad_input, wrong.what());
  } catch (const std::exception& wrong) {
    return fail(app::io_failed, wrong.what());
  }
}

}  // namespace
}  // namespace talus::server

int main(int count, char** arguments) { return talus::server::run(count, arguments); }
