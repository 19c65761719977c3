#include <boost/test/unit_test.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "tests/solver/app/requested.hpp"

BOOST_AUTO_TEST_SUITE(drawn_text_tests)

// Titles and names of a scene in the pictures of all commands that draw.

// Without a title, or with an empty or blank one, every command uses the name of the scene's file.
BOOST_AUTO_TEST_CASE(a_blank_title_is_replaced_by_the_name_of_the_file) {
  for (const char* name : {"two_cable.toml", "fence/table_2.toml", "cell/ice.toml"}) {
    const std::string text = talus::read_text(scene(name));
    const std::size_t begin = text.find("title = "), end = text.find('\n', begin) + 1;
    for (const char* title : {"", "title = \"\"\n", "title = \"  \"\n"}) {
      BOOST_TEST_CONTEXT(name << ", " << title) {
        const Folder folder;
        const std::string file = folder.file("untitled.toml", std::string{text}.replace(begin, end - begin, title));
        const std::string run = (folder.path / "run").string();
        const bool cell = std::string{name} == "cell/ice.toml", fence = holds(name, "fence");
        std::vector<std::string> command{cell ? "cell" : "run", file, "--out", run};
        if (!cell) command.insert(command.end(), {"--end", "4 ms", "--frames", "4"});
        if (fence) command.push_back("--sheet");
        const Ended ended = talus_ran(command);
        BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
        if (!fence) BOOST_TEST(ended.out.rfind("untitled\n", 0) == 0U, ended.out.substr(0, 80));
        BOOST_TEST(nlohmann::json::parse(talus::read_text(run + "/summary.json")).at("title") == "untitled");
        if (fence) BOOST_TEST(holds(talus::read_text(run + "/sheet.html"), "<h1>untitled</h1>"));
        const std::string quantity = cell ? "depth" : "energy.kinetic";
        BOOST_TEST(Requested({"plot", run, "--history", quantity}).page().title == "untitled");
        BOOST_TEST(Requested({"snapshot", run, "--count", "2"}).page().title == "untitled");
        BOOST_TEST(talus_ran({"plot", run, "--format", "svg"}).code == 0);
        const Ended animated = talus_ran({"animate", run});
        BOOST_TEST_REQUIRE(animated.code == 0, animated.err);
        BOOST_TEST(holds(talus::read_text(run + "/plots/animation.html"), "<h1>untitled</h1>"));
      }
    }
  }
}

// Strings of a scene are drawn as plain text everywhere: no markup, no commands of gnuplot or of a shell.
BOOST_AUTO_TEST_CASE(texts_of_a_scene_stay_text) {
  const Folder folder;
  std::string text = talus::read_text(scene("two_cable.toml"));
  const auto replace_all = [&](const std::string& part, const std::string& by) {
    BOOST_REQUIRE(holds(text, part));
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += by.size())
      text.replace(at, part.size(), by);
  };
  const std::string touch = "touch " + (folder.path / "pwned").string();
  const std::string title = "</script><script>alert(1)</script> $x$ `" + touch + "` $(" + touch + ")";
  const std::size_t first = text.find("title = "), end = text.find('\n', first);
  text.replace(first, end - first, "title = '" + title + "'");
  replace_all("\"upper\"", "\"<b>'; system '" + touch + "' # $ \"");
  std::ofstream{folder.path / "hostile.toml"} << text;
  const fs::path out = folder.path / "out";
  BOOST_REQUIRE(
      talus_ran({"run", (folder.path / "hostile.toml").string(), "--end", "10 ms", "--out", out.string()}).code == 0);
  for (const std::vector<std::string>& command : {std::vector<std::string>{"plot", out.string(), "--format", "svg"},
                                                  {"snapshot", out.string(), "--format", "svg"},
                                                  {"animate", out.string()}})
    BOOST_TEST(talus_ran(command).code == 0, command[0]);
  BOOST_TEST(!fs::exists(folder.path / "pwned"));
  std::size_t titled = 0;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    const std::string extension = entry.path().extension();
    if (extension == ".html") BOOST_TEST(!holds(talus::read_text(entry.path().string()), "<script>alert"));
    if (extension != ".svg" && extension != ".vtp" && extension != ".pvd") continue;
    pugi::xml_document document;
    BOOST_TEST(document.load_file(entry.path().c_str()).status == pugi::status_ok, entry.path());
    titled += holds(talus::read_text(entry.path().string()), "alert(1)&lt;/script> $x$") ? 1U : 0U;
  }
  BOOST_TEST(titled > 0U);
}

BOOST_AUTO_TEST_SUITE_END()
