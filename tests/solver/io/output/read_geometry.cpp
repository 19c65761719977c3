#include "solver/io/output/read_geometry.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "solver/base/error.hpp"
#include "solver/io/cell/write_cell.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/output/read_history.hpp"
#include "solver/io/output/run_folder.hpp"
#include "solver/io/output/write_geometry.hpp"
#include "tests/solver/io/fence_run.hpp"
#include "tests/solver/io/small_cell.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(read_geometry_tests)

// Output files of a run, read back.

using namespace talus;
namespace fs = std::filesystem;

namespace {

template <class Read>
std::string error_message(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

// Positions and tensions compared with the Dynamics from which the series was written; VTP contains every digit.
BOOST_AUTO_TEST_CASE(what_was_written_is_read) {
  const Folder folder;
  const FenceInput input = *read_scene_file(fs::path{TALUS_CASES} / "fence/sample2.DAT").fence;
  const Dynamics dynamics{input.made.scene.model};
  VtpSeries series{dynamics, folder.path, "s", 20};
  std::vector<State> states;
  run_fence(input, dynamics, 40, [&](const Snapshot& snapshot, const StepInfo& info) {
    series(snapshot, info);
    if (info.step % 20 == 0) states.push_back(snapshot.state());
  });
  series.write_index();
  const std::vector<GeometryFile> files = read_geometry_index(folder.path / "s.pvd");
  BOOST_REQUIRE(files.size() == 3U);
  Workspace work = dynamics.workspace();
  LawForces forces;
  double farthest = 0.0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    BOOST_TEST(files[i].time == states[i].t);
    const GeometryFrame frame = read_geometry(files[i]);
    BOOST_TEST(frame.lines.size() == input.made.scene.model.bodies.size() + input.made.scene.model.cables.size());
    dynamics.update(states[i], work);
    dynamics.forces(states[i], work, forces);
    for (const GeometryLine& line : frame.lines) {
      if (line.body >= 0) {
        BOOST_TEST((line.body == 0 || line.points.front() == line.points.back()));
        double along = 0.0;  // of a column: that of its joints
        for (const Joint& joint : dynamics.cables().joints())
          if (joint.on_body && index(joint.body) == static_cast<std::size_t>(line.body)) along = joint.along;
        for (const Vec3& p : line.points)
          BOOST_TEST(p.z == along);
        farthest = std::max(farthest, std::abs(along));
      }
      if (line.cable < 0) continue;
      const auto cable = static_cast<std::size_t>(line.cable);
      const auto& ends = dynamics.cables().ends()[cable];
      BOOST_TEST(line.tension == forces.tensions[cable]);
      BOOST_TEST(line.slack == (forces.tensions[cable] == 0.0));
      BOOST_TEST((in_plane(line.points.front()) == work.joints.p_WP(ends.a)));
      BOOST_TEST((in_plane(line.points.back()) == work.joints.p_WP(ends.b)));
    }
  }
  BOOST_TEST(farthest > 10.0);  // the columns are side by side along the fence
}

BOOST_AUTO_TEST_CASE(damaged_geometry_is_named) {
  const Folder folder;
  const auto index = [&](const std::string& text) {
    return error_message([&] { static_cast<void>(read_geometry_index(folder.file("x.pvd", text))); });
  };
  BOOST_TEST(holds(index("<VTKFile>\n<Coll"), "x.pvd:2: not XML: "));
  BOOST_TEST(holds(index("\n<VTKFile/>"), "x.pvd:2: VTKFile/Collection: it is missing; "));
  BOOST_TEST(holds(index("<VTKFile>\n<Collection/></VTKFile>"),
                   "x.pvd:2: Collection: it names no file: the run wrote no geometry"));
  BOOST_TEST(holds(index("<VTKFile><Collection>\n\n<DataSet timestep=\"now\"/></Collection></VTKFile>"),
                   "x.pvd:3: DataSet: timestep: found \"now\"; it must be a number"));
  const auto piece = [&](const std::string& text) {
    const fs::path file = folder.file("x.vtp", "<VTKFile><PolyData>\n<Piece>" + text + "</Piece></PolyData></VTKFile>");
    return error_message([&] { static_cast<void>(read_geometry({0.0, file})); });
  };
  BOOST_TEST(holds(piece(""), "x.vtp:2: Points: array 'Points': it is missing"));
  BOOST_TEST(holds(piece("<Points>\n<DataArray Name=\"Points\">\n0 1\n a\x1b 2</DataArray></Points>"),
                   "x.vtp:5: Points: array 'Points': found \"a\\x1b\"; it must be a number"));
  BOOST_CHECK_THROW(static_cast<void>(read_geometry({0.0, folder.path / "none.vtp"})), IoError);
}

// A collection names files of its folder only.
BOOST_AUTO_TEST_CASE(a_collection_stays_in_its_folder) {
  const Folder folder;
  const auto read = [&](const std::string& name) {
    const std::string set =
        "<VTKFile><Collection>\n<DataSet timestep=\"0\" file=\"" + name + "\"/></Collection></VTKFile>";
    return read_geometry_index(folder.file("x.pvd", set));
  };
  for (const char* const name : {"../x.vtp", "a/../../x.vtp", "..", "/etc/passwd", "", "a/"}) {
    BOOST_TEST(error_message([&] { static_cast<void>(read(name)); }) ==
               (folder.path / "x.pvd").string() + ":2: DataSet: file: found \"" + name +
                   "\"; it must be a file in the folder of the collection, by a relative path without \"..\"");
  }
  for (const char* const name : {"x.vtp", "x_geometry/x.vtp", "..x.vtp"})
    BOOST_TEST(read(name).front().path == folder.path / name);
}

// A cell's state compared with the run from which it was written, through many states so that some contacts cross the
// border.
BOOST_AUTO_TEST_CASE(discs_are_read_as_they_stood) {
  const Folder folder;
  CellRun run = small_cell_run(4000.0);
  std::size_t contacts = 0, crossing = 0;
  while (!run.finished()) {
    run.advance();
    if (run.steps() % 50 != 0) continue;
    const DiscFrame frame = read_discs({run.discs().t, folder.file("s.vtp", cell_state_vtp(run))});
    const Discs discs = run.discs();
    BOOST_REQUIRE(frame.discs.size() == discs.size());
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const SeenDisc& seen = frame.discs[i];
      BOOST_TEST((seen.p == Vec2{discs.x[i], discs.y[i]} && seen.v == Vec2{discs.vx[i], discs.vy[i]}));
      BOOST_TEST((seen.radius == 0.5 && seen.wall == (i >= run.cell().free_discs())));
    }
    const auto acting = run.acting_contacts();
    BOOST_REQUIRE(frame.contacts.size() == acting.size());
    for (std::size_t k = 0; k < acting.size(); ++k) {
      const SeenContact& seen = frame.contacts[k];
      BOOST_TEST((seen.a == acting[k].a && seen.b == acting[k].b && seen.force == acting[k].force));
      // It may begin in the half step by which contacts are ahead, at its present speed.
      const Vec2 v{discs.vx[seen.b] - discs.vx[seen.a], discs.vy[seen.b] - discs.vy[seen.a]};
      BOOST_TEST(norm(seen.to - seen.from) < 1.0 + 0.5 * run.plan().step * norm(v));
      const double periods = (seen.to.x - discs.x[seen.b]) / run.cell().width();
      BOOST_TEST(std::abs(periods - std::round(periods)) < 1e-12);  // b itself, or an image of it
      ++contacts;
      if (std::round(periods) != 0.0) ++crossing;
    }
  }
  BOOST_TEST(contacts > 100U);
  BOOST_TEST(crossing > 5U);
}

BOOST_AUTO_TEST_CASE(damaged_discs_are_named) {
  const Folder folder;
  CellRun run = small_cell_run(4000.0);
  for (int i = 0; i < 3000; ++i)
    run.advance();
  const std::string good = cell_state_vtp(run);
  const auto wrong = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return error_message([&] { static_cast<void>(read_discs({0.0, folder.file("x.vtp", text)})); });
  };
  BOOST_TEST(holds(wrong("Name=\"id\"", "Name=\"no\""), ": PointData: array 'id': it is missing"));
  BOOST_TEST(holds(wrong("\n0.5 ", "\n"), ": PointData: array 'radius': found "));
  BOOST_TEST(holds(wrong("\n1 2 3 ", "\n2 1 3 "), ": PointData: array 'id': found no disc"));
  const std::size_t lines = good.find("<Lines>");
  const std::size_t first = good.find('\n', good.find("connectivity", lines)) + 1;
  BOOST_TEST(holds(wrong(good.substr(lines, first - lines), good.substr(lines, first - lines) + "9999"),
                   ": Lines: array 'connectivity': line 0 joins no two of its 22 discs"));
}

BOOST_AUTO_TEST_CASE(histories_are_read_with_their_units) {
  const Folder folder;
  const KeptHistory history = read_history(
      folder.file("h.csv", "# left out\ntime [s],element3.top_tension [lbf],n [1],bare\n0,1e3,2,0\n.5,-2,3,0\n"));
  BOOST_REQUIRE(history.columns.size() == 4U);
  BOOST_TEST(history.columns[1].subject() == "element3");
  BOOST_TEST(history.columns[1].quantity() == "top_tension");
  BOOST_TEST(history.columns[1].unit == "lbf");
  BOOST_TEST(history.columns[3].name == "bare");
  BOOST_TEST(history.columns[3].unit == "");
  BOOST_TEST(history.find("time")->values[1] == 0.5);
  BOOST_TEST(history.find("nothing") == nullptr);
  const auto wrong = [&](const std::string& text) {
    return error_message([&] { static_cast<void>(read_history(folder.file("h.csv", text))); });
  };
  BOOST_TEST(holds(wrong("time [s],x [m]\n0,1\n2\n"), "h.csv:3: found 1 cells; the header has 2"));
  BOOST_TEST(
      holds(wrong("time [s],x [m]\n0,one\n"), "h.csv:2: column 'x [m]': found 'one'; it must be a finite number"));
  BOOST_TEST(holds(wrong("# only words\n"), "h.csv: found no header"));
}

BOOST_AUTO_TEST_CASE(what_no_run_left_is_named) {
  const Folder folder;
  const auto wrong = [&](const std::string& text) {
    static_cast<void>(folder.file("plot.json", text));
    return error_message([&] { static_cast<void>(read_run_folder(folder.path)); });
  };
  BOOST_TEST(holds(wrong("{"), "plot.json: it is not a file written by `talus run --out` or `talus cell --out`: "));
  BOOST_TEST(
      holds(wrong("{\"title\": 3}"),
            "plot.json: it is not a file written by `talus run --out` or `talus cell --out`: plot.title: must be a "
            "text, found 3"));
  const std::string outside = "must be a file in the folder of the run, by a path without \"..\", found \"../x\"";
  BOOST_TEST(holds(wrong(R"({"title": "t", "units": "SI", "histories": ["a.csv", "../x"]})"),
                   "plot.histories[1]: " + outside));
  BOOST_TEST(holds(wrong(R"({"title": "t", "units": "SI", "histories": [], "geometry": {"index": "../x"}})"),
                   "plot.geometry.index: " + outside));
  BOOST_TEST(holds(
      wrong(R"({"title": "t", "units": "SI", "histories": [], "geometry": {"index": "g", "cables": [],
                            "bodies": [{"name": "b", "number": 1, "kind": "tree"}]}})"),
      "plot.json: geometry: kind of a body 'tree' is not known; nearest: rock; known: ground, rock, column, body"));
  BOOST_TEST(holds(wrong(R"({"title": "t", "units": null, "histories": [], "geometry": {"index": "g", "period": 0}})"),
                   "plot.json: period: found 0; it must be > 0"));
  BOOST_CHECK_THROW(static_cast<void>(read_run_folder(folder.path / "none")), IoError);
}

BOOST_AUTO_TEST_SUITE_END()
