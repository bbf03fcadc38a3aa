/// \file
/// A parameter: all that is said of it, in one place for whatever reads, checks or writes it.
#pragma once

#include <shell_origami/base/geometry.h>

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {

/// The numbers that a parameter may be. Infinite and undefined ones are outside.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;     ///< whether `low` itself is outside
  bool or_zero = false;  ///< whether 0 is inside as well

  bool contain(double value) const;
  /// Returns "> 0", ">= 0", "from 0 to 0.49" or "0 or from 0.001 to 1"; nothing where both ends are
  /// infinite.
  std::string text() const;
};

constexpr Bounds kPositive{0, std::numeric_limits<double>::infinity(), true};
constexpr Bounds kNotNegative{0};
constexpr Bounds between(double low, double high) { return {low, high}; }

/// Returns the shortest decimal number that reads back as `value`, such as 0.1 or 1e-9.
std::string numberText(double value);

/// One of a few words, each of which stands for a value of an enumeration.
class Choice {
 public:
  /// Both arguments must outlive the choice.
  template <class Value>
  Choice(const std::map<std::string, Value>& words, Value& value)
      : get_([&words, &value] {
          for (const auto& [word, meaning] : words) {
            if (meaning == value) return word;
          }
          return std::string();
        }),
        set_([&words, &value](const std::string& word) { value = words.at(word); }) {
    for (const auto& entry : words) words_.push_back(entry.first);
  }

  const std::vector<std::string>& words() const { return words_; }
  std::string get() const { return get_(); }
  /// Returns whether `word` is one of words(); otherwise leaves the value alone.
  bool set(const std::string& word) const;
  /// Returns the words: "a or b".
  std::string text() const;

 private:
  std::vector<std::string> words_;
  std::function<std::string()> get_;
  std::function<void(const std::string&)> set_;
};

/// Where the value of a parameter lies.
using Place = std::variant<double*, int*, bool*, std::string*, Vector3*, Choice>;

/// A parameter of an `Owner`.
template <class Owner>
struct Parameter {
  std::string name;  ///< with its folder, such as material/thickness
  std::function<Place(Owner&)> place;
  std::string meaning;  ///< one line for the reference
  std::string unit;     ///< empty: it has none
  Bounds bounds;        ///< of a number, or of each number of a list
  bool live = false;    ///< whether it may change while the node runs
};

template <class Owner>
using ParameterTable = std::vector<Parameter<Owner>>;

/// \throws std::invalid_argument that names the parameter, its value and its bounds, where it is
///         outside
void checkValue(const std::string& name, const Place& place, const Bounds& bounds);

/// Checks every parameter of a table. \throws std::invalid_argument as checkValue() does
template <class Owner>
void checkValues(const ParameterTable<Owner>& table, Owner owner) {
  for (const auto& parameter : table) {
    checkValue(parameter.name, parameter.place(owner), parameter.bounds);
  }
}

/// Appends the parameters of a member of `Owner`.
template <class Owner, class Part>
void append(ParameterTable<Owner>& table, const ParameterTable<Part>& part, Part Owner::*member) {
  for (const auto& [name, place, meaning, unit, bounds, live] : part) {
    table.push_back({name, [place = place, member](Owner& owner) { return place(owner.*member); },
                     meaning, unit, bounds, live});
  }
}

}  // namespace shell_origami
