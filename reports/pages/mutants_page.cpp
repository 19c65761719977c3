#include "reports/pages/mutants_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/pages/kill_matrix.hpp"
#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {

namespace {

using markdown::cell;
using records::MutantStatus;
using Rows = std::vector<std::vector<std::string>>;

constexpr std::array factors{1.0, 2.0, 5.0, 10.0};

std::string percent(double fraction) { return fmt::format("{:.1f} %", 100.0 * fraction); }

std::string folder_of(const MutantRecord& mutant) { return mutant.file.substr(0, mutant.file.rfind('/')); }

std::vector<std::string> score_row(const std::string& name, const Score& score) {
  return {name,
          fmt::format("{}", score.killed),
          fmt::format("{}", score.survived),
          fmt::format("{}", score.unreached),
          fmt::format("{}", score.equivalent),
          percent(score.fraction())};
}

/// One row per name, and a total.
std::string score_table(const char* heading, const std::map<std::string, Score>& scores, const Score& all) {
  Rows rows;
  for (const auto& [name, score] : scores)
    rows.push_back(score_row(cell(name), score));
  rows.push_back(score_row("**all**", all));
  return markdown::table(
      {{heading}, {"killed", true}, {"survived", true}, {"unreached", true}, {"equivalent", true}, {"score", true}},
      rows, "");
}

/// Fraction of the counted mutants killed by the first cases of the greedy order.
Figure greedy_figure(const Mutants& mutants) {
  const auto of = generated(mutants);
  const double counted = static_cast<double>(score_of(of).counted());
  Figure figure;
  figure.name = "greedy";
  figure.title = "Score against the number of cases";
  figure.x = {.label = "cases"};
  figure.y = {.label = "mutants killed", .unit = "%", .log = false, .min = 0.0, .max = 100.0};
  Series killed{.label = "killed by the first cases"};
  std::vector<std::string> first;
  std::size_t sum = 0;
  for (const Greedy& each : greedy_order(mutants, of)) {
    sum += each.more;
    killed.add(static_cast<double>(killed.x.size() + 1), 100.0 * static_cast<double>(sum) / counted);
    if (first.size() < 10) first.push_back(each.case_id);
  }
  figure.series.push_back(std::move(killed));
  figure.lines.push_back({'y', 90.0, "90 %"});
  figure.caption = fmt::format(
      "Cases in greedy order: each is the one that kills most mutants that those before it leave. First: {}.",
      fmt::join(first, ", "));
  return figure;
}

std::vector<std::string> families_of(const Mutants& mutants) {
  std::vector<std::string> families;
  for (const records::UnchangedCase& one : mutants.cases) {
    if (!one.family.empty() && std::find(families.begin(), families.end(), one.family) == families.end())
      families.push_back(one.family);
  }
  return families;
}

Figure tolerance_figure(const Mutants& mutants) {
  const auto of = generated(mutants);
  Figure figure;
  figure.name = "tolerance";
  figure.title = "Score against tolerance";
  figure.caption =
      "Fraction of the mutants that would still be killed if the bound of every check were 2, 5 or 10 times as large; "
      "by "
      "all cases, and by those of one family alone. Checks that have no size (same bits, a refused scene) and cases "
      "that break off kill at any tolerance.";
  figure.x = {.label = "bounds multiplied by", .unit = "1", .log = false, .min = 0.0, .max = 10.5};
  figure.y = {.label = "mutants killed", .unit = "%", .log = false, .min = 0.0, .max = 100.0};
  const auto add = [&](const std::string& label, const std::string& family) {
    Series series{.label = label};
    for (const double factor : factors)
      series.add(factor, 100.0 * fraction_at(mutants, of, factor, family));
    figure.series.push_back(std::move(series));
  };
  add("all cases", "");
  for (const std::string& family : families_of(mutants))
    add(family, family);
  return figure;
}

/// Matrix with a row per mutant and a column per case.
Figure matrix_figure(const Mutants& mutants) {
  Figure figure;
  figure.name = "matrix";
  figure.title = "Mutants and cases";
  figure.caption = fmt::format(
      "A row is a mutant or bug (in the order of the files), a column a case (in the order of the report). Diamonds: "
      "the case evaluates the mutated code{}; crosses: the case turned red.",
      mutants.whole_matrix ? "" : " (each mutant was tried until the first case was red)");
  figure.x = {
      .label = "case", .unit = "1", .log = false, .min = 0.0, .max = static_cast<double>(mutants.cases.size() + 1)};
  std::vector<const MutantRecord*> rows;
  for (const MutantRecord& mutant : mutants.mutants) {
    if (mutant.status != MutantStatus::equivalent && mutant.status != MutantStatus::pending) rows.push_back(&mutant);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const MutantRecord* a, const MutantRecord* b) {
    return std::pair{a->file, a->range.line} < std::pair{b->file, b->range.line};
  });
  figure.y = {.label = "mutant", .unit = "1", .log = false, .min = 0.0, .max = static_cast<double>(rows.size() + 1)};
  Series green{.label = "evaluated", .style = Style::points};
  Series red{.label = "red", .style = Style::crosses};
  const auto column_of = [&](const std::string& id) {
    const auto found = std::find_if(mutants.cases.begin(), mutants.cases.end(),
                                    [&](const records::UnchangedCase& one) { return one.id == id; });
    return static_cast<double>(found - mutants.cases.begin()) + 1.0;
  };
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::set<std::string> killing;
    for (const Trial& trial : rows[row]->trials) {
      if (kills(trial)) killing.insert(trial.case_id);
    }
    for (const std::string& id : rows[row]->covered_by) {
      Series& series = killing.count(id) > 0 ? red : green;
      series.add(column_of(id), static_cast<double>(row) + 1.0);
    }
  }
  for (Series* series : {&green, &red}) {
    if (!series->x.empty()) figure.series.push_back(std::move(*series));
  }
  return figure;
}

std::string location_of(const MutantRecord& mutant) {
  return markdown::code(fmt::format("{}:{}", mutant.file, mutant.range.line));
}

std::string change_of(const MutantRecord& mutant) {
  const auto shortened = [](std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == ' ' && b == ' '; }), text.end());
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
  };
  return markdown::code(shortened(mutant.original)) + "\\\n  " +
         (mutant.replacement.empty() ? "is left out" : "becomes " + markdown::code(shortened(mutant.replacement)));
}

std::string list_of(const Mutants& mutants, MutantStatus status) {
  std::string text;
  for (const MutantRecord* mutant : generated(mutants)) {
    if (mutant->status != status) continue;
    text += fmt::format("- {}, {}: {}{}\n", location_of(*mutant), cell(mutant->operation), change_of(*mutant),
                        mutant->reason.empty() ? "" : ". " + markdown::text(mutant->reason));
  }
  return text;
}

std::string bug_list(const Mutants& mutants, const Results& results) {
  std::string text;
  for (const MutantRecord* bug : written(mutants)) {
    std::vector<std::string> red;
    for (const Trial& trial : bug->trials) {
      if (kills(trial)) red.push_back(trial.case_id);
    }
    const char* const no_case = bug->status == MutantStatus::pending ? "not tried to the end" : "**none**";
    text += fmt::format("- {}, {}: {} Red: {}.\n", cell(bug->id), location_of(*bug), markdown::text(bug->description),
                        red.empty() ? no_case : joined_links(results, red));
  }
  return text;
}

std::string figure_link(const Figure& figure) {
  return fmt::format("![**{}.** {}](figures/mutants-{}.svg){{alt=\"{}\" width=100%}}\n\n", markdown::text(figure.title),
                     markdown::text(figure.caption), figure.name, figure.title);
}

std::string joined(const std::map<std::string, std::size_t>& counts, const Results& results) {
  std::string text;
  for (const auto& [id, number] : counts)
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", link_of(results, id), number);
  return text;
}

/// Lists of the cases that are the only ones to kill a mutant, and of those that kill none.
std::string who_kills(const Mutants& mutants, const Results& results) {
  std::vector<const MutantRecord*> all;
  for (const MutantRecord& mutant : mutants.mutants)
    all.push_back(&mutant);
  const auto killing = killers(all);
  std::vector<std::string> idle;
  for (const records::UnchangedCase& one : mutants.cases) {
    if (killing.count(one.id) == 0) idle.push_back(one.id);
  }
  return fmt::format(
      "Cases that alone kill mutants or bugs (how many): {}.\n\nCases that kill none of this sample: {}.\n\n",
      joined(lone_killers(all), results), idle.empty() ? "none" : joined_links(results, idle));
}

}  // namespace

std::vector<Figure> mutants_figures(const Mutants& mutants) {
  std::vector<Figure> figures{matrix_figure(mutants)};
  if (mutants.whole_matrix && score_of(generated(mutants)).counted() > 0) {
    const Mutants independent = of_matrix(without_recorded(mutants));
    figures.push_back(greedy_figure(independent));
    figures.push_back(tolerance_figure(independent));
  }
  std::erase_if(figures, [](const Figure& figure) { return figure.series.empty(); });
  return figures;
}

std::string mutants_text(const Mutants& mutants, const Results& results, bool pictures) {
  const auto sample = generated(mutants);
  const auto bugs = written(mutants);
  const Score score = score_of(sample);
  const Score of_bugs = score_of(bugs);
  const Interval range = wilson(score.killed, score.counted());
  std::string text = fmt::format(
      "Small bugs were compiled into a copy of the solver, one switched on at a time, and {} cases of the quick "
      "tier run (their right setups, without controls). **{} of {} generated mutants were killed: {}** ({} equivalent "
      "ones do not count). They are a sample of {} candidates (seed {}), whose score lies between {} and {} (Wilson "
      "interval, 95 %). **Of {} bugs written by hand {} were killed.** Building took {:.0f} s, the runs {:.0f} s.\n\n",
      mutants.cases.size(), score.killed, score.counted(), percent(score.fraction()), score.equivalent,
      mutants.candidates, mutants.seed, percent(range.low), percent(range.high), of_bugs.counted(), of_bugs.killed,
      mutants.build_seconds, mutants.run_seconds);
  const Mutants others = without_recorded(mutants);
  if (others.cases.size() < mutants.cases.size()) {
    const Score independent = score_of(generated(others));
    text += fmt::format(
        "Of them {} are noticed by comparison with recorded results alone, which shows that something changed, not "
        "what is "
        "right. **Without it {} are killed: {}**; the tables count it, the curves do not.\n\n",
        score.killed - independent.killed, independent.killed, percent(independent.fraction()));
  }
  if (of_bugs.pending > 0) text += fmt::format("{} other written bugs were not tried to the end.\n\n", of_bugs.pending);
  if (score.pending > 0) {
    text += fmt::format(
        "{} generated mutants were not tried to the end, and do not count. If none of them is killed the score is "
        "{}.\n\n",
        score.pending,
        percent(static_cast<double>(score.killed) / static_cast<double>(score.counted() + score.pending)));
  }
  text += score_table("folder", scores_by(sample, folder_of), score) + "\n";
  text += score_table("file", scores_by(sample, [](const MutantRecord& mutant) { return mutant.file; }), score) + "\n";
  text +=
      score_table("operation", scores_by(sample, [](const MutantRecord& mutant) { return mutant.operation; }), score);
  text += "\n";
  if (pictures) {
    for (const Figure& figure : mutants_figures(mutants))
      text += figure_link(figure);
  }
  if (mutants.whole_matrix) text += who_kills(of_matrix(others), results);
  if (!bugs.empty()) text += "## Bugs written by hand\n\n" + bug_list(mutants, results) + "\n";
  const std::string survived = list_of(mutants, MutantStatus::survived);
  if (!survived.empty()) text += "## Survivors\n\nCases evaluate them, and stay green.\n\n" + survived + "\n";
  const std::string unreached = list_of(mutants, MutantStatus::unreached);
  if (!unreached.empty()) text += "## Unreached\n\nNone of these cases evaluates them.\n\n" + unreached + "\n";
  const std::string equivalent = list_of(mutants, MutantStatus::equivalent);
  if (!equivalent.empty()) text += "## Equivalent\n\nThey change no result.\n\n" + equivalent + "\n";
  return text;
}

std::string bugs_text(const Mutants& mutants, const std::string& case_id) {
  const auto red = [&](const MutantRecord* mutant) {
    return std::ranges::any_of(mutant->trials,
                               [&](const Trial& trial) { return trial.case_id == case_id && kills(trial); });
  };
  std::string text;
  for (const MutantRecord* bug : written(mutants)) {
    if (red(bug)) text += fmt::format("- {}\n", markdown::text(bug->description));
  }
  const auto others = std::ranges::count_if(generated(mutants), red);
  if (others > 0) text += fmt::format("- Generated [mutants](page:mutants): {}.\n", others);
  return text;
}

std::string gate_text(const Mutants& mutants) {
  const Score score = score_of(generated(mutants));
  const Score bugs = score_of(written(mutants));
  const std::string survived = list_of(mutants, MutantStatus::survived) + list_of(mutants, MutantStatus::unreached);
  return fmt::format("**Gate of this run.** By {} cases: {} of {} generated mutants, and {} of {} written bugs.\n\n{}",
                     mutants.cases.size(), score.killed, score.counted(), bugs.killed, bugs.counted(),
                     survived.empty() ? "" : "Of the gate's mutants, these remain:\n\n" + survived + "\n");
}

}  // namespace talus::reports
