// Scripts for shells, of a program with nested commands: all commands and options are in each; bash, which is at hand
// on every machine, completes with its script.
#include "solver/command_line/completion.hpp"

#include <CLI/CLI.hpp>
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(completion_tests)

using namespace talus;
namespace fs = std::filesystem;

namespace {

/// `prog`, with `go --fast, -o/--out FILE, -p/--pace PACE, --side SIDE`, `show TOPIC`, and `many` with `plan --seed N`
/// and `run`.
struct Program {
  CLI::App app{"A program", "prog"};
  std::string text;
  bool flag{};

  Program() {
    CLI::App* go = app.add_subcommand("go", "Goes; it's [quick]: \"now\"");
    go->add_flag("--fast", flag, "Quicker");
    go->add_option("-o,--out", text, "where it writes")->required();
    offer(go->add_option("-p,--pace", text, "its pace")->capture_default_str(), {"slow", "fast"});
    go->add_option("--side", text, "its side")->check(CLI::IsMember({"left", "right"}));
    go->add_option("scene", text, "what it reads");
    offer(app.add_subcommand("show", "Shows")->add_option("topic", text, "laws or units")->required(),
          {"laws", "units"});
    CLI::App* many = app.add_subcommand("many", "Goes many times");
    many->add_subcommand("plan", "Plans")->add_option("--seed", text, "of the draws");
    many->add_subcommand("run", "Runs");
  }
};

/// What bash offers for the last word typed after `prog`.
std::string offered(const std::vector<std::string>& typed) {
  const Program program;
  const Folder folder;
  const fs::path file = folder.file("completion.bash", completion(program.app, Shell::bash));
  std::string given;
  for (const std::string& word : typed)
    given += " '" + word + "'";
  const std::string command =
      "bash -c '. \"$1\"; shift; COMP_WORDS=(prog \"$@\"); COMP_CWORD=$#; _prog; echo \"${COMPREPLY[*]}\"' - " +
      file.string() + given + " 2>&1";
  std::FILE* output = ::popen(command.c_str(), "r");
  BOOST_REQUIRE(output != nullptr);
  std::string printed;
  for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output))
    printed += static_cast<char>(c);
  BOOST_TEST(::pclose(output) == 0);
  return printed;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bash_completes_commands_options_and_nothing_else) {
  BOOST_TEST(offered({""}) == "go show many\n");
  BOOST_TEST(offered({"m"}) == "many\n");
  BOOST_TEST(offered({"go", "-"}) == "-h --help --fast -o --out -p --pace --side\n");
  BOOST_TEST(offered({"go", "--f"}) == "--fast\n");
  BOOST_TEST(offered({"many", ""}) == "plan run\n");
  BOOST_TEST(offered({"many", "plan", "--s"}) == "--seed\n");
  BOOST_TEST(offered({"many", "run", "--s"}) == "\n");
  BOOST_TEST(offered({"go", "go", ""}) == "\n");             // a file's name that equals a command's
  BOOST_TEST(offered({"go", "many", "--f"}) == "--fast\n");  // as well
}

BOOST_AUTO_TEST_CASE(bash_completes_values) {
  BOOST_TEST(offered({"go", "--pace", ""}) == "slow fast\n");
  BOOST_TEST(offered({"go", "--fast", "-p", "f"}) == "fast\n");
  BOOST_TEST(offered({"go", "--side", "r"}) == "right\n");
  BOOST_TEST(offered({"go", "--pace", "="}) == "slow fast\n");  // of --pace=
  BOOST_TEST(offered({"go", "--pace", "=", "s"}) == "slow\n");
  BOOST_TEST(offered({"go", "--out", ""}) == "\n");
  BOOST_TEST(offered({"show", "u"}) == "units\n");
  BOOST_TEST(offered({"show", "--pace", ""}) == "laws units\n");  // which `show` does not have
}

BOOST_AUTO_TEST_CASE(help_does_not_list_offered_values) {
  const Program program;
  const std::string help = program.app.get_subcommand("go")->help(), show = program.app.get_subcommand("show")->help();
  BOOST_TEST(help.find("-p,--pace TEXT ") != std::string::npos, help);
  BOOST_TEST(show.find("topic TEXT REQUIRED") != std::string::npos, show);
  BOOST_TEST(help.find("slow") == std::string::npos, help);
}

BOOST_AUTO_TEST_CASE(all_scripts_have_all_commands_and_options) {
  const Program program;
  for (const Shell shell : {Shell::bash, Shell::zsh, Shell::fish}) {
    const std::string script = completion(program.app, shell);
    for (const std::string word : {"go", "many", "many plan", "many run", "fast", "out", "seed"})
      BOOST_TEST(script.find(word) != std::string::npos, word);
  }
  const std::string zsh = completion(program.app, Shell::zsh), fish = completion(program.app, Shell::fish);
  BOOST_TEST(zsh.find("'go:Goes; it'\\''s [quick]: \"now\"'") != std::string::npos, zsh);
  BOOST_TEST(fish.find("-n \"__prog_at ' go'\" -s o -l out -r -d 'where it writes'") != std::string::npos, fish);
  BOOST_TEST(fish.find("-n \"__prog_at ' go'\" -l fast -d 'Quicker'") != std::string::npos, fish);
  BOOST_TEST(fish.find("-n \"__prog_at ' many'\" -f -a plan -d 'Plans'") != std::string::npos, fish);
  BOOST_TEST(fish.find("-n \"__prog_at ' go'\" -s p -l pace -x -a 'slow fast' -d 'its pace'") != std::string::npos,
             fish);
  BOOST_TEST(fish.find("-n \"__prog_at ' show'\" -f -a 'laws units'") != std::string::npos, fish);
  BOOST_TEST(zsh.find("' go -p' | ' go --pace') values='slow fast' ;;") != std::string::npos, zsh);
  BOOST_TEST(fish.find("-d 'Goes; it\\'s [quick]: \"now\"'") != std::string::npos, fish);
}

BOOST_AUTO_TEST_SUITE_END()
