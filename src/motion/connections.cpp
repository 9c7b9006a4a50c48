// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "families.hpp"
#include "offer.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/turns.hpp"

namespace selion {
namespace {

constexpr double kHair_m = 1e-8;
// Turned by steering to the limit and back; below, flat turns are the shortest to 0.7 mm.
constexpr double kQuick_rad = 0.5;
// Beyond the first flat turns by as much of their width, times that angle (to 1), they are the shortest.
constexpr double kFarther = 0.6;

/// The least that a family's ways turn left and right.
double least_rad(Asked asked, double heading_rad) {
  if (asked == Asked::by_lefts) return whole_turns_off(heading_rad);
  if (asked == Asked::by_rights) return whole_turns_off(-heading_rad);
  return asked == Asked::when_reversing || asked == Asked::when_pivoting ? 0 : std::abs(heading_rad);
}

bool goes_by_steps(Asked asked) { return asked == Asked::step_by_step || asked == Asked::step_by_step_right; }

}  // namespace

/// What may come next, by the least that it can measure: families, the diagonals and starts of the searches
/// for three swings, and words that only want to be drawn.
class Connections::Queue {
 public:
  Queue(const Pose& from, const Pose& to, const Swings& swings, Manoeuvres may)
      : view_{from, to}, swings_{swings}, may_{may} {
    entries_.reserve(32);
    words_.reserve(16);
    apart_m_ = length_m(view_.goal.at);
    const auto all = families();
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].asked == Asked::first) expand({0, Step::family, i, 0});
    least_m_ = shortest_u_turn_m();
    for (std::size_t i = 0; i < all.size(); ++i) push_family(i, all[i].asked);
  }

  std::optional<Path> next(double longest_m) {
    if (auto path = direct(longest_m)) return path;
    return found_any_ || !entries_.empty() ? std::nullopt : driven_on(longest_m);
  }

 private:
  enum class Step { word, family, search, diagonal, start };
  struct Entry {
    double least_m;
    Step step;
    std::size_t index;
    std::size_t serial;
  };
  struct Start {
    std::size_t search;
    ThreeSwingSearch::Start start;
  };

  std::optional<Path> direct(double longest_m) {
    while (!entries_.empty() && entries_.front().least_m <= longest_m) {
      std::pop_heap(entries_.begin(), entries_.end(), later);
      const Entry entry = entries_.back();
      entries_.pop_back();
      if (entry.step == Step::word) {
        if (auto path = drawn(words_[entry.index], entry.least_m)) return path;
      } else {
        expand(entry);
      }
    }
    return std::nullopt;
  }

  static bool later(const Entry& a, const Entry& b) {
    return a.least_m > b.least_m || (a.least_m == b.least_m && a.serial > b.serial);
  }

  void push_family(std::size_t index, Asked asked) {
    if (asked == Asked::first || !allows(may_, families()[index].kind.needs)) return;
    const double least = least_rad(asked, view_.goal.heading_rad);
    if (!goes_by_steps(asked))
      push(Step::family, index, least);
    else if (near_for_three(view_.goal, swings_))
      push(Step::search, asked == Asked::step_by_step ? 0 : 1, least);
  }

  void push_m(Step step, std::size_t index, double least_m) {
    entries_.push_back({least_m, step, index, serial_++});
    std::push_heap(entries_.begin(), entries_.end(), later);
  }

  void push(Step step, std::size_t index, double least_rad) {
    // A hair less: rounding must not let a longer one go first.
    const double bound_m = std::max(apart_m_, swings_.length_m(least_rad)) - kHair_m;
    push_m(step, index, std::max(least_m_, bound_m));
  }

  /// Between swaths side by side nothing is shorter than the loop or the dip, and nothing than the flat turn
  /// to a swath far aside: searching has found none, so the other families need not be asked before. A little
  /// beyond the first flat turns others may be shorter, by a millimetre where the curvature is steered
  /// quickly against the turn's length, and by a few centimetres else; and where a swath is driven on.
  [[nodiscard]] double shortest_u_turn_m() const {
    const auto turn = u_turn(view_.goal);
    if (may_ != Manoeuvres{} || !turn || turn->before_m + std::abs(turn->after_m) > 1e-9) return 0;
    const double flat_from_m = std::numbers::sqrt2 * swings_.chord(std::numbers::pi / 2).length_m;
    const double steered_rad =
        std::pow(swings_.limits().curvature_per_m, 2) / swings_.limits().sharpness_per_m2;
    const double far = std::abs(turn->goal.at.y_m) / flat_from_m;
    if (steered_rad > kQuick_rad && far > 1 && far < 1 + kFarther * std::min(steered_rad, 1.0)) return 0;
    return entries_.empty() ? 0 : entries_.front().least_m + kHair_m;
  }

  void push_known(std::size_t word) { push_m(Step::word, word, selion::length_m(words_[word], swings_)); }

  void expand(const Entry& entry) {
    if (entry.step == Step::family) {
      const std::size_t before = words_.size();
      families()[entry.index].words(words_, view_.goal, swings_);
      for (std::size_t i = before; i < words_.size(); ++i) push_known(i);
    } else if (entry.step == Step::search) {
      searches_[entry.index].emplace(view_.goal, entry.index == 0 ? 1 : -1, swings_);
      push_diagonal(entry.index);
    } else if (entry.step == Step::diagonal) {
      add_starts(entry.index, ranks_[entry.index]++);
      push_diagonal(entry.index);
    } else if (const auto triple =
                   searches_[starts_[entry.index].search]->found(starts_[entry.index].start)) {
      words_.push_back(word_of(*triple));
      push_known(words_.size() - 1);
    }
  }

  void push_diagonal(std::size_t search) {
    const auto least_m = searches_[search]->least_m(ranks_[search]);
    if (least_m) push_m(Step::diagonal, search, std::max(apart_m_, *least_m));
  }

  void add_starts(std::size_t search, std::size_t rank) {
    scratch_.clear();
    searches_[search]->add_starts(scratch_, rank);
    for (const auto& start : scratch_) {
      starts_.push_back({search, start});
      push_m(Step::start, starts_.size() - 1, std::max(apart_m_, start.least_m));
    }
  }

  /// Unless it is the same way as the last one.
  std::optional<Path> drawn(const Word& word, double length_m) {
    auto path = drawn_to(word, view_, swings_);
    if (!path || (found_any_ && same_as_last(*path, length_m))) return std::nullopt;
    found_any_ = true;
    last_ = word;
    last_m_ = length_m;
    return path;
  }

  [[nodiscard]] bool same_as_last(const Path& path, double length_m) const {
    if (std::abs(length_m - last_m_) > 1e-7) return false;
    Drawn last{view_.from, view_.ahead};
    draw_word(last, last_, swings_);
    return distance_m(at_quarter(path, length_m), at_quarter(last.path, last_m_)) < 1e-6;
  }

  static Point at_quarter(const Path& path, double length_m) {
    double left = length_m / 4;
    std::size_t i = 0;
    for (; i + 1 < path.size() && left > path[i].curve.length_m; ++i) left -= path[i].curve.length_m;
    return state_at(path[i].curve, left).at;
  }

  /// Where nothing else fits: straight on until the goal lies so far back that a turn towards it does.
  std::optional<Path> driven_on(double longest_m) {
    const double k = swings_.limits().curvature_per_m;
    const double least_m = 1 / k + k / swings_.limits().sharpness_per_m2;
    for (; doubled_ < 30; ++doubled_) {
      const double ahead_m = std::ldexp(least_m, doubled_);
      if (ahead_m > longest_m) break;
      Drawn start{view_.from, view_.ahead};
      draw_line(start, ahead_m);
      if (!rest_) rest_ = std::make_unique<Queue>(start.at, view_.to, swings_, may_);
      if (auto more = rest_->direct(longest_m - ahead_m)) {
        append(start.path, *more);
        return std::move(start.path);
      }
      if (rest_->found_any_ || !rest_->entries_.empty()) break;
      rest_.reset();
    }
    return std::nullopt;
  }

  View view_;
  const Swings& swings_;
  Manoeuvres may_;
  double apart_m_ = 0;
  double least_m_ = 0;  // of the families that are not cheap, where that is known
  std::array<std::optional<ThreeSwingSearch>, 2> searches_;
  std::array<std::size_t, 2> ranks_{};  // of the next diagonal of each search
  std::vector<Entry> entries_;
  std::vector<Word> words_;
  std::vector<Start> starts_;
  std::vector<ThreeSwingSearch::Start> scratch_;
  std::size_t serial_ = 0;
  bool found_any_ = false;
  Word last_;
  double last_m_ = 0;
  int doubled_ = 0;
  std::unique_ptr<Queue> rest_;  // from where it has driven on to
};

Connections::Connections(const Pose& from, const Pose& to, const Swings& swings)
    : Connections{from, to, swings, Manoeuvres{}} {}
Connections::Connections(const Pose& from, const Pose& to, const Swings& swings, const Manoeuvres& may)
    : queue_{std::make_unique<Queue>(from, to, swings, may)} {}
Connections::~Connections() = default;
Connections::Connections(Connections&&) noexcept = default;
Connections& Connections::operator=(Connections&&) noexcept = default;

std::optional<Path> Connections::next(double longest_m) { return queue_->next(longest_m); }

std::vector<Path> connections(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const Swings swings{limits};
  Connections all{from, to, swings};
  std::vector<Path> paths;
  while (auto path = all.next()) paths.push_back(std::move(*path));
  // A search for three swings may, once in thousands of pairs, show a way after one that is longer by little.
  std::stable_sort(paths.begin(), paths.end(),
                   [](const Path& a, const Path& b) { return length_m(a) < length_m(b); });
  return paths;
}

}  // namespace selion
