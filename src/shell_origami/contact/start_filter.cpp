#include <shell_origami/contact/start_filter.h>

#include <shell_origami/contact/ccd.h>
#include <shell_origami/contact/guard.h>

#include <algorithm>

namespace shell_origami {
namespace {

/// A vertex that is moved back may meet another one that moved away before. After so many rounds
/// all vertices are moved back alike.
constexpr int kMostRounds = 20;

}  // namespace

void separate(const std::vector<ContactPair>& pairs, const std::vector<double>& gaps,
              const Positions& from, Positions& to) {
  for (int round = 0; round < kMostRounds; ++round) {
    bool safe = true;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const ContactPair& pair = pairs[i];
      if (gaps[i] - approach(pair, from, to) >= kNear * pair.reach) continue;
      const double part = freePart(pair, from, to);
      if (part == 1) continue;
      safe = false;
      for (int v : pair.vertices) to.col(v) = from.col(v) + part * (to.col(v) - from.col(v));
    }
    if (safe) return;
  }
  double part = 1;
  for (const ContactPair& pair : pairs) part = std::min(part, freePart(pair, from, to));
  to = from + part * (to - from);
}

}  // namespace shell_origami
