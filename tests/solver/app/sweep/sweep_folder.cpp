#include "solver/app/sweep/sweep_folder.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(sweep_folder_tests)

using namespace talus;
using namespace talus::app;

// Accepted by the JSON library, but copying or printing such a value would recurse for each level.
BOOST_AUTO_TEST_CASE(json_that_is_nested_too_deeply) {
  const Folder folder;
  SweepFolder sweep;
  sweep.folder = folder.path;
  sweep.outputs = {"ball.y.end"};
  write_sweep_folder(sweep);
  const std::string deep = "{\"id\": " + std::string(100'000, '[') + std::string(100'000, ']') + "}\n";
  const SweepResult result{"12", SweepEnd::finished, "", 0.1, 7, "", {1.0}};
  const auto refused = [](const std::string& start) {
    return [start](const InputError& error) {
      const std::string what = error.what();
      return what.find(start + "found lists and objects nested deeper than 64 levels") != std::string::npos;
    };
  };
  folder.file("results/1.jsonl", result_line(result, sweep.key()) + "\n" + deep);
  BOOST_CHECK_EXCEPTION(static_cast<void>(all_results(sweep)), InputError, refused("1.jsonl: line 2: "));
  folder.file("manifest.jsonl", deep);
  BOOST_CHECK_EXCEPTION(static_cast<void>(read_sweep_folder(sweep.folder)), InputError,
                        refused("manifest.jsonl: line 1: "));
  folder.file("sweep.json", "\n" + deep);
  BOOST_CHECK_EXCEPTION(static_cast<void>(read_sweep_folder(sweep.folder)), InputError,
                        refused("sweep.json: line 2: "));
}

// Readers of the values count on one for each output of a run that reached its end.
BOOST_AUTO_TEST_CASE(a_run_has_a_value_for_each_output_or_none) {
  const Folder folder;
  SweepFolder sweep;
  sweep.folder = folder.path;
  sweep.outputs = {"ball.y.end", "ball.x.end"};
  write_sweep_folder(sweep);
  for (const auto& [end, count] : {std::pair{SweepEnd::finished, 0},
                                   {SweepEnd::finished, 1},
                                   {SweepEnd::unusable, 0},
                                   {SweepEnd::diverged, 2},
                                   {SweepEnd::limited, 1},
                                   {SweepEnd::refused, 2}}) {
    const SweepResult result{"12", end, "", 0.1, 7, "", std::vector<double>(static_cast<std::size_t>(count))};
    folder.file("results/1.jsonl", result_line(result, sweep.key()) + "\n");
    BOOST_CHECK_EXCEPTION(static_cast<void>(all_results(sweep)), InputError, [&](const InputError& error) {
      return std::string{error.what()}.find("1.jsonl:1: found ") != std::string::npos;
    });
  }
}

BOOST_AUTO_TEST_CASE(members_of_the_wrong_kind_are_named) {
  const Folder folder;
  SweepFolder sweep;
  sweep.folder = folder.path;
  sweep.outputs = {"ball.y.end"};
  write_sweep_folder(sweep);
  const auto message = [](const auto& read) {
    try {
      static_cast<void>(read());
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"no error"};
  };
  folder.file("results/1.jsonl", "{\"sweep\": \"" + sweep.key() + "\", \"id\": \"1\", \"end\": 3}\n");
  BOOST_TEST(message([&] { return all_results(sweep); })
                 .ends_with("1.jsonl:1: not a result; remove this line and run the sweep again: result.end: must be a "
                            "text, found 3"));
  folder.file("manifest.jsonl", "{\"id\": 3}\n");
  BOOST_TEST(message([&] { return read_sweep_folder(folder.path); })
                 .ends_with("manifest.jsonl:1: not a run; remove this line and plan the sweep again: run.id: must be a "
                            "text, found 3"));
  folder.file("sweep.json", "{\"schema\": 1, \"title\": \"t\", \"outputs\": [1]}");
  BOOST_TEST(
      message([&] { return read_sweep_folder(folder.path); })
          .ends_with("sweep.json: not the description of a sweep; plan the sweep again: sweep.outputs[0]: must be "
                     "a text, found 1"));
}

BOOST_AUTO_TEST_SUITE_END()
