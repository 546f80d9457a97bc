// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <string>
#include <utility>

#include "core/outcome.h"
#include "geometries/power_crust_3/power_crust_3.h"
#include "geometries/scatter.h"

namespace mesecina {

namespace {

/// Per ball its neighbours in the regular triangulation, ascending.
struct Neighbors {
  std::vector<int> offsets;
  std::vector<int> balls;
  std::span<const int> of(int ball) const {
    return std::span(balls).subspan(offsets[ball], offsets[ball + 1] - offsets[ball]);
  }
};

Neighbors find_neighbors(const Regular_3& regular) {
  const auto for_each_pair = [&](const auto& function) {
    for (const auto& corners : regular.cells)
      for (const int a : corners)
        for (const int b : corners)
          if (a >= 0 && b >= 0 && a != b) function(a, b);
  };
  const std::size_t count = regular.balls.size();
  std::vector<int> offsets(count + 1, 0);
  for_each_pair([&](int a, int) { ++offsets[a + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  // Each pair as often as there are cells around it.
  std::vector<int> repeated(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for_each_pair([&](int a, int b) { repeated[next[a]++] = b; });
  Neighbors result;
  result.offsets.push_back(0);
  for (std::size_t ball = 0; ball < count; ++ball) {
    const auto begin = repeated.begin() + offsets[ball];
    const auto end = repeated.begin() + offsets[ball + 1];
    std::sort(begin, end);
    result.balls.insert(result.balls.end(), begin, std::unique(begin, end));
    result.offsets.push_back(static_cast<int>(result.balls.size()));
  }
  return result;
}

Point_3 unit_vector(const Point_3& from, const Point_3& to) { return (1 / distance(from, to)) * (to - from); }

/// A point that both balls have on their spheres; -1 for none.
int shared_contact(const Poles_3& poles, int a, int b) {
  auto one = poles.contacts_of(a);
  auto two = poles.contacts_of(b);
  if (two.size() < one.size()) std::swap(one, two);
  for (const int point : one)
    if (std::ranges::binary_search(two, point)) return point;
  return -1;
}

/// A spread of labels from pole to pole, the surest first.
class Labelling {
 public:
  Labelling(const Poles_3& poles, const Regular_3& regular)
      : poles_(poles), neighbors_(find_neighbors(regular)), evidence_(poles.size()), is_labelled_(poles.size(), 0) {}

  void run(Polar_balls_3& result, const Progress& progress) {
    for (int p = static_cast<int>(poles_.finite_count); p < static_cast<int>(poles_.size()); ++p)
      add_evidence(p, false, 1);
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      constexpr std::size_t often = 4096;
      if (step % often == 0) progress.check();
      const Entry next = queue_.top();
      queue_.pop();
      if (is_labelled_[next.pole] != 0 || next.priority != evidence_[next.pole].priority()) continue;
      is_labelled_[next.pole] = 1;
      const Evidence& evidence = evidence_[next.pole];
      const bool is_inner = evidence.inner > evidence.outer;
      result.is_inner[next.pole] = is_inner ? 1 : 0;
      result.confidence[next.pole] = std::max(evidence.inner, evidence.outer);
      spread(next.pole, is_inner, result.confidence[next.pole]);
    }
  }

 private:
  struct Evidence {
    double inner = 0;
    double outer = 0;
    /// Those with evidence for one side only come first.
    double priority() const { return inner > 0 && outer > 0 ? std::abs(inner - outer) - 1 : std::max(inner, outer); }
  };
  struct Entry {
    double priority = 0;
    int pole = 0;
    bool operator<(const Entry& other) const {
      return priority != other.priority ? priority < other.priority : pole > other.pole;
    }
  };

  void add_evidence(int pole, bool is_inner, double weight) {
    double& side = is_inner ? evidence_[pole].inner : evidence_[pole].outer;
    if (weight <= side) return;
    side = weight;
    queue_.push({evidence_[pole].priority(), pole});
  }

  void spread(int pole, bool is_inner, double confidence) {
    // Long chains must not end by underflow.
    const auto weakened = [confidence](double factor) {
      return std::max(confidence * std::min(factor, 1.0), std::numeric_limits<double>::min());
    };
    const Point_3& center = poles_.balls[pole].center;
    for (const int s : poles_.samples_of(pole)) {
      const int other = poles_.opposite(pole, s);
      if (other < 0 || is_labelled_[other] != 0) continue;
      const Point_3& sample = poles_.points[s];
      const double opposition = -dot(unit_vector(sample, center), unit_vector(sample, poles_.balls[other].center));
      add_evidence(other, !is_inner, weakened(opposition));
    }
    for (const int other : neighbors_.of(pole)) {
      if (is_labelled_[other] != 0) continue;
      if (const double depth = intersection_cosine(poles_, pole, other); depth > 0)
        add_evidence(other, is_inner, weakened(depth));
    }
  }

  const Poles_3& poles_;
  Neighbors neighbors_;
  std::vector<Evidence> evidence_;
  std::vector<std::uint8_t> is_labelled_;
  std::priority_queue<Entry> queue_;
};

}  // namespace

double intersection_cosine(const Poles_3& poles, int a, int b) {
  if (poles.balls[a].radius < poles.balls[b].radius) std::swap(a, b);
  const int shared = shared_contact(poles, a, b);
  const Point_3& p = poles.points[shared >= 0 ? shared : poles.contacts_of(a).front()];
  const Point_3& q = poles.points[shared >= 0 ? shared : poles.contacts_of(b).front()];
  const Point_3 to_a = unit_vector(p, poles.balls[a].center);
  const Point_3 to_b = unit_vector(q, poles.balls[b].center);
  const Point_3 offset = p - q;
  // (ra^2 + rb^2 - d^2) / (2 ra rb), but without the differences of large numbers when a is very large.
  return dot(to_a, to_b) + dot(offset, to_b) / poles.balls[a].radius -
         (dot(offset, offset) / (2 * poles.balls[a].radius) + dot(offset, to_a)) / poles.balls[b].radius;
}

Polar_balls_3 label_poles(std::shared_ptr<const Poles_3> poles, std::shared_ptr<const Regular_3> regular,
                          Progress& progress) {
  progress.begin_stage("labels of poles");
  Polar_balls_3 result;
  result.is_inner.assign(poles->size(), 0);
  result.confidence.assign(poles->size(), 0);
  Labelling(*poles, *regular).run(result, progress);
  result.unlabelled_count = static_cast<std::size_t>(std::ranges::count(result.confidence, 0.0));
  for (int s = 0; s < static_cast<int>(poles->first.size()); ++s) {
    const int first = poles->first[s];
    const int second = poles->second[s];
    if (first < 0 || second < 0 || result.confidence[first] == 0 || result.confidence[second] == 0) continue;
    if (result.is_inner[first] == result.is_inner[second]) result.contradictions.push_back(s);
  }
  result.poles = std::move(poles);
  result.regular = std::move(regular);
  return result;
}

std::vector<Ball_3> inner_polar_balls(const Polar_balls_3& polar, double perturbation) {
  std::vector<Ball_3> balls;
  for (std::size_t p = 0; p < polar.poles->finite_count; ++p) {
    if (polar.is_inner[p] == 0) continue;
    const auto& [center, radius] = polar.poles->balls[p];
    const std::uint64_t number = 3 * balls.size();
    const Point_3 shift{scattered(number), scattered(number + 1), scattered(number + 2)};
    balls.push_back({center + (perturbation * radius) * shift, radius});
  }
  if (balls.empty()) throw Unavailable("no pole lies inside: the points enclose nothing (is the surface closed?)");
  return balls;
}

}  // namespace mesecina
