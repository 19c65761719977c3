#include "solver/draw/history_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/io/fence1993/fence_codes.hpp"

namespace talus::app {
namespace {

constexpr std::string_view element_prefix = "element";

std::string lower(std::string_view text) {
  std::string made;
  for (const char letter : text)
    made += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return made;
}

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

/// The history of the 1993 code with this number, title or name; null if there is none.
const FenceCode* code_of(std::string_view word) {
  const std::optional<int> number = whole_number(word);
  for (const FenceCode& code : fence_codes()) {
    if (number == code.number || (!code.name.empty() && word == code.name) || lower(word) == lower(code.title)) {
      return &code;
    }
  }
  return nullptr;
}

/// Whether a column belongs to the energy balance of the whole scene, not to an element.
bool of_scene(const SavedColumn& column) {
  const std::string subject = column.subject();
  return subject == "energy" || subject == "dissipated" || subject == "balance_error";
}

/// Whether a column contains the quantity of some element. Columns named angle and spin also match theta and omega, the
/// 1993 names.
bool holds(const SavedColumn& column, const std::string& quantity) {
  if (column.subject().empty() || of_scene(column)) return false;
  const std::string own = column.quantity();
  return own == quantity || (own == "angle" && quantity == "theta") || (own == "spin" && quantity == "omega");
}

std::string shown_subject(const std::string& subject) {
  const bool numbered = subject.rfind(element_prefix, 0) == 0 && whole_number(subject.substr(element_prefix.size()));
  return numbered ? fmt::format("{} {}", element_prefix, subject.substr(element_prefix.size())) : subject;
}

ChosenColumn chosen(const SavedColumn& column) {
  const FenceCode* const code = code_of(column.quantity());
  const bool titled = code != nullptr && column.subject().rfind(element_prefix, 0) == 0;
  return {titled ? lower(code->title) : column.quantity(), shown_subject(column.subject()), column.unit, column.values};
}

template <class Texts>
void add_new(Texts& texts, const std::string& text) {
  if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
}

/// Names of the saved quantities without duplicates; quantities of the whole scene (energies) as full column names.
std::vector<std::string> kept_quantities(const SavedRun& run) {
  std::vector<std::string> names;
  for (const KeptHistory& history : run.histories) {
    for (std::size_t i = 1; i < history.columns.size(); ++i) {
      const SavedColumn& column = history.columns[i];
      add_new(names, of_scene(column) ? column.name : column.quantity());
    }
  }
  return names;
}

InputError not_kept(const SavedRun& run, const std::string& word, const FenceCode* code) {
  const std::string folder = run.run.folder.string();
  const std::vector<std::string> kept = kept_quantities(run);
  if (code == nullptr) return InputError{fmt::format("{}: {}", folder, unknown_name("history", word, kept).what())};
  return InputError{fmt::format(
      "{}: history {} ({}, {}) was not recorded; nearest: {}; recorded: {}; a fence records those that its deck names "
      "(variab)",
      folder, code->number, code->title, code->name, nearest_name(code->name, kept), fmt::join(kept, ", "))};
}

using Found = std::pair<const KeptHistory*, std::vector<const SavedColumn*>>;

/// The columns of a history, from the first file that contains any.
Found columns_of(const SavedRun& run, const std::string& word) {
  const FenceCode* const code = code_of(word);
  if (code != nullptr && !code->refusal.empty()) {
    throw InputError{fmt::format("--history: {} ({}) has no history: {}", code->number, code->title, code->refusal)};
  }
  const std::string quantity = code != nullptr ? std::string{code->name} : word;
  for (const KeptHistory& history : run.histories) {
    std::vector<const SavedColumn*> found;
    for (const SavedColumn& column : history.columns) {
      if (column.name == quantity || holds(column, quantity)) found.push_back(&column);
    }
    if (!found.empty()) return {&history, found};
  }
  throw not_kept(run, word, code);
}

/// The columns of the requested elements, in the query's order.
std::vector<const SavedColumn*> of_elements(const SavedRun& run, const Found& found, const CurveQuery& query) {
  std::vector<const SavedColumn*> kept;
  for (const std::string& element : query.elements) {
    const std::vector<std::string> subjects = subjects_of(run, element);
    const auto fits = [&](const SavedColumn* column) {
      return std::find(subjects.begin(), subjects.end(), column->subject()) != subjects.end();
    };
    const auto match = std::find_if(found.second.begin(), found.second.end(), fits);
    if (match != found.second.end()) {
      kept.push_back(*match);
      continue;
    }
    std::vector<std::string> known;
    for (const SavedColumn* column : found.second)
      if (!column->subject().empty()) known.push_back(shown_subject(column->subject()));
    if (known.empty()) {
      throw InputError{fmt::format("{}: history '{}' belongs to the scene; found --element {}; remove it",
                                   found.first->file.string(), query.history, element)};
    }
    throw InputError{fmt::format("{}: history '{}' was not recorded for element '{}'; nearest: {}; recorded for: {}",
                                 found.first->file.string(), query.history, element, nearest_name(element, known),
                                 fmt::join(known, ", "))};
  }
  return query.elements.empty() ? found.second : kept;
}

const SavedColumn& abscissa(const KeptHistory& history, const SavedColumn& y, const std::string& word) {
  const FenceCode* const code = code_of(word);
  const std::string quantity = code != nullptr ? std::string{code->name} : word;
  std::vector<std::string> known;
  for (const SavedColumn& column : history.columns) {
    if (column.name == word || (column.subject() == y.subject() && holds(column, quantity))) return column;
    if (column.subject() == y.subject() || column.subject().empty()) add_new(known, column.quantity());
  }
  throw InputError{fmt::format("{}: {}", history.file.string(), unknown_name("abscissa", word, known).what())};
}

/// A line of the menu.
struct MenuEntry {
  std::string quantity, unit;
  std::vector<std::string> subjects;  ///< empty: of the scene
};

std::vector<MenuEntry> menu_entries(const KeptHistory& history) {
  std::vector<MenuEntry> entries;
  for (std::size_t i = 1; i < history.columns.size(); ++i) {
    const SavedColumn& column = history.columns[i];
    const std::string shown = of_scene(column) ? column.name : column.quantity();
    auto match =
        std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.quantity == shown; });
    if (match == entries.end()) match = entries.insert(match, {shown, column.unit, {}});
    if (!of_scene(column)) match->subjects.push_back(shown_subject(column.subject()));
  }
  return entries;
}

}  // namespace

SavedRun read_saved_run(const std::string& folder) {
  SavedRun run{read_run_folder(folder), {}};
  for (const std::string& file : run.run.files.histories)
    run.histories.push_back(read_history(run.run.folder / file));
  return run;
}

std::vector<std::string> subjects_of(const SavedRun& run, const std::string& element) {
  const std::optional<int> number = whole_number(element);
  if (!number) return {element};
  std::vector<std::string> names{fmt::format("{}{}", element_prefix, *number)};
  for (const DrawnBody& body : run.run.files.bodies) {
    if (body.number == *number) names.push_back(body.name);
  }
  return names;
}

std::vector<SelectedCurve> selected_curves(const SavedRun& run, const CurveQuery& query) {
  const Found found = columns_of(run, query.history);
  std::vector<SelectedCurve> curves;
  for (const SavedColumn* column : of_elements(run, found, query))
    curves.push_back({chosen(abscissa(*found.first, *column, query.abscissa)), chosen(*column)});
  return curves;
}

std::string menu(const SavedRun& run) {
  std::string text;
  for (const KeptHistory& history : run.histories) {
    text += fmt::format("{}\n", history.file.string());
    const std::vector<MenuEntry> entries = menu_entries(history);
    std::size_t width = 26;
    for (const MenuEntry& entry : entries)
      width = std::max(width, entry.quantity.size() + 1);
    for (const MenuEntry& entry : entries) {
      const FenceCode* const code = entry.subjects.empty() ? nullptr : code_of(entry.quantity);
      text += fmt::format("  {:>2}  {:<{}}{:<11}{:<42}{}\n", code != nullptr ? fmt::format("{}", code->number) : "",
                          entry.quantity, width, entry.unit.empty() ? "" : "[" + entry.unit + "]",
                          code != nullptr ? lower(code->title) : "", fmt::join(entry.subjects, ", "));
    }
  }
  return text;
}

}  // namespace talus::app
