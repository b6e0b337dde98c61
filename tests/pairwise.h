#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace crest::testing {

/// One of the values that a parameter of `Subject` may take. `set` sets all that the parameter owns.
template <class Subject>
struct Value {
  std::string name;
  std::function<void(Subject&)> set;
};

template <class Subject>
struct Parameter {
  std::string name;
  std::vector<Value<Subject>> values;
};

/// Where a parameter has one of `values`, the other one has one of `others`.
struct Rule {
  std::string parameter;
  std::vector<std::string> values;
  std::string other;
  std::vector<std::string> others;
};

/// The values of all parameters, by their indices; -1 where none is chosen yet.
using Choice = std::vector<int>;

/// Chooses values so that a few choices hold each pair of values that may stand together (a covering array of
/// strength 2, made greedily). The same parameters and rules give the same choices.
template <class Subject>
class Pairwise {
 public:
  Pairwise(std::vector<Parameter<Subject>> parameters, const std::vector<Rule>& rules)
      : parameters_(std::move(parameters)), rules_(rules) {}

  struct Pair {
    std::size_t a, b;  ///< parameters, a < b
    int x, y;          ///< their values
  };

  Choice nothing() const { return Choice(parameters_.size(), -1); }

  /// All pairs that are part of a whole choice.
  std::vector<Pair> valid_pairs() const {
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < parameters_.size(); ++a)
      for (std::size_t b = a + 1; b < parameters_.size(); ++b)
        for (int x = 0; x < count(a); ++x)
          for (int y = 0; y < count(b); ++y)
            if (can_complete(with({a, b, x, y}))) pairs.push_back({a, b, x, y});
    return pairs;
  }

  std::vector<Choice> choices() const {
    std::vector<Choice> found;
    std::vector<Pair> left = valid_pairs();
    while (!left.empty()) {
      Choice choice = with(left.front());
      for (std::size_t p = 0; p < parameters_.size(); ++p)
        if (choice[p] < 0) choice[p] = best_value(choice, p, left);
      std::erase_if(left, [&](const Pair& pair) { return holds(choice, pair); });
      found.push_back(std::move(choice));
    }
    return found;
  }

  static bool holds(const Choice& choice, const Pair& pair) {
    return choice[pair.a] == pair.x && choice[pair.b] == pair.y;
  }

  /// Whether no rule is against what is chosen so far.
  bool is_allowed(const Choice& choice) const {
    for (std::size_t a = 0; a < choice.size(); ++a)
      for (std::size_t b = 0; b < choice.size(); ++b)
        if (choice[a] >= 0 && choice[b] >= 0 && !go_together(a, choice[a], b, choice[b])) return false;
    return true;
  }

  Subject subject(const Choice& choice) const {
    Subject subject;
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      parameters_[p].values[std::size_t(choice[p])].set(subject);
    return subject;
  }

  /// The choice that gives a subject; -1 for each parameter that has no such value.
  Choice choice_of(const Subject& subject) const {
    Choice choice = nothing();
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      for (int x = count(p) - 1; x >= 0; --x) {
        Subject set = subject;
        parameters_[p].values[std::size_t(x)].set(set);
        if (set == subject) choice[p] = x;
      }
    return choice;
  }

  /// For people.
  std::string describe(const Choice& choice) const {
    std::string text;
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      text += (p ? ", " : "") + parameters_[p].name + ": " +
              (choice[p] < 0 ? "?" : parameters_[p].values[std::size_t(choice[p])].name);
    return text;
  }

 private:
  int count(std::size_t parameter) const { return int(parameters_[parameter].values.size()); }

  Choice with(const Pair& pair) const {
    Choice choice = nothing();
    choice[pair.a] = pair.x;
    choice[pair.b] = pair.y;
    return choice;
  }

  bool go_together(std::size_t a, int x, std::size_t b, int y) const {
    const auto has = [](const std::vector<std::string>& names, const std::string& name) {
      return std::ranges::find(names, name) != names.end();
    };
    return std::ranges::all_of(rules_, [&](const Rule& rule) {
      return rule.parameter != parameters_[a].name || rule.other != parameters_[b].name ||
             !has(rule.values, parameters_[a].values[std::size_t(x)].name) ||
             has(rule.others, parameters_[b].values[std::size_t(y)].name);
    });
  }

  bool can_complete(const Choice& choice) const {
    if (!is_allowed(choice)) return false;
    const auto open = std::ranges::find(choice, -1);
    if (open == choice.end()) return true;
    Choice next = choice;
    int& value = next[std::size_t(open - choice.begin())];
    for (value = 0; value < count(std::size_t(open - choice.begin())); ++value)
      if (can_complete(next)) return true;
    return false;
  }

  /// The value of a parameter that makes most pairs which are left with those chosen already.
  int best_value(Choice choice, std::size_t p, const std::vector<Pair>& left) const {
    int best = -1;
    std::ptrdiff_t most = -1;
    for (int& x = choice[p] = 0; x < count(p); ++x) {
      const auto made = std::ranges::count_if(
          left, [&](const Pair& pair) { return (pair.a == p || pair.b == p) && holds(choice, pair); });
      if (made <= most || !can_complete(choice)) continue;
      best = x;
      most = made;
    }
    return best;
  }

  std::vector<Parameter<Subject>> parameters_;
  std::vector<Rule> rules_;
};

}  // namespace crest::testing
