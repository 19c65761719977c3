#include "solver/command_line/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

#include "solver/command_line/shell_word.hpp"

namespace talus {
namespace {

struct CompletedOption {
  std::vector<std::string> names;  ///< with their hyphens
  std::string meaning;
  bool takes_value{};
  std::vector<std::string> values;  ///< that it can have; empty if they are not known
};

/// A command, or the program.
struct CompletedCommand {
  std::string path;  ///< of the program "", of a command the path that it is in, a space and its name
  std::string name, meaning;
  std::vector<CompletedOption> options;
  std::vector<std::string> arguments;  ///< values of its arguments
  std::vector<std::size_t> commands;   ///< indices of those that it has
};

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The list of an option's type in braces, which offer() and CLI::IsMember give it.
std::vector<std::string> values_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t first = type.find('{'), end = type.find('}');
  if (first == std::string::npos || end == std::string::npos) return {};
  return CLI::detail::split(type.substr(first + 1, end - first - 1), ',');
}

std::vector<CompletedOption> options_of(const CLI::App& app) {
  std::vector<CompletedOption> found;
  for (const CLI::Option* option : app.get_options()) {
    CompletedOption each{
        {}, first_line(option->get_description()), option->get_items_expected_max() > 0, values_of(*option)};
    for (const std::string& name : option->get_snames())
      each.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames())
      each.names.push_back("--" + name);
    if (!each.names.empty()) found.push_back(std::move(each));
  }
  return found;
}

void collect(const CLI::App& app, const std::string& path, std::vector<CompletedCommand>& found) {
  const std::size_t at = found.size();
  found.push_back({path, app.get_name(), first_line(app.get_description()), options_of(app), {}, {}});
  for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->get_positional(); }))
    std::ranges::copy(values_of(*option), std::back_inserter(found.back().arguments));
  for (const CLI::App* inner : app.get_subcommands([](const CLI::App*) { return true; })) {
    found[at].commands.push_back(found.size());
    collect(*inner, path + " " + inner->get_name(), found);
  }
}

/// The paths of all commands in single quotes, with a separator between them.
std::string quoted_paths(const std::vector<CompletedCommand>& commands, std::string_view separator) {
  std::string paths;
  for (const CompletedCommand& each : commands)
    if (!each.path.empty()) paths += (paths.empty() ? "" : std::string{separator}) + single_quoted(each.path);
  return paths;
}

/// The start of the function of bash and zsh: finds the path of the command before the word to complete, which is
/// number `last` of the array `typed`, whose first word after the program is number `first`.
std::string path_search(const std::vector<CompletedCommand>& commands, const std::string& program,
                        std::string_view typed, std::string_view last, int first) {
  return fmt::format(
      "_{}() {{\n"
      "  local command= i\n"
      "  for ((i = {}; i < {}; ++i)); do\n"
      "    case \"$command ${{{}[i]}}\" in\n"
      "      {}) command+=\" ${{{}[i]}}\" ;;\n"
      "    esac\n"
      "  done\n",
      program, first, last, typed, quoted_paths(commands, " | "), typed);
}

/// Of bash and zsh: sets a variable to the values of the option that is the word $before.
std::string value_cases(const std::vector<CompletedCommand>& commands, std::string_view variable) {
  std::string cases = "  case \"$command $before\" in\n";
  for (const CompletedCommand& each : commands) {
    for (const CompletedOption& option : each.options) {
      if (option.values.empty()) continue;
      std::string patterns;
      for (const std::string& name : option.names)
        patterns += (patterns.empty() ? "" : " | ") + single_quoted(each.path + " " + name);
      cases += fmt::format("    {}) {}={} ;;\n", patterns, variable,
                           single_quoted(fmt::format("{}", fmt::join(option.values, " "))));
    }
  }
  return cases + "  esac\n";
}

std::string bash_script(const std::vector<CompletedCommand>& commands, const std::string& program) {
  std::string script =
      fmt::format("# bash completion of {}\n", program) +
      path_search(commands, program, "COMP_WORDS", "COMP_CWORD", 1) +
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} commands= options=\n"
      // Of --option=value, bash makes three words.
      "  [[ $word == '=' ]] && word=\n"
      "  [[ $before == '=' ]] && before=${COMP_WORDS[COMP_CWORD - 2]}\n"
      "  case \"$command\" in\n";
  for (const CompletedCommand& each : commands) {
    std::string names = fmt::format("{}", fmt::join(each.arguments, " ")), options;
    for (const std::size_t inner : each.commands)
      names += (names.empty() ? "" : " ") + commands[inner].name;
    for (const CompletedOption& option : each.options)
      for (const std::string& name : option.names)
        options += (options.empty() ? "" : " ") + name;
    script += fmt::format("    {}) commands={} options={} ;;\n", single_quoted(each.path), single_quoted(names),
                          single_quoted(options));
  }
  script +=
      "  esac\n"
      "  [[ $word == -* ]] && commands=$options\n" +
      value_cases(commands, "commands");
  script += fmt::format(
      "  COMPREPLY=($(compgen -W \"$commands\" -- \"$word\"))\n"
      "}}\n"
      "complete -o default -F _{0} {0}\n",
      program);
  return script;
}

std::string zsh_script(const std::vector<CompletedCommand>& commands, const std::string& program) {
  std::string script = fmt::format("#compdef {0}\n# zsh completion of {0}\n", program) +
                       path_search(commands, program, "words", "CURRENT", 2) +
                       "  local -a commands options\n"
                       "  case \"$command\" in\n";
  for (const CompletedCommand& each : commands) {
    script += fmt::format("    {})\n      commands=(", single_quoted(each.path));
    for (const std::size_t inner : each.commands)
      script += "\n        " + single_quoted(commands[inner].name + ":" + commands[inner].meaning);
    for (const std::string& value : each.arguments)
      script += "\n        " + single_quoted(value);
    script += ")\n      options=(";
    for (const CompletedOption& option : each.options)
      for (const std::string& name : option.names)
        script += "\n        " + single_quoted(name + ":" + option.meaning);
    script += ") ;;\n";
  }
  script +=
      "  esac\n"
      "  local word=${words[CURRENT]} before=${words[CURRENT - 1]} values=\n"
      "  [[ $word == --*=* ]] && before=${word%%=*}\n" +
      value_cases(commands, "values") +
      // What follows = is completed alone, where no values are known by files.
      "  [[ $word == --*=* ]] && compset -P '*=' && word=\n";
  script += fmt::format(
      "  if [[ -n $values ]]; then\n"
      "    compadd -- ${{=values}}\n"
      "  elif [[ $word == -* ]]; then\n"
      "    _describe -o option options\n"
      "  elif (( $#commands )); then\n"
      "    _describe command commands\n"
      "  else\n"
      "    _files\n"
      "  fi\n"
      "}}\n"
      "if [[ ${{funcstack[1]}} == _{0} ]]; then _{0}; else compdef _{0} {0}; fi\n",
      program);
  return script;
}

std::string fish_script(const std::vector<CompletedCommand>& commands, const std::string& program) {
  const auto text = [](const std::string& of) {
    std::string quoted = "'";
    for (const char c : of)
      quoted += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return quoted + "'";
  };
  std::string script = fmt::format(
      "# fish completion of {0}\n"
      "function __{0}_at --description 'whether this is the command on the line'\n"
      "  set -l command ''\n"
      "  for word in (commandline -opc)[2..-1]\n"
      "    switch \"$command $word\"\n"
      "      case {1}\n"
      "        set command \"$command $word\"\n",
      program, quoted_paths(commands, " "));
  script += "    end\n  end\n  test \"$command\" = \"$argv[1]\"\nend\n";
  for (const CompletedCommand& each : commands) {
    const std::string start = fmt::format("complete -c {} -n \"__{}_at {}\"", program, program, text(each.path));
    for (const std::size_t inner : each.commands)
      script += fmt::format("{} -f -a {} -d {}\n", start, commands[inner].name, text(commands[inner].meaning));
    if (!each.arguments.empty())
      script += fmt::format("{} -f -a {}\n", start, text(fmt::format("{}", fmt::join(each.arguments, " "))));
    for (const CompletedOption& option : each.options) {
      script += start;
      for (const std::string& name : option.names)
        script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.values.empty())
        script += fmt::format(" -x -a {}", text(fmt::format("{}", fmt::join(option.values, " "))));
      else if (option.takes_value)
        script += " -r";
      script += fmt::format(" -d {}\n", text(option.meaning));
    }
  }
  return script;
}

}  // namespace

CLI::Option* offer(CLI::Option* option, const std::vector<std::string>& values) {
  const std::string shown = CLI::Formatter{}.make_option_opts(option);
  return option->option_text(shown.substr(std::min<std::size_t>(1, shown.size())))
      ->type_name(fmt::format("{{{}}}", fmt::join(values, ",")));
}

std::string completion(const CLI::App& program, Shell shell) {
  std::vector<CompletedCommand> commands;
  collect(program, "", commands);
  const std::string& name = program.get_name();
  switch (shell) {
    case Shell::bash:
      return bash_script(commands, name);
    case Shell::zsh:
      return zsh_script(commands, name);
    case Shell::fish:
      break;
  }
  return fish_script(commands, name);
}

}  // namespace talus
