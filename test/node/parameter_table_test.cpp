/// \file
/// config/origami.yaml and doc/reference.md say of every parameter what the node's table says.

#include <shell_origami/node/parameters.h>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <fstream>
#include <regex>
#include <sstream>

using namespace shell_origami;

namespace {

const std::string kRoot = "../";  // seen from test/

std::string read(const std::string& path) {
  std::ifstream in(kRoot + path);
  EXPECT_TRUE(in) << path;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

bool isNumber(const Place& place) {
  return !std::holds_alternative<bool*>(place) && !std::holds_alternative<std::string*>(place) &&
         !std::holds_alternative<Choice>(place);
}

/// What the column "bounds" holds; nothing of a text, where it is free.
std::string boundsText(const Place& place, const Bounds& bounds) {
  if (isNumber(place)) return bounds.text();
  if (std::holds_alternative<bool*>(place)) return "true, false";
  std::string text;
  if (const auto* choice = std::get_if<Choice>(&place)) {
    for (const std::string& word : choice->words()) text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string liveText(const Parameter<NodeConfig>& parameter) {
  if (!parameter.live) return "";
  NodeConfig config;
  const std::string name = parameter.name.substr(parameter.name.rfind('/') + 1);
  if (!std::holds_alternative<Vector3*>(parameter.place(config))) return "`" + name + "`";
  return "`" + name + "_x`, `" + name + "_y`, `" + name + "_z`";
}

void expectEqual(const Place& place, const YAML::Node& value, const std::string& name) {
  if (const auto* number = std::get_if<double*>(&place)) {
    EXPECT_EQ(**number, value.as<double>()) << name;
  } else if (const auto* count = std::get_if<int*>(&place)) {
    EXPECT_EQ(**count, value.as<int>()) << name;
  } else if (const auto* truth = std::get_if<bool*>(&place)) {
    EXPECT_EQ(**truth, value.as<bool>()) << name;
  } else if (const auto* text = std::get_if<std::string*>(&place)) {
    EXPECT_EQ(**text, value.as<std::string>()) << name;
  } else if (const auto* list = std::get_if<Vector3*>(&place)) {
    ASSERT_EQ(value.size(), 3u) << name;
    for (int i = 0; i < 3; ++i) EXPECT_EQ((**list)[i], value[i].as<double>()) << name;
  } else {
    EXPECT_EQ(std::get<Choice>(place).get(), value.as<std::string>()) << name;
  }
}

void flatten(const std::string& prefix, const YAML::Node& tree,
             std::map<std::string, YAML::Node>& flat) {
  for (const auto& entry : tree) {
    const std::string name = prefix + entry.first.Scalar();
    if (entry.second.IsMap()) flatten(name + "/", entry.second, flat);
    else flat[name] = entry.second;
  }
}

/// What config/origami.yaml says beside a parameter and in the lines above it.
std::map<std::string, std::string> manualComments() {
  static const std::regex kComment(" *#(.*)"), kEntry("( *)(\\w+):([^#]*)(#(.*))?");
  std::map<std::string, std::string> comments;
  std::istringstream in(read("config/origami.yaml"));
  std::string folder, above;
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (std::regex_match(line, match, kComment)) {
      above += match.str(1);
      continue;
    }
    if (std::regex_match(line, match, kEntry)) {
      if (match.str(1).empty()) folder.clear();
      if (match.str(3).find_first_not_of(' ') == std::string::npos) folder = match.str(2) + "/";
      else comments[folder + match.str(2)] = above + match.str(5);
    }
    above.clear();
  }
  return comments;
}

/// The rows of the reference's table of parameters, each by its first cell.
std::map<std::string, std::vector<std::string>> referenceRows() {
  const std::string page = read("doc/reference.md");
  const std::size_t begin = page.find("## Parameters of origami_node");
  std::istringstream in(page.substr(begin, page.find("\n## ", begin + 1) - begin));
  std::map<std::string, std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    std::vector<std::string> cells;
    std::istringstream row(line.substr(1));
    for (std::string cell; std::getline(row, cell, '|');) {
      const std::size_t first = cell.find_first_not_of(' ');
      const std::size_t last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    const std::string name = cells.front();
    rows[name] = cells;
  }
  return rows;
}

std::string withoutTicks(std::string cell) {
  if (cell.size() > 1 && cell.front() == '`') cell = cell.substr(1, cell.size() - 2);
  return cell;
}

}  // namespace

TEST(ParameterTable, TheManualSaysTheSame) {
  std::map<std::string, YAML::Node> manual;
  flatten("", YAML::Load(read("config/origami.yaml")), manual);
  const std::map<std::string, std::string> comments = manualComments();
  EXPECT_EQ(manual.size(), nodeParameters().size());
  NodeConfig config;
  for (const auto& parameter : nodeParameters()) {
    const std::string& name = parameter.name;
    ASSERT_TRUE(manual.count(name)) << name;
    const Place place = parameter.place(config);
    expectEqual(place, manual[name], name);
    const std::string& said = comments.at(name);
    if (isNumber(place)) {
      EXPECT_NE(said.find(parameter.bounds.text()), std::string::npos) << name << ": " << said;
    }
    if (const auto* choice = std::get_if<Choice>(&place)) {
      for (const std::string& word : choice->words()) {
        EXPECT_NE(said.find(word), std::string::npos) << name << ": " << said;
      }
    }
    std::smatch unit;
    std::regex_search(said, unit, std::regex("\\[([^\\]]*)\\]"));
    EXPECT_EQ(unit.empty() ? "" : unit.str(1), parameter.unit) << name;
    EXPECT_EQ(std::regex_search(said, std::regex("\\blive\\b")), parameter.live) << name;
  }
}

TEST(ParameterTable, TheReferenceSaysTheSame) {
  const auto rows = referenceRows();
  EXPECT_EQ(rows.size(), nodeParameters().size());
  NodeConfig config;
  for (const auto& parameter : nodeParameters()) {
    const std::string name = "`" + parameter.name + "`";
    ASSERT_TRUE(rows.count(name)) << name;
    const std::vector<std::string>& cells = rows.at(name);
    ASSERT_EQ(cells.size(), 6u) << name;
    const Place place = parameter.place(config);
    expectEqual(place, YAML::Load(withoutTicks(cells[1])), name);
    const std::string bounds = boundsText(place, parameter.bounds);
    if (!bounds.empty()) {
      EXPECT_EQ(cells[2], bounds) << name;
    }
    EXPECT_EQ(cells[3], parameter.unit) << name;
    EXPECT_EQ(cells[4], liveText(parameter)) << name;
    EXPECT_EQ(cells[5], parameter.meaning) << name;
  }
}
