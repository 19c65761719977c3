#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "solver/advise/method_advice.hpp"
#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/command_line/completion.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/output/write_advice.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/io/scene/write_method.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct AdviseOptions {
  std::string scene;
  std::string of;
  std::string out;
  bool json{false};
  AdviceRules rules;
};

/// A method with its tolerance and step, as text.
std::string text_of(const RunMethod& method, double duration, const UnitSystem& units) {
  return fmt::format("{}{}, step {:.6g} {}", method.integrator,
                     method.tolerance == 0.0 ? "" : fmt::format(", tolerance {:.3g}", method.tolerance),
                     duration / static_cast<double>(method.steps), symbol(units, dimension::time));
}

void print_tried(const Advice& advice, double duration, const UnitSystem& units) {
  if (advice.tried.empty()) return;
  fmt::print("  {:<28}{:>11}{:>14}{:>11}{:>13}  {}\n", "method", "tolerance", "step", "error", "evaluations",
             "verdict");
  fmt::print("  {:<28}{:>11}{:>14}{:>11}{:>13}\n", "", "1", symbol(units, dimension::time), "1", "1");
  for (const TriedMethod& tried : advice.tried) {
    const RunMethod& method = tried.method;
    const bool ran = tried.evaluations > 0;
    fmt::print("  {:<28}{:>11}{:>14}{:>11}{:>13}  {}\n", method.integrator,
               method.tolerance == 0.0 ? "-" : fmt::format("{:.2e}", method.tolerance),
               ran ? fmt::format("{:.6g}", duration / static_cast<double>(method.steps)) : "-",
               !ran                         ? "-"
               : std::isfinite(tried.error) ? fmt::format("{:.1e}", tried.error)
                                            : "failed",
               ran ? fmt::format("{}", tried.evaluations) : "-", tried.verdict.empty() ? "good" : tried.verdict);
  }
}

void print_text(const Scene& scene, const Quantity& quantity, const AdviceRules& rules, const Advice& advice) {
  const UnitSystem& units = scene.model.units;
  const double duration = scene.plan.end - scene.initial.t;
  fmt::print("{}: {} to {:.3g}\n", scene.title, quantity.name, rules.accuracy);
  const Reference& value = advice.reference;
  if (!value.other.empty()) {
    fmt::print("value {:.10g} {}, upon which {} and {} agree to {:.1e}\n", value.value,
               symbol(units, quantity.dimension), value.method.integrator, value.other, value.spread);
  }
  if (advice.growth.result > 0.0) {
    fmt::print("differences of {:.0e} in the start grow to {:.0e} of it\n", advice.growth.fraction,
               advice.growth.result);
  }
  print_tried(advice, duration, units);
  fmt::print("pilots: {} force evaluations\n", advice.evaluations);
  if (advice.refusal) {
    fmt::print("no advice ({}): {}\n", name_of(advice.refusal->kind), advice.refusal->message);
  } else {
    fmt::print("advice: {}: error {:.1e} with {} force evaluations\n", text_of(advice.best->method, duration, units),
               advice.best->error, advice.best->evaluations);
  }
}

/// File for the advised scene: --out, or NAME.advised.toml beside the scene. It is checked before the pilot runs, so
/// that an error does not waste them.
fs::path target(const AdviseOptions& options) {
  const fs::path scene{options.scene};
  const fs::path file =
      options.out.empty() ? scene.parent_path() / (scene.stem().string() + ".advised.toml") : fs::path{options.out};
  if (file.extension() != ".toml")
    throw InputError{fmt::format("--out: found \"{}\"; it must be a scene file, .toml", file.string())};
  if (!file.parent_path().empty() && !fs::is_directory(file.parent_path()))
    throw IoError{fmt::format("{}: its folder does not exist", file.string())};
  return file;
}

/// The scene for which the limit of short steps is sought: a fence without the initial half kick of 1993, which depends
/// on the step.
SceneFile without_half_kick(SceneFile file) {
  if (!file.fence || file.fence->fence.options.start == scenes::FenceStart::plain) return file;
  scenes::Fence fence = file.fence->fence;
  fence.options.start = scenes::FenceStart::plain;
  const scenes::FenceScene made = scenes::fence_scene(fence);
  return {made.scene, FenceInput{std::move(fence), made}};
}

int advise(AdviseOptions& options) {
  const fs::path out = target(options);
  const std::string text = read_text(options.scene);
  const SceneFile file = without_half_kick(read_scene_text(text, options.scene));
  const Quantity quantity = [&] {
    try {
      return quantity_named(file.scene.model, options.of);
    } catch (const InputError& error) {
      throw InputError{fmt::format("--of: {}", error.what())};
    }
  }();
  std::optional<Progress> progress{std::in_place};
  options.rules.progress = [&](long evaluations) {
    if (progress->due())
      progress->show(fmt::format("pilots: {} of at most {} force evaluations", evaluations, options.rules.evaluations));
  };
  const Advice advice = advise_method(file.scene, quantity, options.rules);
  progress.reset();
  const double duration = file.scene.plan.end - file.scene.initial.t;
  if (advice.best) {
    const std::string comment = fmt::format(
        "talus advise: {} to {:.3g}: {}: error {:.1e} with {} force evaluations", quantity.name, options.rules.accuracy,
        text_of(advice.best->method, duration, file.scene.model.units), advice.best->error, advice.best->evaluations);
    write_whole(out, text_with_method(file, text, options.scene, advice.best->method, comment));
  }
  if (options.json) {
    fmt::print("{}\n", advice_json(file.scene, quantity, options.rules, advice).dump(2));
  } else {
    print_text(file.scene, quantity, options.rules, advice);
    if (advice.best) fmt::print("written: {}\n", out.string());
  }
  return advice.best ? ok : refused;
}

}  // namespace

Command add_advise(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("advise", "Find the cheapest integrator and step that reach an accuracy");
  const auto options = std::make_shared<AdviseOptions>();
  app->add_option("SCENE", options->scene, "scene file (.toml) or deck of 1993 (.DAT)")->required();
  app->add_option("--accuracy", options->rules.accuracy, "relative error that is allowed, in [1e-10, 0.5]")->required();
  app->add_option("--of", options->of,
                  "a column of the history and max, min, abs_max or end, e.g. cable.top.tension.max, rock.vx.end, "
                  "energy.kinetic.max")
      ->required();
  app->add_option("--out", options->out, "the scene with the advice; default: SCENE's name with .advised.toml");
  offer(app->add_option("--among", options->rules.among, "integrators to choose from; default: all")->delimiter(','),
        integrator_names());
  app->add_option("--evaluations", options->rules.evaluations,
                  "force evaluations that the pilots may take in all; default 2000000: of a fence of ten bodies some "
                  "ten seconds");
  app->add_flag(
      "--allow-warnings", options->rules.allows_warnings,
      "advise methods whose runs are warned of, too: steps beyond a linear limit, fewer than 10 in a contact, an "
      "energy balance that is off by more than 1 %");
  app->add_flag("--json", options->json, "print JSON, in SI units");
  app->footer(
      "Examples:\n"
      "  talus advise cases/cable_pendulum.toml --accuracy 1e-3 --of cable.cable.tension.max --out advised.toml\n"
      "  talus advise cases/fence/table_2.toml --accuracy 1e-2 --of rock.vx.end --out advised.toml\n"
      "The error is that of the number that `talus run` prints. Its extremes are those over the steps, so for an\n"
      "extreme the step is short enough to resolve it. If no step can give the accuracy (chaos, stiffness, a quantity\n"
      "that is zero or does not converge), nothing is written, the reason is printed, and the exit status is 5.");
  return {app, [options] { return advise(*options); }};
}

}  // namespace talus::app
