#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/mesh_file.h>
#include <shell_origami/origami/report.h>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>

namespace shell_origami {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What a call fails with; empty when it does not.
template <class Call>
std::string failure(Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

void expectWithin(const std::string& sentence, const std::string& part) {
  EXPECT_NE(sentence.find(part), std::string::npos)
      << "'" << sentence << "' lacks '" << part << "'";
}

class Report : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("report_test." + std::to_string(getpid()));
    fs::create_directories(folder_);
    FoldEdit fold{Segment{Vector2(0.05, 0), Vector2(0.05, 0.1)}, 0.5, 0.05, std::nullopt, "spine"};
    simulation_.fold(fold);
    for (int i = 0; i < 6; ++i) ASSERT_TRUE(simulation_.step().converged);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t filesInFolder() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
  Simulation simulation_{Sheet(triangulateRectangle(0.1, 0.1, 0.02)), SimulationConfig()};
};

TEST_F(Report, holdsTheFiguresOfTheRun) {
  const json report = makeReport(simulation_, {"half", 1.5});
  EXPECT_EQ(report["recipe"], "half");
  EXPECT_EQ(report["triangles"], simulation_.sheet().triangles().size());
  EXPECT_EQ(report["vertices"], simulation_.sheet().vertexCount());
  EXPECT_NEAR(report["sim_time"], 0.1, 1e-12);
  EXPECT_EQ(report["wall_time"], 1.5);
  EXPECT_GT(report["solver_time"], 0);
  EXPECT_EQ(report["steps"], 6);
  EXPECT_EQ(report["newton_iterations"], simulation_.counters().newton_iterations);
  EXPECT_EQ(report["factorizations"], simulation_.counters().factorizations);
  EXPECT_GT(report["newton_iterations"], 0);
  EXPECT_EQ(report["max_strain"], simulation_.maxStrain());
  EXPECT_EQ(report["in_plane_set"]["mean"], 0);
  EXPECT_EQ(report["in_plane_set"]["worst"], 0);
  EXPECT_EQ(report["kinetic_energy"], simulation_.energies().kinetic);
  EXPECT_EQ(report["settled"], simulation_.settled());
  EXPECT_EQ(report["min_gap"], -1);
  EXPECT_EQ(report["contacts"], 0);
  EXPECT_EQ(report["intersections"], 0);
  ASSERT_EQ(report["creases"].size(), 1u);
  const json& crease = report["creases"][0];
  EXPECT_EQ(crease["name"], "spine");
  EXPECT_EQ(crease["id"], simulation_.sheet().creases()[0].id);
  EXPECT_NEAR(crease["target_deg"], 0.5 * 180 / M_PI, 1e-9);
  EXPECT_NEAR(crease["angle_deg_mean"], simulation_.creases()[0].angle * 180 / M_PI, 1e-9);
  EXPECT_LE(crease["angle_deg_min"], crease["angle_deg_mean"]);
  EXPECT_GE(crease["angle_deg_max"], crease["angle_deg_mean"]);
}

TEST_F(Report, staysJsonWhateverHappens) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  writeResults(simulation_, {"a \xff \"name\"\n", nan}, in("odd"));
  const json report = json::parse(contents(in("odd/report.json")));
  EXPECT_TRUE(report["wall_time"].is_null());
}

TEST_F(Report, foldFilesAreReadBack) {
  savePaper(simulation_, in("paper.fold"));
  const FoldPaper paper = readFold(in("paper.fold"));
  EXPECT_EQ(paper.sheet.flatPositions(), simulation_.sheet().flatPositions());
  EXPECT_EQ(paper.sheet.triangles(), simulation_.sheet().triangles());
  EXPECT_EQ(paper.sheet.creases()[0].name, "spine");
  ASSERT_TRUE(paper.positions);
  EXPECT_EQ(*paper.positions, simulation_.positions());
  EXPECT_NEAR(paper.rest_angles[0], simulation_.creases()[0].rest_angle, 1e-14);
  EXPECT_EQ(json::parse(contents(in("paper.fold")))["file_title"], "paper");
}

TEST_F(Report, foldFilesAreReadBackFoldedOnAFinerMesh) {
  savePaper(simulation_, in("paper.fold"));
  json document = json::parse(contents(in("paper.fold")));
  document.erase("shell_origami:creases");  // so that the crease's angle is measured
  std::ofstream(in("finer.fold")) << document;
  const FoldPaper paper = readFold(in("finer.fold"), {0, 0.004});
  ASSERT_TRUE(paper.positions);
  EXPECT_GT(paper.sheet.vertexCount(), 2 * simulation_.sheet().vertexCount());
  EXPECT_NEAR(paper.rest_angles[0], simulation_.creases()[0].angle, 1e-3);
  const Simulation finer(paper.sheet, SimulationConfig(), *paper.positions, paper.rest_angles);
  EXPECT_LT(finer.energies().membrane, 1e-6);
}

TEST_F(Report, aFreeCreaseStaysFree) {
  const Sheet folded = simulation_.sheet();
  const Simulation free(folded, SimulationConfig(), simulation_.positions(),
                        {std::numeric_limits<double>::quiet_NaN()});
  savePaper(free, in("free.fold"));
  EXPECT_TRUE(std::isnan(readFold(in("free.fold")).rest_angles[0]));
  EXPECT_TRUE(makeReport(free, {})["creases"][0]["target_deg"].is_null());
}

TEST_F(Report, objHoldsEveryPointAndFace) {
  savePaper(simulation_, in("paper.OBJ"));
  std::istringstream lines(contents(in("paper.OBJ")));
  int vertices = 0;
  std::size_t faces = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      Vector3 p;
      words >> p.x() >> p.y() >> p.z();
      EXPECT_EQ(p, Vector3(simulation_.positions().col(vertices++)));
    } else if (word == "f") {
      Triangle t;
      words >> t[0] >> t[1] >> t[2];
      for (int& v : t) --v;  // OBJ counts from 1
      EXPECT_EQ(t, simulation_.sheet().triangles()[faces++]);
    }
  }
  EXPECT_EQ(vertices, simulation_.sheet().vertexCount());
  EXPECT_EQ(faces, simulation_.sheet().triangles().size());
}

TEST_F(Report, stlIsBinaryAndFacesTheRightWay) {
  savePaper(simulation_, in("paper.stl"));
  const std::string bytes = contents(in("paper.stl"));
  const std::size_t count = simulation_.sheet().triangles().size();
  ASSERT_EQ(bytes.size(), 84 + 50 * count);
  std::uint32_t stated;
  std::memcpy(&stated, bytes.data() + 80, 4);
  EXPECT_EQ(stated, count);
  float normal[3], corner[3];
  std::memcpy(normal, bytes.data() + 84, 12);
  std::memcpy(corner, bytes.data() + 96, 12);
  EXPECT_GT(normal[2], 0.5f);  // the first triangle has hardly turned
  const int v = simulation_.sheet().triangles()[0][0];
  EXPECT_FLOAT_EQ(corner[0], static_cast<float>(simulation_.positions()(0, v)));
}

TEST_F(Report, plyStatesItsCounts) {
  savePaper(simulation_, in("paper.ply"));
  const std::string text = contents(in("paper.ply"));
  expectWithin(text, "ply\nformat ascii 1.0\n");
  expectWithin(text, "element vertex " + std::to_string(simulation_.sheet().vertexCount()) + "\n");
  const std::size_t faces = simulation_.sheet().triangles().size();
  expectWithin(text, "element face " + std::to_string(faces) + "\n");
  const auto lines = std::count(text.begin(), text.end(), '\n');
  EXPECT_EQ(lines, 10 + simulation_.sheet().vertexCount() + static_cast<int>(faces));
}

TEST_F(Report, resultsGoIntoAFolderThatIsMade) {
  writeResults(simulation_, {"half", 1}, in("out/half"));
  for (const char* name : {"final.fold", "final.obj", "report.json"}) {
    EXPECT_TRUE(fs::exists(folder_ / "out/half" / name)) << name;
  }
  EXPECT_EQ(json::parse(contents(in("out/half/report.json")))["recipe"], "half");
}

TEST_F(Report, refusesOtherExtensions) {
  for (const char* name : {"paper.txt", "paper", "paper.fold.bak"}) {
    EXPECT_THROW(savePaper(simulation_, in(name)), std::invalid_argument) << name;
  }
  expectWithin(failure([&] { savePaper(simulation_, "x.txt"); }), "cannot save x.txt");
  EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Report, namesPathAndReasonWhenItCannotWrite) {
  const std::string missing = in("nowhere/paper.obj");
  EXPECT_THROW(savePaper(simulation_, missing), std::runtime_error);
  EXPECT_EQ(failure([&] { savePaper(simulation_, missing); }),
            "cannot write " + missing + ": No such file or directory");
  fs::create_directory(in("folder.obj"));
  expectWithin(failure([&] { savePaper(simulation_, in("folder.obj")); }), "not a regular file");
  expectWithin(failure([&] { writeFiles({{"/dev/null", ""}}); }), "not a regular file");
  writeFiles({{in("file"), ""}});
  expectWithin(failure([&] { writeResults(simulation_, {}, in("file/results")); }),
               "cannot write " + in("file/results") + ": Not a directory");
}

TEST_F(Report, aFullDiskLeavesTheOldFile) {
  writeFiles({{in("paper.obj"), "old"}});
  // A limit on file sizes fails like a full disk does, once its signal is ignored.
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit;
  getrlimit(RLIMIT_FSIZE, &old_limit);
  rlimit limit = old_limit;
  limit.rlim_cur = 100;
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string sentence = failure([&] { savePaper(simulation_, in("paper.obj")); });
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(sentence, "cannot write " + in("paper.obj") + ": File too large");
  EXPECT_EQ(contents(in("paper.obj")), "old");
  EXPECT_EQ(filesInFolder(), 1u);  // nothing half-written beside it
}

TEST_F(Report, resultsThatCannotAllBeWrittenLeaveTheOldOnes) {
  writeFiles({{in("final.fold"), "old"}, {in("final.obj"), "old"}});
  fs::create_directory(in("report.json"));
  expectWithin(failure([&] { writeResults(simulation_, {"half", 1}, in("")); }), "report.json");
  EXPECT_EQ(contents(in("final.fold")), "old");
  EXPECT_EQ(contents(in("final.obj")), "old");
  EXPECT_EQ(filesInFolder(), 3u);  // nothing half-written beside them
}

TEST_F(Report, replacesAFileButKeepsALink) {
  writeFiles({{in("paper.obj"), "old"}});
  fs::create_symlink("paper.obj", in("link.obj"));
  savePaper(simulation_, in("link.obj"));
  EXPECT_TRUE(fs::is_symlink(in("link.obj")));
  expectWithin(contents(in("paper.obj")), "\nf ");
  EXPECT_EQ(filesInFolder(), 2u);
}

}  // namespace
}  // namespace shell_origami
