#include "verification/record/plots.hpp"

#include "verification/record/figure_fields.hpp"

namespace talus::records {
namespace {

struct Plots {
  std::vector<Figure> figures{};
};

void fields(auto& f, Like<Plots> auto& plots) {
  f.derived("schema", 1);
  f.value("figures", plots.figures);
}

void demand_sound(const Node& node, const Plots& plots) {
  if (plots.figures.empty()) node.at("figures").fail("must hold at least one figure");
  demand_distinct_names(node, "figures", plots.figures);
}

}  // namespace

std::vector<Figure> read_plots(const std::filesystem::path& file) {
  const Json document = read_json(file);
  Plots plots;
  read_into(Node{document, file.string() + ": plot"}, plots, Completeness::sparse);
  return std::move(plots.figures);
}

}  // namespace talus::records
