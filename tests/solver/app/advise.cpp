#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/io/read_scene_file.hpp"
#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(advise_tests)

// `talus advise` from end to end.

namespace {

Ended advised(const std::string& scene_file, const std::string& accuracy, const std::string& quantity,
              const std::string& out, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"advise", scene_file, "--accuracy", accuracy, "--of", quantity, "--out", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return talus_ran(arguments);
}

nlohmann::json summary_of(const std::string& scene_file, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"run", scene_file, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Ended ended = talus_ran(arguments);
  BOOST_TEST(ended.code == 0);
  return nlohmann::json::parse(ended.out);
}

double largest(const nlohmann::json& summary, const std::string& column) {
  for (const auto& item : summary.at("extremes")) {
    if (item.at("name") == column) return item.at("maximum");
  }
  BOOST_TEST_REQUIRE(false);
  return 0.0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_advised_scene_keeps_the_promise_at_the_cost_that_was_said) {
  const Folder folder;
  const std::string out = (folder.path / "advised.toml").string();
  const Ended ended = advised(scene("two_cable.toml"), "1e-3", "body.particle.x.max", out, {"--json"});
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err.empty());
  const auto printed = nlohmann::json::parse(ended.out);
  const auto summary = summary_of(out);
  BOOST_TEST(summary.at("evaluations") == printed.at("advice").at("evaluations"));
  BOOST_TEST(summary.at("integrator") == printed.at("advice").at("integrator"));
  // Reference by a method that is not advised, at a step of a thousandth of the contact time.
  const auto fine = summary_of(scene("two_cable.toml"), {"--integrator", "rk4", "--step", "40 us"});
  BOOST_TEST(std::abs(largest(summary, "particle.x") / largest(fine, "particle.x") - 1.0) < 1e-3);
}

BOOST_AUTO_TEST_CASE(comments_and_order_of_a_scene_stay) {
  const Folder folder;
  const std::string out = (folder.path / "advised.toml").string();
  BOOST_TEST(advised(scene("pendulum.toml"), "1e-3", "rod.spin.end", out, {"--among", "velocity_verlet"}).code == 0);
  const std::string before = talus::read_text(scene("pendulum.toml")), after = talus::read_text(out);
  const std::size_t run = before.find("[run]");
  BOOST_TEST(after.substr(0, run) == before.substr(0, run));
  const std::string changed = after.substr(run);
  BOOST_TEST(holds(changed, "[run]\nintegrator = \"velocity_verlet\"\nstep = \""));
  BOOST_TEST(!holds(changed, "tolerance = "));
  BOOST_TEST(holds(changed, " s\"\nend = \"10 s\"\n# talus advise: rod.spin.end to 0.001: velocity_verlet, step "));
}

// A history has at most one row a step, and a scene with more is refused.
BOOST_AUTO_TEST_CASE(an_interval_shorter_than_the_advised_step_becomes_the_step) {
  const Folder folder;
  const std::string out = (folder.path / "advised.toml").string(), text = talus::read_text(scene("pendulum.toml"));
  const std::string file =
      folder
          .file("often.toml", text.substr(0, text.find("[run]")) +
                                  "[run]\nintegrator = \"velocity_verlet\"\nstep = \"1 us\"\nend = \"1 s\"\n"
                                  "interval = \"2 us\"\n")
          .string();
  BOOST_TEST(advised(file, "1e-3", "rod.spin.end", out, {"--among", "velocity_verlet"}).code == 0);
  const talus::Scene after = talus::read_scene(fs::path{out});
  BOOST_TEST(after.plan.step > 1e-5);
  BOOST_TEST(after.plan.interval == after.plan.step);
}

BOOST_AUTO_TEST_CASE(a_deck_is_advised_as_a_scene_with_the_same_end) {
  const Folder folder;
  const std::string out = (folder.path / "advised.toml").string();
  const Ended ended = advised(scene("fence/table_2.DAT"), "0.05", "rock.vx.end", out);
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(holds(ended.out, "\nadvice: "));
  const talus::Scene before = talus::read_scene(fs::path{scene("fence/table_2.DAT")});
  const talus::Scene after = talus::read_scene(fs::path{out});
  BOOST_TEST(after.plan.end == before.plan.end, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(talus::name(after.integrator) != talus::name(before.integrator));
}

// Advised scenes never cause a warning of a run: a step beyond a linear limit, few steps in a contact, a failed energy
// balance. Three discs that lean on each other on an incline once got 1.7 steps in a contact.
BOOST_AUTO_TEST_CASE(every_advised_scene_runs_without_a_warning) {
  const auto disc = [](const char* name, double x, double y) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"free\"\nmass = \"2 kg\"\ninertia = \"0.01 kg m^2\"\n"
        "position = [\"{} m\", \"{} m\"]\nshape = {{ kind = \"circle\", radius = \"0.1 m\" }}\n",
        name, x, y);
  };
  const auto contact = [](const char* a, const char* b, const char* friction) {
    return fmt::format(
        "[[contact]]\nname = \"{0}-{1}\"\nbetween = [\"{0}\", \"{1}\"]\nlaw = \"linear_spring_dashpot\"\n"
        "stiffness = \"1e6 N/m\"\nrestitution = 0.5\n{2}",
        a, b, friction);
  };
  const Folder folder;
  const std::string discs =
      folder
          .file("discs.toml",
                "title = \"Three discs on an incline\"\nunits = \"SI\"\ngravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n"
                "[[body]]\nname = \"plane\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\n"
                "angle = \"-20 deg\"\nshape = { kind = \"half_plane\" }\n" +
                    disc("d1", 0.0342020, 0.0939693) + disc("d2", 0.316110, -0.0086375) +
                    disc("d3", 0.598018, -0.1112443) + contact("plane", "d1", "friction = 0.4\n") +
                    contact("plane", "d2", "friction = 0.4\n") + contact("plane", "d3", "friction = 0.05\n") +
                    contact("d1", "d2", "") + contact("d2", "d3", "") +
                    "[run]\nintegrator = \"velocity_verlet\"\nstep = \"10 us\"\nend = \"1 s\"\n")
          .string();
  struct Request {
    std::string file, quantity, accuracy, among;
  };
  const std::vector<Request> requests{{discs, "d3.x.end", "1e-2", "velocity_verlet"},
                                      {discs, "d3.x.end", "0.1", "velocity_verlet"},
                                      {discs, "d3.x.end", "1e-3", ""},
                                      {scene("two_cable.toml"), "particle.x.max", "0.1", "velocity_verlet"},
                                      {scene("two_cable.toml"), "cable.upper.tension.max", "1e-2", "rk4"},
                                      {scene("damped_disc.toml"), "contact.bounce.force.max", "0.1", "velocity_verlet"},
                                      {scene("pendulum.toml"), "rod.spin.end", "0.1", "velocity_verlet"},
                                      {scene("pivoted_cylinder.toml"), "column.spin.end", "0.05", "velocity_verlet"},
                                      {scene("rolling_disc.toml"), "disc.x.end", "1e-2", "velocity_verlet"},
                                      {scene("sliding_block.toml"), "block.x.end", "1e-2", ""}};
  for (const Request& request : requests) {
    const std::string out = (folder.path / "advised.toml").string();
    std::vector<std::string> more;
    if (!request.among.empty()) more = {"--among", request.among};
    const Ended ended = advised(request.file, request.accuracy, request.quantity, out, more);
    BOOST_TEST_CONTEXT(request.file << " " << request.quantity << " " << request.accuracy) {
      BOOST_TEST(ended.code == 0, ended.out << ended.err);
      if (ended.code != 0) continue;
      const Ended run = talus_ran({"run", out});
      BOOST_TEST(run.code == 0);
      BOOST_TEST(run.err.empty(), run.err);
      BOOST_TEST(holds(run.out, "usable"), run.out);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_refusal_has_its_own_exit_code_and_leaves_no_file) {
  const Folder folder;
  const std::string out = (folder.path / "advised.toml").string();
  const Ended zero = advised(scene("two_cable.toml"), "1e-3", "particle.y.max", out);
  BOOST_TEST(zero.code == 5);
  BOOST_TEST(zero.err.empty());
  BOOST_TEST(holds(zero.out, "\nno advice (vanishing): particle.y.max is 0e+00, less than 1e-09 of the largest"));
  const Ended dear = advised(scene("two_cable.toml"), "1e-3", "particle.x.max", out, {"--evaluations", "100"});
  BOOST_TEST(dear.code == 5);
  BOOST_TEST(holds(dear.out, "\nno advice (stiff): "));
  // The smallest error of a single run may be below the bound, which nine consecutive runs must keep.
  const Ended given = advised(scene("pendulum.toml"), "1e-3", "rod.spin.end", out,
                              {"--among", "euler_cromer,exact", "--evaluations", "60000"});
  BOOST_TEST(given.code == 5);
  BOOST_TEST(holds(given.out,
                   "\nno advice (unreached): no given integrator (euler_cromer, exact) has errors below 0.0005 in 9 "
                   "consecutive runs within 60000 force evaluations; the smallest error of a single run is "),
             given.out);
  const Ended unsettled =
      advised(scene("two_cable.toml"), "1e-3", "particle.x.max", out, {"--among", "rk4", "--evaluations", "300000"});
  BOOST_TEST(unsettled.code == 5);
  BOOST_TEST(holds(unsettled.out, "\nno advice (unsettled): no reference value within 300000 force evaluations: "),
             unsettled.out);
  BOOST_TEST(holds(unsettled.out, "all integrators are run for this, not only the given ones\n"), unsettled.out);
  BOOST_TEST(folder.files() == 0);
}

BOOST_AUTO_TEST_CASE(wrong_requests_are_refused_before_any_pilot) {
  const Folder folder;
  const std::string out = (folder.path / "advised.toml").string();
  const std::string file = scene("two_cable.toml");
  const auto says = [&](const Ended& ended, int code, const std::string& expected) {
    BOOST_TEST(ended.code == code);
    BOOST_TEST(holds(ended.err, expected));
    BOOST_TEST(ended.out.empty());
  };
  says(advised(file, "1e-3", "cable.upper.tensoin.max", out), 2,
       "--of: column 'cable.upper.tensoin' is not known; nearest: cable.upper.tension; known: body.particle.x, ");
  says(advised(file, "1e-3", "cable.upper.tension.most", out), 2, "--of: reduction 'most' is not known; nearest: ");
  says(advised(file, "0", "cable.upper.tension.max", out), 2, "accuracy: found 0; it must be in [1e-10, 0.5]");
  says(advised(file, "1e-3", "cable.upper.tension.max", out, {"--among", "rk5"}), 2,
       "among: integrator 'rk5' is not known");
  says(advised(file, "1e-3", "cable.upper.tension.max", (folder.path / "a.DAT").string()), 2,
       "it must be a scene file");
  says(advised(file, "1e-3", "cable.upper.tension.max", (folder.path / "no/a.toml").string()), 4, "does not exist");
  BOOST_TEST(folder.files() == 0);
}

BOOST_AUTO_TEST_CASE(a_run_written_in_one_line_is_changed_where_it_stands) {
  const Folder folder;
  const std::string text = talus::read_text(scene("pendulum.toml"));
  const std::string head = text.substr(0, text.find("[run]"));
  const std::string out = (folder.path / "advised.toml").string();
  const auto rewritten = [&](const std::string& run, const std::string& method) {
    const std::size_t body = head.find("# Half");
    const fs::path file = folder.file("scene.toml", head.substr(0, body) + run + head.substr(body));
    BOOST_TEST(advised(file.string(), "1e-3", "rod.spin.end", out, {"--among", method}).code == 0);
    return talus::read_text(out);
  };
  const std::string in_line = "run = { integrator = \"rk4\", step = \"10 ms\", end = \"10 s\" } # äöü\n";
  BOOST_TEST(holds(rewritten(in_line, "stormer_cowell"), "\nrun = { integrator = \"stormer_cowell\", tolerance = "));
  const std::string controlled =
      "run = { integrator = \"odeint_dopri5\", tolerance = 1e-3, step = \"10 ms\", end = \"10 s\" }\n";
  BOOST_TEST(holds(rewritten(controlled, "rk4"), "\nrun = { integrator = \"rk4\", step = \""));
  const std::string dotted = "run.integrator = \"rk4\" # ä\n  run.step = \"10 ms\"\nrun.end = \"10 s\"\n";
  BOOST_TEST(holds(rewritten(dotted, "stormer_cowell"), "\nrun.integrator = \"stormer_cowell\" # ä\nrun.tolerance = "));
}

BOOST_AUTO_TEST_SUITE_END()
