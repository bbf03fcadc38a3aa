#include <shell_origami/origami/parameter_table.h>
#include <shell_origami/origami/snapshot.h>

#include <gtest/gtest.h>

#include <set>

using namespace shell_origami;

namespace {

std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string errorOf(double value, const Bounds& bounds) {
  return errorOf([&] { checkValue("x", &value, bounds); });
}

}  // namespace

TEST(Parameter, BoundsAreShownAsTheyAre) {
  EXPECT_EQ(kPositive.text(), "> 0");
  EXPECT_EQ(kNotNegative.text(), ">= 0");
  EXPECT_EQ((Bounds{0, 0.49}).text(), "from 0 to 0.49");
  EXPECT_EQ((Bounds{1e-3, 1, false, true}).text(), "0 or from 0.001 to 1");
  EXPECT_EQ((Bounds{1e-9, 1e6}).text(), "from 1e-9 to 1e6");
}

TEST(Parameter, MessagesNameTheValueAndTheBound) {
  EXPECT_EQ(errorOf(-1, kPositive), "x is -1, but must be > 0 and finite");
  EXPECT_EQ(errorOf(HUGE_VAL, kNotNegative), "x is inf, but must be >= 0 and finite");
  EXPECT_EQ(errorOf(HUGE_VAL, {}), "x is inf, but must be finite");
  EXPECT_EQ(errorOf(0.5, {0, 0.49}), "x is 0.5, but must be from 0 to 0.49");
  // Just outside, the value is shown as such.
  EXPECT_EQ(errorOf(1000001, {0, 1e6}), "x is 1000001, but must be from 0 to 1e6");
  Vector3 list(0, 2e4, 0);
  EXPECT_EQ(errorOf([&] {
              checkValue("x", &list, {-1e4, 1e4});
            }),
            "x is [0, 20000, 0], but each of its numbers must be from -10000 to 10000");
}

TEST(Parameter, BoundsContainTheirEndsUnlessOpen) {
  EXPECT_FALSE(kPositive.contain(0));
  EXPECT_TRUE(kPositive.contain(5e-324));
  EXPECT_TRUE(kNotNegative.contain(0));
  const Bounds beta = boundsOf("solver/beta");
  EXPECT_TRUE(beta.contain(0) && beta.contain(1e-3) && beta.contain(1));
  EXPECT_FALSE(beta.contain(1e-4) || beta.contain(-1e-4) || beta.contain(1.0001));
  EXPECT_FALSE(beta.contain(std::nan("")));
}

TEST(Parameter, NumbersAreShownShortAndExact) {
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(1e-9), "1e-9");
  EXPECT_EQ(numberText(1.0 / 60), "0.016666666666666666");
}

/// Each parameter leads to a value of its own, which every reader and writer of the table finds.
TEST(Parameter, EveryParameterIsKeptInASnapshot) {
  std::set<std::string> names;
  for (const auto& parameter : simulationParameters()) {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
    SimulationConfig config;
    const Place place = parameter.place(config);
    if (const auto* number = std::get_if<double*>(&place)) **number += 0.25;
    if (const auto* count = std::get_if<int*>(&place)) ++**count;
    if (const auto* truth = std::get_if<bool*>(&place)) **truth = !**truth;
    if (const auto* list = std::get_if<Vector3*>(&place)) **list = Vector3(1, 2, 3);
    if (const auto* choice = std::get_if<Choice>(&place)) {
      for (const std::string& word : choice->words()) {
        if (word != choice->get() && choice->set(word)) break;
      }
    }
    const nlohmann::json changed = toJson(config);
    EXPECT_NE(changed, toJson(SimulationConfig())) << parameter.name;
    EXPECT_EQ(toJson(configFrom(changed)), changed) << parameter.name;
  }
}

TEST(Parameter, WordsOutsideAChoiceAreNotTaken) {
  Material material;
  const Choice choice(membraneNames(), material.membrane);
  EXPECT_EQ(choice.text(), "discrete_shells or st_venant_kirchhoff");
  EXPECT_FALSE(choice.set("rubber"));
  EXPECT_EQ(choice.get(), "st_venant_kirchhoff");
  EXPECT_TRUE(choice.set("discrete_shells"));
  EXPECT_EQ(material.membrane, MembraneKind::kDiscreteShells);
}
