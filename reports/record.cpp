#include "reports/record.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <fstream>

#include "reports/case_record.hpp"
#include "reports/error.hpp"
#include "reports/figure_record.hpp"
#include "reports/json_node.hpp"
#include "reports/record_consistency.hpp"

namespace talus::reports {
namespace {

Provenance provenance_of(const Node& node) {
  Provenance p;
  p.revision = node.at("revision").text();
  p.dirty = node.flag_or_false("dirty");
  p.compiler = node.at("compiler").text();
  p.flags = node.at("flags").text();
  p.build_type = node.text_or_empty("build_type");
  p.cpu = node.at("cpu").text();
  p.cores = node.has("cores") ? node.at("cores").integer() : 0;
  p.os = node.text_or_empty("os");
  p.libraries = node.at("libraries").dictionary();
  p.date = node.at("date").words();
  try {
    static_cast<void>(epoch_seconds(p.date));
  } catch (const RecordError& wrong) {
    node.at("date").complain(wrong.what());
  }
  return p;
}

Counts counts_of(const Node& node) {
  return {node.at("cases").integer(),
          node.at("passed").integer(),
          node.at("failed").integer(),
          node.at("checks").integer(),
          node.at("checks_failed").integer(),
          node.at("slack").integer(),
          node.at("controls").integer(),
          node.at("controls_failed").integer(),
          node.has("exempt") ? node.at("exempt").integer() : 0};
}

json parsed(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw OutputError(file.string() + ": cannot be read");
  try {
    return json::parse(stream);
  } catch (const json::parse_error& wrong) {
    throw RecordError(fmt::format("{}: is not JSON: {}", file.string(), wrong.what()));
  }
}

void demand_schema(const Node& root) {
  if (root.at("schema").integer() != 1) root.at("schema").complain("this report reads schema 1 only");
}

}  // namespace

Results read_results(const std::filesystem::path& file) {
  const json document = parsed(file);
  const Node root(document, file.string() + ": results");
  demand_schema(root);
  Results results;
  results.provenance = provenance_of(root.at("provenance"));
  results.registered = root.at("registered").texts();
  results.selected = root.has("selected") ? root.at("selected").texts() : results.registered;
  results.counts = counts_of(root.at("counts"));
  results.tier = root.text_or_empty("tier");
  results.verdict = root.at("verdict").one_of({"pass", "fail"});
  for (const Node& item : root.at("requirements").list()) {
    Requirement requirement{item.at("id").words(),
                            item.at("group").words(),
                            item.text_or_empty("text"),
                            item.at("cases").texts(),
                            item.at("checks").integer(),
                            {},
                            item.has("order") ? item.at("order").integer() : 0};
    for (const Node& shown : item.list_or_empty("shown_by"))
      requirement.shown_by.push_back({shown.at("case").words(), shown.at("checks").texts()});
    results.requirements.push_back(std::move(requirement));
  }
  if (root.has("families")) results.families = root.at("families").texts();
  for (const Node& item : root.at("cases").list())
    results.cases.push_back(case_of(item));
  if (!root.at("counts").has("exempt")) results.counts.exempt = counted(results.cases).exempt;
  for (const Node& item : root.list_or_empty("errata")) {
    results.errata.push_back({item.at("id").words(), item.text_or_empty("where"), item.at("printed").text(),
                              item.at("corrected").text(), item.text_or_empty("evidence"), item.text_or_empty("case")});
  }
  for (const Node& item : root.list_or_empty("peers")) {
    results.peers.push_back({item.at("suite").words(), item.at("id").words(), item.at("what").words(),
                             item.at("form").words(), item.text_or_empty("remark"), item.at("problems").texts(),
                             item.at("cases").texts()});
  }
  for (const Node& item : root.list_or_empty("references")) {
    results.references.push_back({item.at("key").words(), item.at("text").words()});
  }
  demand_consistency(root, results);
  return results;
}

Plots read_plots(const std::filesystem::path& file) {
  const json document = parsed(file);
  const Node root(document, file.string() + ": plot");
  Plots plots{root.text_or_empty("title"), {}, {}, {}, {}};
  for (const Node& item : root.at("figures").list())
    plots.figures.push_back(figure_of(item));
  for (const Node& item : root.list_or_empty("pages"))
    plots.pages.push_back(page_of(item));
  for (const Node& item : root.list_or_empty("films"))
    plots.films.push_back(film_of(item));
  for (const Node& item : root.list_or_empty("players"))
    plots.players.push_back(player_of(item));
  if (plots.figures.empty() && plots.pages.empty() && plots.films.empty() && plots.players.empty()) {
    root.at("figures").complain("must hold at least one figure");
  }
  demand_distinct_names(root, "figures", plots.figures);
  demand_distinct_names(root, "pages", plots.pages);
  return plots;
}

long long epoch_seconds(const std::string& iso_date) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hour = 0;
  int minute = 0;
  int second = 0;
  const int count =
      std::sscanf(iso_date.c_str(), "%4d-%2u-%2u%*[T ]%2d:%2d:%2d", &year, &month, &day, &hour, &minute, &second);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  const bool time_is_fine = hour >= 0 && hour < 24 && minute >= 0 && minute < 60 && second >= 0 && second < 61;
  if ((count != 3 && count != 6) || !date.ok() || !time_is_fine) {
    throw RecordError(fmt::format("'{}' is not a date such as 2026-03-01T12:00:00Z", iso_date));
  }
  const long long days = std::chrono::sys_days(date).time_since_epoch().count();
  return days * 86400 + hour * 3600 + minute * 60 + second;
}

}  // namespace talus::reports
