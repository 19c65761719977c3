#include "solver/io/output/write_geometry.hpp"

#include <unistd.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "solver/base/error.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "tests/solver/io/fence_run.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(write_geometry_tests)

using namespace talus;
namespace fs = std::filesystem;
using boost::property_tree::ptree;

namespace {

ptree parsed(const fs::path& file) {
  ptree tree;
  boost::property_tree::read_xml(file.string(), tree);
  return tree;
}

/// The arrays of a VTP piece, as "section.name".
std::map<std::string, std::vector<double>> arrays(const ptree& piece) {
  std::map<std::string, std::vector<double>> found;
  for (const char* section : {"PointData", "CellData", "Points", "Lines"}) {
    for (const auto& [tag, array] : piece.get_child(section)) {
      if (tag != "DataArray") continue;
      std::istringstream in{array.data()};
      auto& values = found[std::string{section} + "." + array.get<std::string>("<xmlattr>.Name")];
      for (double value; in >> value;)
        values.push_back(value);
    }
  }
  return found;
}

FenceInput sample() {
  scenes::Fence fence = read_deck(fs::path{TALUS_CASES} / "fence/sample2.DAT");
  scenes::FenceScene made = scenes::fence_scene(fence);
  return {std::move(fence), std::move(made)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_index_names_every_file_with_its_time) {
  const Folder folder;
  const FenceInput input = sample();
  const Dynamics dynamics{input.made.scene.model};
  VtpSeries series{dynamics, folder.path, "a & \"b\"", 20};
  run_fence(input, dynamics, 50, std::ref(series));
  series.write_index();
  const ptree index = parsed(folder.path / "a & \"b\".pvd");
  BOOST_TEST(index.get<std::string>("VTKFile.<xmlattr>.type") == "Collection");
  std::vector<double> times;
  for (const auto& [tag, set] : index.get_child("VTKFile.Collection")) {
    times.push_back(set.get<double>("<xmlattr>.timestep"));
    BOOST_TEST(fs::exists(folder.path / set.get<std::string>("<xmlattr>.file")));
  }
  const double h = input.made.scene.plan.step;
  BOOST_TEST(times == (std::vector<double>{0.0, 20 * h, 40 * h, 50 * h}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_file_holds_outlines_and_cables) {
  const Folder folder;
  const FenceInput input = sample();
  const Model& model = input.made.scene.model;
  const Dynamics dynamics{model};
  VtpSeries series{dynamics, folder.path, "s", 60};
  State seen;
  run_fence(input, dynamics, 60, [&](const Snapshot& snapshot, const StepInfo& info) {
    series(snapshot, info);
    seen = snapshot.state();
  });
  const ptree tree = parsed(folder.path / "s_geometry/s_00000060.vtp");
  BOOST_TEST(tree.get<std::string>("VTKFile.<xmlattr>.type") == "PolyData");
  const ptree& piece = tree.get_child("VTKFile.PolyData.Piece");
  const auto data = arrays(piece);
  const auto points = piece.get<std::size_t>("<xmlattr>.NumberOfPoints");
  const auto lines = piece.get<std::size_t>("<xmlattr>.NumberOfLines");
  BOOST_TEST(lines == model.bodies.size() + model.cables.size());
  BOOST_TEST(data.at("Points.Points").size() == 3 * points);
  BOOST_TEST(data.at("Lines.connectivity").size() == points);
  BOOST_TEST(data.at("Lines.offsets").back() == static_cast<double>(points));
  BOOST_TEST(data.at("PointData.body").size() == points);
  for (const char* name : {"CellData.body", "CellData.cable", "CellData.tension", "CellData.slack", "Lines.offsets"})
    BOOST_TEST(data.at(name).size() == lines);

  // The rock's outline is a circle of its radius about its position at that time.
  const Pose rock = pose(model, seen, *find_body(model, "rock"));
  const auto& xyz = data.at("Points.Points");
  const auto& bodies = data.at("PointData.body");
  int of_rock = 0;
  for (std::size_t i = 0; i < points; ++i) {
    if (bodies[i] != static_cast<double>(index(*find_body(model, "rock")))) continue;
    ++of_rock;
    BOOST_TEST(std::abs(std::hypot(xyz[3 * i] - rock.p_WB.x, xyz[3 * i + 1] - rock.p_WB.y) - 1.201) < 1e-12);
    BOOST_TEST(xyz[3 * i + 2] == 0.0);
  }
  BOOST_TEST(of_rock == 97);

  // A cable's tension is k times the excess of its drawn length over its rest length.
  for (std::size_t line = model.bodies.size(); line < lines; ++line) {
    const auto cable = static_cast<std::size_t>(data.at("CellData.cable")[line]);
    const auto end = static_cast<std::size_t>(data.at("Lines.offsets")[line]);
    const double* a = &xyz[3 * (end - 2)];
    const double* b = &xyz[3 * (end - 1)];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const auto& law = std::get<ElasticPlastic>(model.cables[cable].law);
    const double expected = std::max(0.0, law.stiffness * (length - model.cables[cable].rest_length));
    BOOST_TEST(std::abs(data.at("CellData.tension")[line] - expected) < 1e-12 * law.stiffness * length);
    BOOST_TEST((data.at("CellData.slack")[line] == 1.0) == (expected == 0.0));
  }
}

BOOST_AUTO_TEST_CASE(an_index_of_before_does_not_stay) {
  const Folder folder;
  const FenceInput input = sample();
  const Dynamics dynamics{input.made.scene.model};
  { VtpSeries{dynamics, folder.path, "s", 60}.write_index(); }
  BOOST_TEST(fs::exists(folder.path / "s.pvd"));
  const VtpSeries again{dynamics, folder.path, "s", 60};
  BOOST_TEST(!fs::exists(folder.path / "s.pvd"));
  BOOST_CHECK_THROW((VtpSeries{dynamics, "/dev/null/no", "s", 60}), IoError);
}

BOOST_AUTO_TEST_SUITE_END()
