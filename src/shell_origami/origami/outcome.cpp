#include <shell_origami/origami/outcome.h>

#include <shell_origami/sheet/rigid_panels.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace shell_origami {
namespace {

double inDegrees(double radians) { return radians * 180 / M_PI; }

/// Beyond this angle a crease is meant to lie flat.
constexpr double kMeantFlat = 170 * M_PI / 180;
/// Sectors that miss Kawasaki's sum by more do not fold flat.
constexpr double kSectors = M_PI / 180;

/// The target angles of the creases [rad]; NaN: a free crease.
struct Targets {
  std::vector<double> asked;
  std::vector<double> meant;  ///< those beyond kMeantFlat at 180 degrees

  explicit Targets(const std::vector<CreaseStatus>& creases) {
    for (const CreaseStatus& crease : creases) {
      asked.push_back(crease.driven ? crease.target_angle : std::nan(""));
      const bool flat = std::abs(asked.back()) >= kMeantFlat;
      meant.push_back(flat ? std::copysign(M_PI, asked.back()) : asked.back());
    }
  }
};

/// Says why an inner vertex all of whose creases are to lie flat cannot; empty where it can.
std::string notFlatBecause(const Sheet& sheet, int vertex, const std::vector<double>& around) {
  std::ostringstream text;
  const double kawasaki = kawasakiError(sheet, vertex);
  const auto valleys = std::count_if(around.begin(), around.end(), [](double a) { return a > 0; });
  const auto count = static_cast<std::ptrdiff_t>(around.size());
  if (count % 2 == 1) {
    text << "does not fold flat: an odd number of creases meets there, " << count;
  } else if (kawasaki > kSectors) {
    text << "does not fold flat: every other sector around it adds up to 180 degrees but for "
         << inDegrees(kawasaki) << " (Kawasaki)";
  } else if (std::abs(2 * valleys - count) != 2) {
    text << "does not fold flat: it has " << valleys << " valleys and " << count - valleys
         << " mountains, which must differ by 2 (Maekawa)";
  }
  return text.str();
}

/// Says why rigid panels do not close around a vertex; empty where they do, where a free crease may
/// adapt, and on the border.
std::string openBecause(const Sheet& sheet, int vertex, const Targets& targets) {
  if (sheet.triangulation().onBorder(vertex)) return "";
  const Vector2& p = sheet.flatPositions()[vertex];
  std::ostringstream text;
  text << "vertex " << vertex << " at (" << p.x() << ", " << p.y() << ") ";
  const std::vector<double> around = anglesAround(sheet, vertex, targets.meant);
  if (std::all_of(around.begin(), around.end(), [](double a) { return std::abs(a) == M_PI; })) {
    const std::string why = notFlatBecause(sheet, vertex, around);
    if (!why.empty()) return text.str() + why;
  }
  const double meant = closingError(sheet, vertex, targets.meant);
  const double asked = closingError(sheet, vertex, targets.asked);
  if (meant > kClosingTolerance) {
    text << "is open: at these angles its panels do not close, by " << inDegrees(meant)
         << " degrees";
  } else if (asked > kClosingTolerance) {
    text << "closes at 180 degrees only: at these angles its panels are open by "
         << inDegrees(asked) << " degrees";
  } else {
    return "";
  }
  return text.str();
}

}  // namespace

std::vector<MissedCrease> missedCreases(const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  const std::vector<CreaseStatus> creases = simulation.creases();
  const Targets targets(creases);
  std::map<int, std::string> open;
  std::vector<MissedCrease> missed;
  for (std::size_t i = 0; i < creases.size(); ++i) {
    const CreaseStatus& crease = creases[i];
    if (!crease.driven || !(std::abs(crease.angle - crease.target_angle) > kMissedBy)) continue;
    MissedCrease miss{crease.id, crease.name, crease.target_angle, crease.angle, ""};
    for (int v : sheet.creases()[i].vertices) {
      const auto [place, is_new] = open.emplace(v, "");
      if (is_new) place->second = openBecause(sheet, v, targets);
      if (miss.why.empty()) miss.why = place->second;
    }
    if (miss.why.empty())
      miss.why = "other creases or pins hold it, or no motion of the panels leads there";
    missed.push_back(std::move(miss));
  }
  return missed;
}

std::string missedSentence(const std::vector<MissedCrease>& missed) {
  if (missed.empty()) return "";
  const auto worst =
      std::max_element(missed.begin(), missed.end(), [](const auto& a, const auto& b) {
        return std::abs(a.angle - a.target) < std::abs(b.angle - b.target);
      });
  std::ostringstream text;
  text.precision(4);
  text << missed.size() << (missed.size() == 1 ? " crease has" : " creases have")
       << " missed the target angle by more than " << inDegrees(kMissedBy) << " degrees, "
       << worst->name << " by most (" << inDegrees(worst->angle) << " instead of "
       << inDegrees(worst->target) << "): " << worst->why;
  return text.str();
}

namespace {

/// Whether rigid panels close around every vertex with the folds' targets.
bool panelsClose(const Sheet& sheet, const Targets& targets) {
  const std::vector<int> inner = innerCreaseVertices(sheet);
  return !inner.empty() && std::all_of(inner.begin(), inner.end(), [&](int v) {
    // Not of a free crease, whose angle is NaN.
    return closingError(sheet, v, targets.asked) < kClosingTolerance;
  });
}

Vector2 centerOf(const Sheet& sheet, std::size_t triangle) {
  const auto& [a, b, c] = sheet.triangles()[triangle];
  const auto& flat = sheet.flatPositions();
  return (flat[a] + flat[b] + flat[c]) / 3;
}

}  // namespace

std::string bentSentence(const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  if (!panelsClose(sheet, Targets(simulation.creases()))) return "";
  const std::vector<int> panels = panelOfTriangle(sheet);
  std::vector<Vector3> normals;  // twice the area long
  std::map<int, Vector3> means;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto& [a, b, c] = sheet.triangles()[i];
    const Positions& x = simulation.positions();
    normals.push_back((x.col(b) - x.col(a)).cross(x.col(c) - x.col(a)));
    means.emplace(panels[i], Vector3::Zero()).first->second += normals.back();
  }
  double most = 0;
  std::size_t where = 0;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Vector3& mean = means.at(panels[i]);
    const double bend = std::atan2(normals[i].cross(mean).norm(), normals[i].dot(mean));
    if (bend > most) {
      most = bend;
      where = i;
    }
  }
  if (most <= kBentBy) return "";
  const Vector2 place = centerOf(sheet, where);
  std::ostringstream text;
  text.precision(4);
  text << "a panel is bent by " << inDegrees(most) << " degrees at (" << place.x() << ", "
       << place.y() << ") of the flat sheet, although its creases' targets leave panels flat";
  return text.str();
}

std::string stretchedSentence(const Simulation& simulation) {
  const double strain = simulation.maxStrain();
  if (strain <= kBearableStrain) return "";
  std::ostringstream text;
  text.precision(3);
  text << "the paper is stretched by " << 100 * strain << " %, further than paper bears ("
       << 100 * kBearableStrain << " %)";
  return text.str();
}

std::string crossingSentence(const Simulation& simulation) {
  const std::vector<TrianglePair> crossing = simulation.crossings();
  if (crossing.empty()) return "";
  const Sheet& sheet = simulation.sheet();
  const Vector2 place = centerOf(sheet, crossing.front()[0]);
  std::ostringstream text;
  text << "paper passes through itself: " << crossing.size()
       << " pairs of triangles, one of them at (" << place.x() << ", " << place.y()
       << ") of the flat sheet";
  return text.str();
}

namespace {

std::string cutSentence(const Simulation& simulation) {
  const std::string id = simulation.cutObstacle();
  return id.empty() ? "" : "obstacle '" + id + "' cuts the paper";
}

}  // namespace

std::vector<std::string> shortfalls(const Simulation& simulation,
                                    const std::vector<MissedCrease>& missed) {
  std::vector<std::string> sentences{missedSentence(missed), bentSentence(simulation),
                                     stretchedSentence(simulation), crossingSentence(simulation),
                                     cutSentence(simulation)};
  sentences.erase(std::remove(sentences.begin(), sentences.end(), ""), sentences.end());
  return sentences;
}

std::vector<std::string> shortfalls(const Simulation& simulation) {
  return shortfalls(simulation, missedCreases(simulation));
}

std::string shortfallText(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    text += (text.empty() ? "" : "; ") + sentence;
  }
  return text;
}

}  // namespace shell_origami
