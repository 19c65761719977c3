#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "solver/io/output/read_history.hpp"
#include "tests/solver/app/requested.hpp"
#include "tests/solver/app/sample_run.hpp"

BOOST_AUTO_TEST_SUITE(animate_tests)

// Animations and players by `talus animate`.

BOOST_AUTO_TEST_CASE(a_gif_has_a_picture_for_each_state) {
  const Folder folder;
  const Ended ended =
      talus_ran({"animate", sample().string(), "--gif", "--until", "20 ms", "--out", folder.path.string()});
  BOOST_TEST(ended.code == 0, ended.err);
  BOOST_TEST(ended.err.empty());
  const std::string gif = talus::read_text(folder.path / "animation.gif");
  BOOST_TEST(gif.rfind("GIF89a", 0) == 0U);
  // Each picture begins with a graphic control block: 0x21 0xF9 0x04. States at 0, 5, 10, 15 and 20 ms.
  int pictures = 0;
  for (std::size_t at = 0; (at = gif.find("\x21\xF9\x04", at)) != std::string::npos; ++at)
    ++pictures;
  BOOST_TEST(pictures == 5);
  BOOST_TEST(!fs::exists(folder.path / "animation.html"));
}

BOOST_AUTO_TEST_CASE(the_player_is_one_file_that_needs_no_other) {
  const Folder folder;
  const Ended ended = talus_ran({"animate", sample().string(), "--out", folder.path.string()});
  BOOST_TEST(ended.code == 0, ended.err);
  std::string page = talus::read_text(folder.path / "animation.html");
  for (const char* part : {"src=", "href=", "@import", "fetch(", "url("})
    BOOST_TEST(!holds(page, part), part);
  const std::string mark = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(mark) + mark.size();
  const auto data = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  BOOST_TEST(data.at("frames").size() == 12U);  // eleven, and the last state
  BOOST_TEST(data.at("bodies").size() == 16U);
  BOOST_TEST(data.at("charts").at(0).at("title") == "Energies");
  const talus::KeptHistory kept = talus::read_history(sample() / "history.csv");
  // Body 1 is the rock; positions have six digits.
  BOOST_TEST(data.at("frames").at(0).at("bodies").at(1).at(0).get<double>() == kept.find("rock.x")->values.front(),
             boost::test_tools::tolerance(1e-5));
  const Ended late = talus_ran({"animate", sample().string(), "--until", "1 us"});
  BOOST_TEST(late.code == 2);
  BOOST_TEST(
      holds(late.err, "--until: found \"1 us\"; the run has fewer than two states up to that time; give a later one"));
}

// A bounce in one of 1001 rows is the highest point of its curve, and the last row its end.
BOOST_AUTO_TEST_CASE(curves_of_the_player_keep_short_peaks) {
  const Folder folder;
  const std::string run = (folder.path / "run").string();
  BOOST_REQUIRE(talus_ran({"run", scene("fence/table_2.toml"), "--out", run}).code == 0);
  const talus::KeptHistory kept = talus::read_history(fs::path{run} / "history.csv");
  BOOST_TEST_REQUIRE(kept.find("time")->values.size() > 1000U);
  BOOST_REQUIRE(talus_ran({"animate", run}).code == 0);
  const std::string page = talus::read_text(fs::path{run} / "plots" / "animation.html");
  const std::string mark = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(mark) + mark.size();
  const auto data = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  std::size_t curves = 0;
  for (const auto& chart : data.at("charts")) {
    BOOST_TEST(chart.at("t").size() <= 1001U);
    BOOST_TEST(chart.at("t").back().get<double>() == kept.find("time")->values.back(),
               boost::test_tools::tolerance(1e-5));
    for (const auto& series : chart.at("series")) {
      const auto values = series.at("values").get<std::vector<double>>();
      const std::vector<double>& all = kept.find(series.at("name").get<std::string>())->values;
      BOOST_TEST(values.size() == chart.at("t").size());
      const double scale = std::max(std::abs(std::ranges::max(all)), std::abs(std::ranges::min(all)));
      BOOST_TEST(std::abs(std::ranges::max(values) - std::ranges::max(all)) < 1e-5 * scale, series.at("name"));
      BOOST_TEST(std::abs(std::ranges::min(values) - std::ranges::min(all)) < 1e-5 * scale, series.at("name"));
      BOOST_TEST(std::abs(values.back() - all.back()) < 1e-5 * scale, series.at("name"));
      ++curves;
    }
  }
  BOOST_TEST(curves > 4U);

  // The cursor shows the value of each state, not an extreme of a stretch of rows.
  const std::vector<double>& times = kept.find("time")->values;
  const auto& frames = data.at("frames");
  const auto& first = data.at("charts").at(0).at("series").at(0);
  const std::vector<double>& all = kept.find(first.at("name").get<std::string>())->values;
  BOOST_TEST(first.at("at").size() == frames.size());
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const double t = frames.at(n).at("t").get<double>();
    const auto row = std::ranges::min_element(times, {}, [t](double each) { return std::abs(each - t); });
    BOOST_TEST(first.at("at").at(n).get<double>() == all[static_cast<std::size_t>(row - times.begin())],
               boost::test_tools::tolerance(5.1e-6));
  }
}

// Six digits of a subnormal number, which std::stod does not read.
BOOST_AUTO_TEST_CASE(the_player_accepts_numbers_of_any_size) {
  const Folder folder;
  const std::string run = (folder.path / "run").string();
  BOOST_REQUIRE(talus_ran({"run", scene("pendulum.toml"), "--end", "0.1 s", "--frames", "2", "--out", run}).code == 0);
  const std::string file = run + "/history.csv";
  std::istringstream lines{talus::read_text(file)};
  std::string text, line, heading;
  for (int row = 0; std::getline(lines, line); ++row) {
    if (row == 0) heading = line;
    if (row == 2) {
      const std::string before = heading.substr(0, heading.find("energy.kinetic"));
      std::size_t from = 0;
      for (auto column = std::count(before.begin(), before.end(), ','); column > 0; --column)
        from = line.find(',', from) + 1;
      line.replace(from, line.find(',', from) - from, "4.25e-310");
    }
    text += line + '\n';
  }
  std::ofstream{file} << text;
  const Ended ended = talus_ran({"animate", run});
  BOOST_TEST(ended.code == 0, ended.err);
  BOOST_TEST(holds(talus::read_text(run + "/plots/animation.html"), "4.25e-310"));
}

BOOST_AUTO_TEST_SUITE_END()
