#include "solver/command_line/completion.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string_view>
#include <vector>

namespace talus {
namespace {

struct CompletedOption {
  std::vector<std::string> names;  ///< with their hyphens
  std::string meaning;
  bool takes_value{};
};

/// A command, or the program, whose path is empty.
struct CompletedCommand {
  std::string path;  ///< names from the program's first command on, separated by spaces
  std::string parent;
  std::string name, meaning;
  std::vector<CompletedOption> options;
  std::vector<std::size_t> commands;  ///< indices of those that it has
};

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::vector<CompletedOption> options_of(const CLI::App& app) {
  std::vector<CompletedOption> found;
  for (const CLI::Option* option : app.get_options()) {
    CompletedOption each{{}, first_line(option->get_description()), option->get_items_expected_max() > 0};
    for (const std::string& name : option->get_snames())
      each.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames())
      each.names.push_back("--" + name);
    if (!each.names.empty()) found.push_back(std::move(each));
  }
  return found;
}

void collect(const CLI::App& app, const std::string& path, const std::string& parent,
             std::vector<CompletedCommand>& found) {
  const std::size_t at = found.size();
  found.push_back({path, parent, app.get_name(), first_line(app.get_description()), options_of(app), {}});
  for (const CLI::App* inner : app.get_subcommands([](const CLI::App*) { return true; })) {
    found[at].commands.push_back(found.size());
    collect(*inner, path.empty() ? inner->get_name() : path + " " + inner->get_name(), path, found);
  }
}

std::string replaced(const std::string& text, std::string_view characters, std::string_view before) {
  std::string escaped;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) escaped += before;
    escaped += c;
  }
  return escaped;
}

/// The text in single quotes of bash and zsh.
std::string in_quotes(const std::string& text) {
  std::string all = "'";
  for (const char c : text)
    all += c == '\'' ? "'\\''" : std::string{c};
  return all + "'";
}

/// Lines of a `case` of bash and zsh that finds the command: each assigns a path to `command`.
std::string path_cases(const std::vector<CompletedCommand>& commands, std::string_view indent) {
  std::string lines;
  for (const CompletedCommand& each : commands) {
    if (each.path.empty()) continue;
    lines +=
        fmt::format("{}{}) command={} ;;\n", indent, in_quotes(each.parent + " " + each.name), in_quotes(each.path));
  }
  return lines;
}

std::string bash_script(const std::vector<CompletedCommand>& commands, const std::string& program) {
  std::string script = fmt::format(
      "# bash completion of {0}\n"
      "_{0}() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} command= i\n"
      "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
      "    case \"$command ${{COMP_WORDS[i]}}\" in\n"
      "{1}"
      "    esac\n"
      "  done\n"
      "  local commands= options=\n"
      "  case \"$command\" in\n",
      program, path_cases(commands, "      "));
  for (const CompletedCommand& each : commands) {
    std::string names, options;
    for (const std::size_t inner : each.commands)
      names += (names.empty() ? "" : " ") + commands[inner].name;
    for (const CompletedOption& option : each.options)
      for (const std::string& name : option.names)
        options += (options.empty() ? "" : " ") + name;
    script +=
        fmt::format("    {}) commands={} options={} ;;\n", in_quotes(each.path), in_quotes(names), in_quotes(options));
  }
  script += fmt::format(
      "  esac\n"
      "  [[ $word == -* ]] && commands=$options\n"
      "  COMPREPLY=($(compgen -W \"$commands\" -- \"$word\"))\n"
      "}}\n"
      "complete -o default -F _{0} {0}\n",
      program);
  return script;
}

std::string zsh_script(const std::vector<CompletedCommand>& commands, const std::string& program) {
  std::string script = fmt::format(
      "#compdef {0}\n"
      "# zsh completion of {0}\n"
      "_{0}() {{\n"
      "  local command= i\n"
      "  for ((i = 2; i < CURRENT; ++i)); do\n"
      "    case \"$command ${{words[i]}}\" in\n"
      "{1}"
      "    esac\n"
      "  done\n"
      "  local -a commands options\n"
      "  case \"$command\" in\n",
      program, path_cases(commands, "      "));
  for (const CompletedCommand& each : commands) {
    script += fmt::format("    {})\n      commands=(", in_quotes(each.path));
    for (const std::size_t inner : each.commands)
      script += "\n        " + in_quotes(commands[inner].name + ":" + commands[inner].meaning);
    script += ")\n      options=(";
    for (const CompletedOption& option : each.options)
      for (const std::string& name : option.names)
        script += "\n        " + in_quotes(name + ":" + option.meaning);
    script += ") ;;\n";
  }
  script += fmt::format(
      "  esac\n"
      "  if [[ ${{words[CURRENT]}} == -* ]]; then\n"
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
  const auto text = [](const std::string& of) { return "'" + replaced(of, "'\\", "\\") + "'"; };
  std::string script = fmt::format(
      "# fish completion of {0}\n"
      "function __{0}_at --description 'whether this is the command on the line'\n"
      "  set -l command ''\n"
      "  for word in (commandline -opc)[2..-1]\n"
      "    switch \"$command $word\"\n",
      program);
  for (const CompletedCommand& each : commands) {
    if (each.path.empty()) continue;
    script +=
        fmt::format("      case {}\n        set command {}\n", text(each.parent + " " + each.name), text(each.path));
  }
  script += "    end\n  end\n  test \"$command\" = \"$argv[1]\"\nend\n";
  for (const CompletedCommand& each : commands) {
    const std::string start = fmt::format("complete -c {} -n \"__{}_at {}\"", program, program, text(each.path));
    for (const std::size_t inner : each.commands)
      script += fmt::format("{} -f -a {} -d {}\n", start, commands[inner].name, text(commands[inner].meaning));
    for (const CompletedOption& option : each.options) {
      script += start;
      for (const std::string& name : option.names)
        script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      script += fmt::format("{} -d {}\n", option.takes_value ? " -r" : "", text(option.meaning));
    }
  }
  return script;
}

}  // namespace

std::string completion(const CLI::App& program, Shell shell) {
  std::vector<CompletedCommand> commands;
  collect(program, "", "", commands);
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
