#define BOOST_TEST_MODULE reports_process
#include "reports/process.hpp"

#include <boost/test/unit_test.hpp>

#include "reports/error.hpp"

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

BOOST_AUTO_TEST_CASE(a_missing_or_failing_tool_is_named) {
  const auto tells = [](const std::string& part) {
    return [part](const OutputError& wrong) { return std::string(wrong.what()).find(part) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(static_cast<void>(run({"no-such-tool", {}, {}, {}})), OutputError,
                        tells("no-such-tool: cannot be started"));
  BOOST_CHECK_EXCEPTION(run_or_throw({"sh", {"-c", "echo why >&2; exit 1"}, {}, {}}, "page 3"), OutputError,
                        tells("sh failed on page 3 (exit code 1):\nwhy"));
}
