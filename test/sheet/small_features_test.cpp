/// Edits that would leave features too small to simulate.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15, kMaxEdge = 0.01;

Simulation square() { return {Sheet(triangulateRectangle(kSide, kSide, kMaxEdge)), {}}; }

FoldEdit along(double x0, double y0, double x1, double y1) {
  FoldEdit fold;
  fold.where = Segment{Vector2(x0, y0), Vector2(x1, y1)};
  fold.angle = 1;
  return fold;
}

template <class Edit>
std::string rejection(Edit edit) {
  try {
    edit();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

void expectWithin(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' lacks '" << part << "'";
}

TEST(SmallFeatures, aVertexTooCloseToAnEndIsRejected) {
  Simulation paper = square();
  const Edge edge = paper.sheet().edges()[100];
  const int a = edge.vertices[0], b = edge.vertices[1];
  for (const double fraction : {1e-12, 1e-9, 1e-6, 0.999999, 0.9999999999999999}) {
    expectWithin(rejection([&] { paper.addVertex(a, b, fraction); }), "the shortest possible is");
  }
  EXPECT_EQ(paper.sheet().revision(), 0u);
  paper.addVertex(a, b, 0.02);
  EXPECT_TRUE(paper.step().converged);
}

TEST(SmallFeatures, halvingsEndBeforeTheSolverDoes) {
  Simulation paper = square();
  const int a = paper.sheet().edges()[100].vertices[0];
  int b = paper.sheet().edges()[100].vertices[1], halvings = 0;
  std::string message;
  for (; message.empty() && halvings < 100; ++halvings) {
    message = rejection([&] { b = paper.addVertex(a, b, 0.5); });
  }
  expectWithin(message, "the shortest possible is");
  EXPECT_GT(halvings, 5);
  EXPECT_LT(halvings, 20);
  EXPECT_TRUE(paper.step().converged);
  FoldEdit fold = along(0, 0.06, kSide, 0.06);
  paper.fold(fold);
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(paper.step().converged) << "step " << i;
}

TEST(SmallFeatures, aLineHardlyOffTheBorderRunsAlongIt) {
  for (const FoldEdit& fold :
       {along(0, 0, kSide, 1e-6), along(0, 1e-5, kSide, 1e-5), along(0.03, 1e-5, 0.11, 2e-5)}) {
    Simulation paper = square();
    const int before = paper.sheet().vertexCount();
    EXPECT_EQ(rejection([&] { paper.fold(fold); }), "the line runs along the border of the paper");
    EXPECT_EQ(paper.sheet().vertexCount(), before);
    EXPECT_TRUE(paper.step().converged);
  }
}

TEST(SmallFeatures, aLineHardlyOffACreaseIsThatCrease) {
  Simulation paper = square();
  const std::uint32_t crease = paper.fold(along(0, 0.06, kSide, 0.06)).crease_ids.at(0);
  const int before = paper.sheet().vertexCount();
  for (const double off : {1e-6, 1e-5, -5e-5}) {
    const EditRecord again = paper.fold(along(0, 0.06 + off, kSide, 0.06));
    EXPECT_EQ(again.crease_ids, std::vector<std::uint32_t>{crease});
  }
  EXPECT_EQ(paper.sheet().vertexCount(), before);
  paper.sheet().validate();
  EXPECT_TRUE(paper.step().converged);
}

TEST(SmallFeatures, linesAtTinyAnglesAreRejectedOrAddABoundedNumberOfVertices) {
  int accepted = 0;
  for (const double off : {1e-4, 2e-4, 5e-4, 1e-3, 2e-3}) {
    Simulation paper = square();
    const int before = paper.sheet().vertexCount();
    for (const FoldEdit& fold : {along(0, 0, kSide, off), along(0, off, kSide, 2 * off)}) {
      const std::string message = rejection([&] { paper.fold(fold); });
      if (message.empty()) ++accepted;
      else expectWithin(message, "the shortest possible is");
    }
    EXPECT_LT(paper.sheet().vertexCount(), 5 * before) << off;
    paper.sheet().validate();
    EXPECT_TRUE(paper.step().converged) << off;
  }
  EXPECT_GE(accepted, 4);
}

}  // namespace
}  // namespace shell_origami
