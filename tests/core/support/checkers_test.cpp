// The checkers themselves: the path check finds each kind of fault, the PLY reader refuses what it cannot
// read.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "support/path_check.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo::test {
namespace {

TEST(PathCheck, FindsEachFault) {
  // Vertices 0 1 2 / 3 4 5 / 6 7 8.
  const auto mesh = make_mesh(plane_grid(2, 2, 2.0, 2.0).soup);
  auto at = [](Index v) { return SurfacePoint::at_vertex(v); };
  EXPECT_EQ(path_fault(*mesh, {{at(0), at(4), at(5)}, std::sqrt(2.0) + 1.0}, at(0), at(5)), "");
  EXPECT_EQ(path_fault(*mesh, {{}, 0.0}, at(0), at(5)), "the path is empty");
  EXPECT_EQ(path_fault(*mesh, {{at(1), at(4)}, 1.0}, at(0), at(4)), "it does not begin at the target");
  EXPECT_EQ(path_fault(*mesh, {{at(1), at(4)}, 1.0}, at(1), at(5)), "it does not end at the source");
  EXPECT_EQ(path_fault(*mesh, {{at(0), at(2)}, 2.0}, at(0), at(2)), "points 0 and 1 share no face");
  EXPECT_NE(path_fault(*mesh, {{at(0), at(1), at(2)}, 1.9}, at(0), at(2)), "");
  // A point on the edge between two faces is in both; a point beside the edge is not.
  const auto& face = mesh->face_vertices(0);
  EXPECT_EQ(face, (std::array<Index, 3>{0, 1, 4}));
  const auto on_diagonal = SurfacePoint::in_face(0, {0.5, 0.0, 0.5});
  EXPECT_EQ(path_fault(*mesh, {{at(3), on_diagonal}, std::sqrt(0.5)}, at(3), on_diagonal), "");
  const auto inside = SurfacePoint::in_face(0, {0.5, 0.25, 0.25});
  EXPECT_EQ(path_fault(*mesh, {{at(3), inside}, 0.0}, at(3), inside), "points 0 and 1 share no face");
}

class PlyFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& bytes) const {
    std::ofstream(file_, std::ios::binary) << bytes;
    return file_;
  }
  void TearDown() override { std::filesystem::remove(file_); }

  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() /
      (std::string("vorogeo_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".ply");
  const std::string header_ =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
};

TEST_F(PlyFile, ReadsVerticesAndFaces) {
  const std::string one("\x00\x00\x80\x3f", 4);
  const std::string index("\x00\x00\x00\x00", 4);
  const Soup soup = read_ply(write(header_ + one + one + one + "\x03" + index + index + index));
  EXPECT_EQ(soup.positions, (std::vector<Point>{{1, 1, 1}}));
  EXPECT_EQ(soup.faces, (std::vector<std::array<Index, 3>>{{0, 0, 0}}));
}

TEST_F(PlyFile, RefusesWhatItCannotRead) {
  EXPECT_THROW(read_ply(write("solid")), std::runtime_error);
  EXPECT_THROW(read_ply(write("ply\nformat ascii 1.0\nend_header\n")), std::runtime_error);
  EXPECT_THROW(read_ply(write(header_ + "abc")), std::runtime_error);
  EXPECT_THROW(read_ply("/no/such/file.ply"), std::runtime_error);
}

}  // namespace
}  // namespace vorogeo::test
