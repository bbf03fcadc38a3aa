#include <shell_origami/origami/landmark_text.h>

#include <shell_origami/origami/parameter.h>

#include <algorithm>
#include <set>

namespace shell_origami {
namespace {

bool samePlace(const Landmark& a, const Landmark& b);

struct SamePlace {
  template <class A, class B>
  bool operator()(const A&, const B&) const {
    return false;
  }
  bool operator()(const Vector2& a, const Vector2& b) const { return a == b; }
  bool operator()(const CornerNear& a, const CornerNear& b) const { return a.point == b.point; }
  bool operator()(const PartOfWay& a, const PartOfWay& b) const {
    return a.part == b.part && same(a.ends, b.ends);
  }
  bool operator()(const LinesMeet& a, const LinesMeet& b) const { return same(a.ends, b.ends); }

 private:
  static bool same(const std::vector<Landmark>& a, const std::vector<Landmark>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), samePlace);
  }
};

bool samePlace(const Landmark& a, const Landmark& b) {
  return std::visit(SamePlace{}, a.place, b.place);
}

struct PlaceText {
  const LandmarkText& text;

  std::string operator()(const Vector2& point) const { return numbers(point); }
  std::string operator()(const CornerNear& corner) const {
    return "{corner: " + numbers(corner.point) + "}";
  }
  std::string operator()(const PartOfWay& way) const {
    return "{on: " + text.several(way.ends) + ", at: " + numberText(way.part) + "}";
  }
  std::string operator()(const LinesMeet& lines) const {
    return "{meet: " + text.several(lines.ends) + "}";
  }
};

/// The lines of names, each after those that it uses.
class NamesText {
 public:
  explicit NamesText(const LandmarkNames& names) : names_(names) {
    for (const auto& entry : names_) write(entry.first);
  }
  const std::string& text() const { return text_; }

 private:
  void write(const std::string& name) {
    if (!begun_.insert(name).second) return;
    const Landmark& landmark = names_.at(name);
    if (const auto* way = std::get_if<PartOfWay>(&landmark.place)) writeUsed(way->ends);
    if (const auto* lines = std::get_if<LinesMeet>(&landmark.place)) writeUsed(lines->ends);
    text_ += "  " + word(name) + ": " + LandmarkText(written_).place(landmark) + "\n";
    written_[name] = landmark;
  }

  void writeUsed(const std::vector<Landmark>& landmarks) {
    for (const Landmark& landmark : landmarks) {
      if (names_.count(landmark.name) > 0) write(landmark.name);
    }
  }

  const LandmarkNames& names_;
  LandmarkNames written_;
  std::set<std::string> begun_;
  std::string text_;
};

}  // namespace

std::string LandmarkText::operator()(const Landmark& landmark) const {
  const auto named = names_.find(landmark.name);
  const bool known = named != names_.end() && samePlace(named->second, landmark);
  return known ? word(landmark.name) : place(landmark);
}

std::string LandmarkText::place(const Landmark& landmark) const {
  return std::visit(PlaceText{*this}, landmark.place);
}

std::string namesText(const LandmarkNames& names) { return NamesText(names).text(); }

}  // namespace shell_origami
