#include "solver/app/capacity/capacity_study.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(capacity_study_tests)

using namespace talus;
using namespace talus::app;

BOOST_AUTO_TEST_CASE(ends_of_rocks_are_the_verdicts_and_failed) {
  BOOST_TEST(name_of(RockEnd::stopped) == name_of(scenes::Verdict::stopped));
  BOOST_TEST(name_of(RockEnd::broke_through) == name_of(scenes::Verdict::broke_through));
  BOOST_TEST(name_of(RockEnd::failed) == "failed");
}

// Of results that were changed, or that another version wrote. It would count as a failed run.
BOOST_AUTO_TEST_CASE(a_verdict_that_is_not_known_is_refused) {
  const Folder folder;
  const std::string question = folder
                                   .file("q.toml", "base = \"" + scene("capacity/fence.toml") +
                                                       "\"\nmass = [\"600 lb\", \"2400 lb\"]\nspeed = [\"20 ft/s\", "
                                                       "\"100 ft/s\"]\n[map]\ncells = 1\nfirst_cells = 1\nruns = 4\n"
                                                       "few_runs = 1\naudit = 0\n[limits]\nevaluations = 1\n")
                                   .string();
  const std::vector<std::string> command{"capacity", question, "--out", (folder.path / "out").string(), "--no-plots"};
  BOOST_TEST(talus_ran(command).code == 3);  // every run reaches its limit
  const fs::path results = fs::directory_iterator { folder.path / "out" / "results" } -> path();
  const std::string ended = replaced(replaced(read_text(results), "\"end\":\"limited\"", "\"end\":\"finished\""),
                                     "\"values\":[]", "\"values\":[0,0,0,0,0,0]");
  folder.file("out/results/" + results.filename().string(), replaced(ended, "\"undecided\"", "\"caught\""));
  const Ended again = talus_ran(command);
  BOOST_TEST(again.code == 2);
  BOOST_TEST(holds(again.err, "/out: verdict of run "));
  BOOST_TEST(holds(again.err, " 'caught' is not known; nearest: "));
}

BOOST_AUTO_TEST_SUITE_END()
