// An index against the exact field: fields, pairs, paths, Voronoi regions, costs, and the same index loaded.
#include <algorithm>
#include <cmath>

#include "fuzz/hostile_case.h"
#include "query/path_query.h"
#include "support/indexes.h"
#include "support/temporary.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo::test {

namespace {

constexpr int pairs = 4;

/// Answers to be compared between the built and the loaded index.
struct Answers {
  std::vector<double> numbers;
  bool operator==(const Answers&) const = default;
};

class IndexCheck {
 public:
  explicit IndexCheck(HostileCase& hostile) : hostile_(hostile), mesh_(*hostile.mesh) {
    for (int i = 0; i < pairs; ++i) targets_.push_back(Index(hostile.random.below(mesh_.vertex_count())));
    const auto face = static_cast<Index>(hostile.random.below(mesh_.face_count()));
    const double u = hostile.random.uniform(0.0, 1.0);
    const double v = hostile.random.uniform(0.0, 1.0 - u);
    inside_ = SurfacePoint::in_face(face, {u, v, 1.0 - u - v});
  }

  const std::shared_ptr<const GeodesicIndex>& index() const { return index_; }
  const std::vector<Index>& targets() const { return targets_; }
  const SurfacePoint& inside() const { return inside_; }

  bool build();
  void check_fields();
  void check_pairs();
  void check_voronoi();
  void check_file();
  /// Several threads give the same answers and the same index as one.
  void check_threads();
  /// The quick field, an approximate answer without an index; its errors have no proven bound.
  void check_quick();

 private:
  void ask(const std::string& question) { hostile_.ask(hostile_.index_text() + question); }
  Answers answers_of(const std::shared_ptr<const GeodesicIndex>& index);

  HostileCase& hostile_;
  const Mesh& mesh_;
  std::vector<Index> targets_;
  SurfacePoint inside_;
  std::shared_ptr<const GeodesicIndex> index_;
};

bool IndexCheck::build() {
  ask("build");
  const bool extreme = mesh_.longest_edge_length() > 1e28 || mesh_.mean_edge_length() < 1e-28;
  const bool refusable =
      extreme || mesh_.face_count() < std::max(hostile_.options.first_layer_patches, Index{1});
  bool built = false;
  hostile_.costs[static_cast<int>(Step::build)] = cost_of([&] {
    built =
        hostile_.attempt([&] { index_ = GeodesicIndex::build(hostile_.mesh, hostile_.options); }, refusable);
  });
  if (built) {
    hostile_.patches = index_->statistics().second_layer_patches;
  } else {
    ++hostile_.tally.refused;
  }
  return built;
}

void IndexCheck::check_fields() {
  test::IndexQuery query(index_, 1);
  for (int i = 0; i < 2; ++i) {
    const Index source = hostile_.sources[i];
    const auto& exact = hostile_.exact[i];
    ask("field of vertex " + std::to_string(source));
    std::vector<double> field;
    hostile_.costs[static_cast<int>(Step::field)] =
        cost_of([&] { hostile_.attempt([&] { field = query.distance_field(std::array{source}); }); });
    if (field.empty()) return;
    hostile_.require_sound(field, source, 2.0);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      hostile_.note_error(ErrorKind::field, field[v], exact[v]);
      if (std::abs(field[v] - exact[v]) <= hostile_.greatest_error * exact[v] + hostile_.slack(exact[v]))
        continue;
      if (field[v] == exact[v]) continue;
      hostile_.fail("a field is far off", "vertex " + std::to_string(v) + ": " + exactly(field[v]) +
                                              ", exact " + exactly(exact[v]));
    }
  }
}

void IndexCheck::check_pairs() {
  test::IndexQuery query(index_, 1);
  hostile_.costs[static_cast<int>(Step::pairs)] = cost_of([&] {
    for (int i = 0; i < 2; ++i) {
      for (Index target : targets_) {
        const Index source = hostile_.sources[i];
        const double exact = hostile_.exact[i][target];
        ask("distance of vertices " + std::to_string(source) + " and " + std::to_string(target));
        hostile_.attempt([&] {
          const double distance = query.distance(source, target);
          const double back = query.distance(target, source);
          const std::string numbers = exactly(distance) + ", exact " + exactly(exact);
          if (distance != back)
            hostile_.fail("a pair is not symmetric", exactly(distance) + ", " + exactly(back));
          if (!(distance >= 0.0)) hostile_.fail("a negative distance or none", numbers);
          if ((distance < unreachable) != (exact < unreachable)) {
            hostile_.fail("reached or not, against the components", numbers);
          } else if (exact < unreachable && !(std::abs(distance - exact) <=
                                              hostile_.greatest_error * exact + hostile_.slack(exact))) {
            hostile_.fail("a pair is far off", numbers);
          }
          hostile_.note_error(ErrorKind::pair, distance, exact);
        });
      }
    }
  });
}

void IndexCheck::check_voronoi() {
  std::vector<SurfacePoint> sites{SurfacePoint::at_vertex(hostile_.sources[0]),
                                  SurfacePoint::at_vertex(hostile_.sources[1])};
  ask("Voronoi regions of vertices " + std::to_string(hostile_.sources[0]) + " and " +
      std::to_string(hostile_.sources[1]));
  VoronoiRegions regions;
  bool answered = false;
  hostile_.costs[static_cast<int>(Step::voronoi)] = cost_of([&] {
    answered = hostile_.attempt([&] {
      Surface surface(index_, 1);
      regions = voronoi_regions(surface, PointList(sites), {.by = Answer::index});
    });
  });
  if (!answered) return;
  double area = 0.0;
  double reached_area = 0.0;
  for (double a : regions.area) {
    if (!(a >= 0.0)) hostile_.fail("a region of negative area or none", exactly(a));
    area += a;
  }
  for (Index f = 0; f < mesh_.face_count(); ++f) {
    if (hostile_.exact[0][mesh_.face_vertices(f)[0]] < unreachable ||
        hostile_.exact[1][mesh_.face_vertices(f)[0]] < unreachable) {
      reached_area += mesh_.face_area(f);
    }
  }
  if (!(std::abs(area - reached_area) <= 1e-6 * reached_area)) {
    hostile_.fail("areas of regions are not the area of the surface",
                  exactly(area) + ", surface " + exactly(reached_area));
  }
  for (Index v = 0; v < mesh_.vertex_count(); ++v) {
    const std::array both{hostile_.exact[0][v], hostile_.exact[1][v]};
    const double nearest = std::min(both[0], both[1]);
    const Index region = regions.vertex_region[v];
    const std::string vertex = "vertex " + std::to_string(v) + ": region " + std::to_string(region) + " at " +
                               exactly(regions.distance[v]) + ", exact " + exactly(both[0]) + " and " +
                               exactly(both[1]);
    if (region < -1 || region > 1 || (region == no_index) != (nearest == unreachable)) {
      hostile_.fail("a vertex in a wrong region", vertex);
      continue;
    }
    if (region == no_index) continue;
    hostile_.note_error(ErrorKind::voronoi, regions.distance[v], nearest);
    if (!(std::abs(regions.distance[v] - nearest) <=
          hostile_.greatest_error * nearest + hostile_.slack(nearest)) ||
        both[region] > (1.0 + 2.0 * hostile_.greatest_error) * nearest + hostile_.slack(both[region])) {
      hostile_.fail("a vertex in a wrong region", vertex);
    }
  }
}

Answers IndexCheck::answers_of(const std::shared_ptr<const GeodesicIndex>& index) {
  Answers answers;
  test::IndexQuery query(index, 1);
  answers.numbers = query.distance_field(std::array{hostile_.sources[0]});
  for (Index target : targets_) answers.numbers.push_back(query.distance(hostile_.sources[1], target));
  PathQuery paths(index);
  for (const SurfacePath& path : {paths.path(SurfacePoint::at_vertex(hostile_.sources[1]), inside_),
                                  paths.exact_path(inside_, SurfacePoint::at_vertex(targets_[0])).path}) {
    answers.numbers.push_back(path.length);
    for (const SurfacePoint& point : path.points) {
      answers.numbers.push_back(point.vertex);
      answers.numbers.push_back(point.face);
      answers.numbers.insert(answers.numbers.end(), point.barycentric.begin(), point.barycentric.end());
    }
  }
  return answers;
}

void IndexCheck::check_file() {
  static const TemporaryFolder folder;
  ask("save, load and the same answers");
  hostile_.attempt([&] {
    const auto file = folder / "index";
    index_->save(file);
    const auto loaded = GeodesicIndex::load(file, hostile_.mesh);
    if (answers_of(index_) != answers_of(loaded)) hostile_.fail("a loaded index answers differently", "");
  });
}

void IndexCheck::check_threads() {
  const int threads = hostile_.random.one_in(2) ? 3 : 8;
  const std::string several = std::to_string(threads) + " threads";
  ask("field and Voronoi regions from " + several);
  hostile_.attempt([&] {
    const std::vector<double> alone =
        test::IndexQuery(index_, 1).distance_field(std::array{hostile_.sources[0]});
    const std::vector<double> shared =
        test::IndexQuery(index_, threads).distance_field(std::array{hostile_.sources[0]});
    hostile_.require_same(
        "several threads give another field", [&](Index v) { return alone[v]; },
        [&](Index v) { return shared[v]; });
    const std::vector<SurfacePoint> sites{SurfacePoint::at_vertex(hostile_.sources[0]),
                                          SurfacePoint::at_vertex(hostile_.sources[1])};
    auto regions = [&](int count) {
      Surface surface(index_, count);
      return voronoi_regions(surface, PointList(sites), {.by = Answer::index}).distance;
    };
    const std::vector<double> from_one = regions(1);
    const std::vector<double> from_several = regions(threads);
    hostile_.require_same(
        "several threads give other regions", [&](Index v) { return from_one[v]; },
        [&](Index v) { return from_several[v]; });
  });
  // Not on every mesh, as a build takes longer than everything else.
  if (!hostile_.random.one_in(4)) return;
  ask("build by " + several);
  hostile_.attempt([&] {
    static const TemporaryFolder folder;
    IndexOptions options = hostile_.options;
    options.threads = threads;
    index_->save(folder / "alone");
    GeodesicIndex::build(hostile_.mesh, options)->save(folder / "several");
    if (read_bytes(folder / "alone") != read_bytes(folder / "several"))
      hostile_.fail("several threads build another index", several);
  });
}

void IndexCheck::check_quick() {
  const Index source = hostile_.sources[0];
  hostile_.ask("quick field of vertex " + std::to_string(source));
  hostile_.attempt([&] {
    Surface surface(index_, 1);
    Answered answered;
    const std::vector<ExactSource> sources = sources_at(std::array{source});
    const std::vector<double> field = surface.field(sources, unreachable, Answer::quick, answered).distance;
    if (field[source] != 0.0) hostile_.fail("the source is not at distance 0", exactly(field[source]));
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const double exact = hostile_.exact[0][v];
      const std::string vertex =
          "vertex " + std::to_string(v) + ": " + exactly(field[v]) + ", exact " + exactly(exact);
      if (!(field[v] >= 0.0)) hostile_.fail("a negative distance or none", vertex);
      if ((field[v] < unreachable) != (exact < unreachable))
        hostile_.fail("reached or not, against the components", vertex);
      if (std::abs(field[v] - exact) > hostile_.greatest_error * exact + hostile_.slack(exact))
        hostile_.fail("a quick field errs", vertex);
      hostile_.note_error(ErrorKind::quick, field[v], exact);
    }
  });
}

}  // namespace

void check_index(HostileCase& hostile) {
  if (hostile.exact[1].empty()) return;
  IndexCheck check(hostile);
  if (!check.build()) return;
  check.check_fields();
  check.check_pairs();
  check_paths(hostile, check.index(), check.targets(), check.inside());
  check.check_voronoi();
  check.check_file();
  if (hostile.seed == scan_seed) return;
  check.check_threads();
  check.check_quick();
  check_index_laws(hostile, check.index());
}

}  // namespace vorogeo::test
