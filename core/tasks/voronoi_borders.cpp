// Triangles cut by the lines on which two squared distances are equal.
#include "tasks/voronoi_borders.h"

#include <algorithm>
#include <cmath>

namespace vorogeo {

namespace {

using Barycentric = std::array<double, 3>;

double value_at(const std::array<double, 3>& corners, const Barycentric& at) {
  return corners[0] * at[0] + corners[1] * at[1] + corners[2] * at[2];
}

std::uint64_t line_of(Index first, Index second) {
  return static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint64_t>(second);
}

}  // namespace

double share_of_face(const std::vector<FaceSite>& sites, std::size_t mine) {
  std::vector<Barycentric> polygon{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Barycentric> cut;
  for (std::size_t other = 0; other < sites.size() && !polygon.empty(); ++other) {
    if (other == mine) continue;
    std::array<double, 3> lead{};  // difference of the squared distances: the other's minus this one's
    for (int c = 0; c < 3; ++c) lead[c] = sites[other].square[c] - sites[mine].square[c];
    cut.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Barycentric& p = polygon[i];
      const Barycentric& q = polygon[(i + 1) % polygon.size()];
      const double a = value_at(lead, p);
      const double b = value_at(lead, q);
      if (a >= 0.0) cut.push_back(p);
      if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) {
        const double t = a / (a - b);
        cut.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])});
      }
    }
    // If two sites tie on the whole face, the first owns it.
    if (other < mine && lead[0] == 0.0 && lead[1] == 0.0 && lead[2] == 0.0) cut.clear();
    polygon.swap(cut);
  }
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Barycentric& p = polygon[i];
    const Barycentric& q = polygon[(i + 1) % polygon.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return std::abs(twice);
}

void BorderTracer::trace(Index face, const std::vector<FaceSite>& sites) {
  for (std::size_t i = 0; i < sites.size(); ++i) {
    for (std::size_t j = i + 1; j < sites.size(); ++j) trace_pair(face, sites, i, j);
  }
}

Index BorderTracer::point_of(const End& end, std::uint64_t line) {
  return end.corner != no_index ? builder_.at_vertex(end.corner, line)
                                : builder_.on_edge(end.edge, end.t, line);
}

/// Finds the ends of the line on which the lead vanishes; fewer than two if it does not cross the face.
int BorderTracer::find_ends(Index face, const std::array<double, 3>& lead, End* ends) const {
  const auto& corners = mesh_.face_vertices(face);
  int count = 0;
  const auto zeros = std::count(lead.begin(), lead.end(), 0.0);
  if (zeros == 3) return 0;
  for (int i = 0; i < 3; ++i) {
    if (lead[i] == 0.0) {
      // A line along an edge belongs to the face on whose side the second site is nearer.
      if (zeros == 2 && lead[0] + lead[1] + lead[2] > 0.0) return 0;
      End end;
      end.at[i] = 1.0;
      end.corner = corners[i];
      ends[count++] = end;
      continue;
    }
    const int j = (i + 1) % 3;
    if (lead[i] * lead[j] >= 0.0) continue;
    End end;
    end.edge = mesh_.edge_of(3 * face + i);
    // Computed from the first vertex of the edge, so that both faces get the same number.
    const bool along = mesh_.edge_vertices(end.edge)[0] == corners[i];
    const double first = along ? lead[i] : lead[j];
    const double second = along ? lead[j] : lead[i];
    end.t = first / (first - second);
    end.at[i] = along ? 1.0 - end.t : end.t;
    end.at[j] = along ? end.t : 1.0 - end.t;
    ends[count++] = end;
  }
  return count;
}

void BorderTracer::trace_pair(Index face, const std::vector<FaceSite>& sites, std::size_t i, std::size_t j) {
  const FaceSite& s = sites[i];
  const FaceSite& t = sites[j];
  std::array<double, 3> lead{};  // squared distance from t minus that from s: positive where s is nearer
  for (int c = 0; c < 3; ++c) lead[c] = t.square[c] - s.square[c];
  End ends[3];
  if (find_ends(face, lead, ends) != 2) return;
  // The part of the line that no other region takes.
  double from = 0.0;
  double to = 1.0;
  Index from_site = no_index;
  Index to_site = no_index;
  for (std::size_t k = 0; k < sites.size() && from < to; ++k) {
    if (k == i || k == j) continue;
    const double a = value_at(sites[k].square, ends[0].at) - value_at(s.square, ends[0].at);
    const double b = value_at(sites[k].square, ends[1].at) - value_at(s.square, ends[1].at);
    if (a >= 0.0 && b >= 0.0) continue;
    if (a <= 0.0 && b <= 0.0) return;
    const double zero = a / (a - b);
    if (a < 0.0 && zero > from) {
      from = zero;
      from_site = sites[k].site;
    } else if (b < 0.0 && zero < to) {
      to = zero;
      to_site = sites[k].site;
    }
  }
  if (!(from < to)) return;
  const std::uint64_t line = line_of(s.site, t.site);
  auto end_point = [&](double at, Index site, const End& end) {
    if (site == no_index) return point_of(end, line);
    Barycentric inside{};
    for (int c = 0; c < 3; ++c) inside[c] = ends[0].at[c] + at * (ends[1].at[c] - ends[0].at[c]);
    std::array<Index, 3> meeting{s.site, t.site, site};
    std::sort(meeting.begin(), meeting.end());
    std::uint64_t corner = 0;
    for (Index m : meeting) corner = corner * 0x100000001B3ULL + static_cast<std::uint64_t>(m) + 1;
    return builder_.in_face(face, inside, corner);
  };
  const Index a = end_point(from, from_site, ends[0]);
  const Index b = end_point(to, to_site, ends[1]);
  if (builder_.add_segment(a, b)) border_regions_.push_back({s.site, t.site});
}

}  // namespace vorogeo
