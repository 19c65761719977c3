#include "reports/base/process.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "reports/base/error.hpp"
#include "solver/threads/parallel_for.hpp"

BOOST_AUTO_TEST_SUITE(process_tests)

using namespace talus::reports;

BOOST_AUTO_TEST_CASE(output_status_and_messages_come_back) {
  const Finished finished = run({"sh", {"-c", "echo $WORD; echo bad >&2; pwd; exit 3"}, "/", {{"WORD", "a b"}}});
  BOOST_TEST(finished.status == 3);
  BOOST_TEST(finished.output == "a b\n/\n");
  BOOST_TEST(finished.messages == "bad\n");
}

BOOST_AUTO_TEST_CASE(no_shell_reads_the_arguments) {
  BOOST_TEST(run({"printf", {"%s", "$HOME; *"}, {}, {}}).output == "$HOME; *");
}

BOOST_AUTO_TEST_CASE(much_output_does_not_block) {
  BOOST_TEST(run({"sh", {"-c", "head -c 300000 /dev/zero >&2; head -c 300000 /dev/zero"}, {}, {}}).output.size() ==
             300000U);
}

BOOST_AUTO_TEST_CASE(signals_differ_from_exit_codes) {
  BOOST_TEST(run({"sh", {"-c", "echo begun; kill -9 $$"}, {}, {}}).status == 128 + 9);
  BOOST_TEST(run({"sh", {"-c", "kill -15 $$"}, {}, {}}).status == 128 + 15);
  BOOST_TEST(run({"sh", {"-c", "exit 9"}, {}, {}}).status == 9);
}

BOOST_AUTO_TEST_CASE(a_watch_sends_signals) {
  int calls = 0;
  const Finished finished =
      run({"sh", {"-c", "echo begun; exec sleep 60"}, {}, {}}, [&] { return ++calls > 2 ? 15 : 0; });
  BOOST_TEST(finished.status == 128 + 15);
  BOOST_TEST(finished.output == "begun\n");
}

BOOST_AUTO_TEST_CASE(standard_input_is_empty) { BOOST_TEST(run({"wc", {"-c"}, {}, {}}).output == "0\n"); }

// A child that inherited the pipes of another would keep run() waiting for its own end.
BOOST_AUTO_TEST_CASE(children_of_other_threads_hold_no_pipe) {
  const Command list{"ls", {"/proc/self/fd"}, {}, {}};
  const std::string alone = run(list).output;
  BOOST_TEST_REQUIRE(alone.rfind("0\n1\n", 0) == 0U);
  std::vector<std::string> seen(200);
  talus::parallel_for(seen.size(), 4, [&](std::size_t i) { seen[i] = run(list).output; });
  for (const std::string& descriptors : seen)
    BOOST_TEST(descriptors == alone);
}

BOOST_AUTO_TEST_CASE(a_missing_or_failing_tool_is_named) {
  const auto message_of = [](const Command& command) -> std::string {
    try {
      run_or_throw(command, "page 3");
    } catch (const OutputError& error) {
      return error.what();
    }
    return "nothing";
  };
  const std::string missing =
      ": cannot be started: No such file or directory (is it installed? scripts/setup installs "
      "what reports and pictures need)";
  BOOST_TEST(message_of({"no-such-tool", {}, {}, {}}) == "no-such-tool" + missing);
  BOOST_TEST(message_of({"/no/such-tool", {}, {}, {}}) == "/no/such-tool" + missing);
  BOOST_TEST(message_of({"/etc/passwd", {}, {}, {}}) == "/etc/passwd: cannot be started: Permission denied");
  BOOST_TEST(message_of({"true", {}, "/no/folder", {}}) ==
             "true: cannot be started in /no/folder: No such file or directory");
  BOOST_TEST(message_of({"true", {}, "/etc/passwd", {}}) == "true: cannot be started in /etc/passwd: Not a directory");
  BOOST_TEST(message_of({"sh", {"-c", "echo why >&2; exit 1"}, {}, {}}) == "sh failed on page 3 (exit status 1):\nwhy");
  BOOST_TEST(message_of({"sh", {"-c", "kill -9 $$"}, {}, {}}) == "sh failed on page 3 (exit status 137):\n");
  BOOST_TEST(message_of({"true", {}, {}, {}}) == "nothing");
}

BOOST_AUTO_TEST_SUITE_END()
