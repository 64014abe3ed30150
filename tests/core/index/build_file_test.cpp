// Indexes built in a file: the same to the last bit as one that is built in memory and saved, however often
// the build is stopped; no unfinished file is loaded, and other meshes and options are refused.
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <random>
#include <set>
#include <thread>

#include "index/geodesic_index.h"
#include "index/index_file.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/refusal.h"
#include "support/shapes.h"
#include "support/temporary.h"

namespace {

/// Whether files are read and written as over a bad network: interrupted every other time, else in part.
std::atomic<bool> is_slow = false;

/// Makes them so as long as it lives, also where a refusal ends the test.
struct SlowFiles {
  SlowFiles() { is_slow = true; }
  ~SlowFiles() { is_slow = false; }
  SlowFiles(const SlowFiles&) = delete;
  SlowFiles& operator=(const SlowFiles&) = delete;
};

template <class Call>
ssize_t slowly(std::size_t size, Call&& call) {
  static std::atomic<unsigned> calls = 0;
  if (!is_slow) return call(size);
  const unsigned number = ++calls;
  if (number % 2 == 0) {
    errno = EINTR;
    return -1;
  }
  return call(std::min<std::size_t>(size, 1 + 997 * number % 4096));
}

}  // namespace

/// They replace the system's functions.
extern "C" ssize_t pread(int file, void* bytes, std::size_t size, off_t at) {
  return slowly(size, [&](std::size_t part) { return ::syscall(SYS_pread64, file, bytes, part, at); });
}
extern "C" ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t at) {
  return slowly(size, [&](std::size_t part) { return ::syscall(SYS_pwrite64, file, bytes, part, at); });
}

namespace vorogeo {
namespace {

using test::read_bytes;
using test::Soup;
using test::TemporaryFolder;
using test::write_bytes;

IndexOptions options_of(Index first, Index second, double delta = 0.0) {
  IndexOptions options;
  options.first_layer_patches = first;
  options.second_layer_patches = second;
  options.delta = delta;
  return options;
}

/// The sentence with which a build is refused, or "built".
std::string building(const std::filesystem::path& file, const Soup& soup, const IndexOptions& options,
                     const Progress& progress = {}) {
  try {
    GeodesicIndex::build_in_file(file, test::make_mesh(soup), options, progress);
  } catch (const IndexFileError& error) {
    return error.what();
  } catch (const Cancelled&) {
    return "cancelled";
  }
  return "built";
}

/// Cancels at the report of this number.
Progress cancelled_at(int report) {
  return Progress([left = report](double, const std::string&) mutable { return left-- > 0; });
}

/// The bytes of the index that is built in memory and saved.
std::string saved_bytes(const Soup& soup, const IndexOptions& options) {
  const TemporaryFolder folder;
  GeodesicIndex::build(test::make_mesh(soup), options)->save(folder / "a.vgi");
  return read_bytes(folder / "a.vgi");
}

TEST(BuildFile, EqualsASavedIndexInBothForms) {
  const Soup two = test::two_components(test::icosphere(2), test::hills(12, 0.2));
  for (const Soup& soup : {test::icosphere(3), test::with_isolated_vertex(two, {9, 9, 9}),
                           Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}) {
    const auto most = static_cast<Index>(soup.faces.size());
    for (double delta : {0.0, 0.01}) {
      const TemporaryFolder folder;
      const IndexOptions options = options_of(std::min(3, most), std::min(4, most), delta);
      const auto index = GeodesicIndex::build_in_file(folder / "a.vgi", test::make_mesh(soup), options);
      EXPECT_EQ(read_bytes(folder / "a.vgi"), saved_bytes(soup, options));
      EXPECT_EQ(folder.files(), (std::set<std::string>{"a.vgi"}));
      const auto loaded = GeodesicIndex::load(folder / "a.vgi", test::make_mesh(soup));
      EXPECT_EQ(index->statistics().bytes, loaded->statistics().bytes);
      EXPECT_EQ(index->statistics().mapped_bytes, loaded->statistics().mapped_bytes);
      index->save(folder / "b.vgi");
      EXPECT_EQ(read_bytes(folder / "b.vgi"), read_bytes(folder / "a.vgi"));
    }
  }
}

TEST(BuildFile, AFolderThatMayNotBeWrittenIsNamedBeforeTablesAreFilled) {
  const TemporaryFolder folder;
  const Soup soup = test::hills(12, 0.2);
  const auto index = test::make_index(soup, 3, 3);
  std::filesystem::permissions(folder / "", std::filesystem::perms(0555));
  const test::PlainUser user(folder);
  VOROGEO_NEEDS_BOUND(user);
  const std::string reason =
      " cannot be written (Permission denied); check that its folder may be written to, or name another "
      "file.";
  EXPECT_EQ(building(folder / "a.vgi", soup, options_of(3, 3)),
            "The index file " + (folder / "a.vgi.unfinished").string() + reason);
  EXPECT_EQ(test::refusal<IndexFileError>([&] { index->save(folder / "a.vgi"); }),
            "The index file " + (folder / "a.vgi").string() + reason);
  EXPECT_TRUE(folder.files().empty());
}

TEST(BuildFile, EqualsASavedIndexWhereFilesAreSlow) {
  const Soup soup = test::hills(24, 0.2);
  for (double delta : {0.0, 0.01}) {
    const TemporaryFolder folder;
    const IndexOptions options = options_of(3, 4, delta);
    const std::string expected = saved_bytes(soup, options);
    {
      const SlowFiles slow;
      EXPECT_EQ(saved_bytes(soup, options), expected);
      EXPECT_EQ(building(folder / "a.vgi", soup, options, cancelled_at(8)), "cancelled");
      EXPECT_EQ(building(folder / "a.vgi", soup, options), "built") << "goes on";
    }
    EXPECT_EQ(read_bytes(folder / "a.vgi"), expected);
  }
}

TEST(BuildFile, GoesOnAfterItWasCancelled) {
  const Soup soup = test::hills(40, 0.2);
  for (double delta : {0.0, 0.01}) {
    const TemporaryFolder folder;
    IndexOptions options = options_of(5, 4, delta);
    options.threads = 2;
    int stops = 0;
    while (building(folder / "a.vgi", soup, options, cancelled_at(8 + 6 * stops)) == "cancelled") {
      ++stops;
      EXPECT_FALSE(std::filesystem::exists(folder / "a.vgi"));
      ASSERT_LT(stops, 1000);
    }
    EXPECT_GT(stops, 0);
    EXPECT_EQ(read_bytes(folder / "a.vgi"), saved_bytes(soup, options));
    EXPECT_EQ(folder.files(), (std::set<std::string>{"a.vgi"}));
  }
}

/// The number of kills: VOROGEO_KILLS, or six by default.
int kill_count() {
  const char* wanted = std::getenv("VOROGEO_KILLS");
  return wanted == nullptr ? 6 : std::max(1, std::atoi(wanted));
}

TEST(BuildFile, GoesOnAfterKillAtAnyMoment) {
  const TemporaryFolder folder;
  const auto file = folder / "a.vgi";
  const auto unfinished = folder / "a.vgi.unfinished";
  const Soup soup = test::hills(50, 0.2);
  const IndexOptions options = options_of(5, 4);
  const auto start = std::chrono::steady_clock::now();
  const std::string whole = saved_bytes(soup, options);
  const std::chrono::duration<double> whole_build = std::chrono::steady_clock::now() - start;
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> moment(0.0, 1.2);
  bool left_something = false;
  const int kills = kill_count();
  for (int kill = 0; kill < kills; ++kill) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      building(file, soup, options);
      ::_exit(0);
    }
    if (kill == 0) {
      // The other kills come at random moments; this one waits for an unfinished file.
      for (int look = 0; look < 10000 && !std::filesystem::exists(unfinished); ++look)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } else {
      std::this_thread::sleep_for(moment(random) * whole_build);
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    if (std::filesystem::exists(unfinished)) {
      left_something = true;
      // The file is complete, and only not renamed yet; or it is refused.
      ASSERT_TRUE(read_bytes(unfinished) == whole ||
                  test::loading(unfinished, test::make_mesh(soup)) != "loaded");
    }
    // Every third build runs to its end; a file of that name is always complete.
    if (kill % 3 == 2) {
      ASSERT_EQ(building(file, soup, options), "built");
    }
    if (!std::filesystem::exists(file)) continue;
    ASSERT_EQ(read_bytes(file), whole) << "after " << kill + 1 << " kills";
    ASSERT_FALSE(kill % 3 == 2 && std::filesystem::exists(unfinished));
    std::filesystem::remove(file);
  }
  EXPECT_TRUE(left_something);
  EXPECT_EQ(building(file, soup, options), "built");
  EXPECT_EQ(read_bytes(file), whole);
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a.vgi"}));
}

TEST(BuildFile, WhatIsThereIsLoadedOrRefused) {
  const TemporaryFolder folder;
  const auto file = folder / "a.vgi";
  const Soup soup = test::icosphere(3);
  EXPECT_EQ(building(file, soup, options_of(3, 4)), "built");
  const auto written = std::filesystem::last_write_time(file);
  const auto index = GeodesicIndex::build_in_file(file, test::make_mesh(soup), options_of(3, 4));
  EXPECT_EQ(index->statistics().seconds, 0.0) << "loaded";
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  const std::string name = "The index file " + file.string();
  Soup moved = soup;
  moved.positions[17][1] = std::nextafter(moved.positions[17][1], 2.0);
  EXPECT_EQ(building(file, moved, options_of(3, 4)),
            name + " is of another mesh, or this mesh was edited since; remove it or name another file.");
  const std::string other = name + " has other options; remove it or name another file.";
  IndexOptions seeded = options_of(3, 4);
  seeded.seed = 1;
  for (const IndexOptions& options : {options_of(4, 4), options_of(3, 0), options_of(3, 4, 0.01), seeded}) {
    EXPECT_EQ(building(file, soup, options), other);
  }
  write_bytes(file, "something else, longer than the head of an index");
  EXPECT_EQ(building(file, soup, options_of(3, 4)), file.string() + " is not an index file of VoroGeo.");
}

/// Where an unfinished file has the form of its index: behind magic number, version, fingerprint, delta, seed
/// and pairs.
constexpr std::size_t form_in_unfinished = 56;

TEST(BuildFile, AnUnfinishedFileIsNoIndexAndBelongsToItsMesh) {
  const TemporaryFolder folder;
  const auto unfinished = folder / "a.vgi.unfinished";
  const Soup soup = test::hills(30, 0.2);
  const IndexOptions options = options_of(4, 4);
  // Cancelled as soon as tables are being filled.
  const Progress early([](double, const std::string& what) { return !what.starts_with("Composing"); });
  ASSERT_EQ(building(folder / "a.vgi", soup, options, early), "cancelled");
  EXPECT_EQ(test::loading(unfinished, test::make_mesh(soup)),
            unfinished.string() + " is not an index file of VoroGeo.");
  const std::string name = "The unfinished index file " + unfinished.string();
  EXPECT_EQ(building(folder / "a.vgi", test::icosphere(2), options),
            name + " is of another mesh, or this mesh was edited since; remove it or name another file.");
  EXPECT_EQ(building(folder / "a.vgi", soup, options_of(4, 5)),
            name + " has other options; remove it or name another file.");
  std::string bytes = read_bytes(unfinished);
  std::string of_graph = bytes;
  of_graph[form_in_unfinished] ^= 1;
  write_bytes(unfinished, of_graph);
  EXPECT_EQ(building(folder / "a.vgi", soup, options),
            name +
                " was begun with another memory budget or by another version of VoroGeo; remove it or name "
                "another file.");

  // Damaged parts are filled anew.
  for (std::size_t at = 1 << 14; at < bytes.size(); at += 1 << 14)
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
  write_bytes(unfinished, bytes);
  EXPECT_EQ(building(folder / "a.vgi", soup, options), "built");
  EXPECT_EQ(read_bytes(folder / "a.vgi"), saved_bytes(soup, options));

  // Killed after the file was complete, before or after leftover space was cut off.
  bytes = read_bytes(folder / "a.vgi");
  for (const std::size_t leftover : {0, 10000}) {
    write_bytes(unfinished, bytes + std::string(leftover, 'x'));
    std::filesystem::remove(folder / "a.vgi");
    const auto index = GeodesicIndex::build_in_file(folder / "a.vgi", test::make_mesh(soup), options);
    EXPECT_EQ(index->statistics().seconds, 0.0) << "loaded";
    EXPECT_EQ(read_bytes(folder / "a.vgi"), bytes);
    EXPECT_EQ(folder.files(), (std::set<std::string>{"a.vgi"}));
  }
  // If such a file is damaged, it is built anew.
  std::string damaged = bytes;
  damaged[bytes.size() / 2] = static_cast<char>(damaged[bytes.size() / 2] ^ 4);
  for (const std::string& broken : {damaged, bytes.substr(0, bytes.size() - 100), bytes.substr(0, 300)}) {
    write_bytes(unfinished, broken);
    std::filesystem::remove(folder / "a.vgi");
    EXPECT_EQ(building(folder / "a.vgi", soup, options), "built");
    EXPECT_EQ(read_bytes(folder / "a.vgi"), bytes);
  }
  // Killed before the head was written.
  std::filesystem::remove(folder / "a.vgi");
  write_bytes(unfinished, std::string(5000, '\0'));
  EXPECT_EQ(building(folder / "a.vgi", soup, options), "built");
  std::filesystem::remove(folder / "a.vgi");
  write_bytes(unfinished, std::string(5000, 'x'));
  EXPECT_EQ(building(folder / "a.vgi", soup, options),
            name + " is none of VoroGeo's; remove it or name another file.");
}

TEST(BuildFile, AFullDiskIsNamedBeforeTablesAreFilled) {
  const TemporaryFolder folder;
  std::optional<test::FileSizeLimit> limit(1 << 14);
  const std::string message = building(folder / "a.vgi", test::icosphere(3), options_of(3, 4));
  limit.reset();
  EXPECT_TRUE(message.starts_with("The index file " + (folder / "a.vgi").string() +
                                  " cannot be written: building it takes "))
      << message;
  EXPECT_TRUE(message.ends_with("free space or name a file on another disk.")) << message;
  EXPECT_TRUE(folder.files().empty());
}

TEST(BuildFile, ABuildThatGoesOnTakesTheSpaceThatACopyHasLost) {
  const TemporaryFolder folder;
  const auto unfinished = folder / "a.vgi.unfinished";
  const Soup soup = test::hills(30, 0.2);
  const Progress early([](double, const std::string& what) { return !what.starts_with("Composing"); });
  ASSERT_EQ(building(folder / "a.vgi", soup, options_of(4, 4), early), "cancelled");
  auto space = [&] {
    struct stat found {};
    EXPECT_EQ(::stat(unfinished.c_str(), &found), 0);
    return std::pair(512 * std::int64_t{found.st_blocks}, std::int64_t{found.st_size});
  };
  const std::int64_t size = space().second;
  EXPECT_GE(space().first, size);
  // The file has only its filled part, followed by a hole.
  const std::string head = read_bytes(unfinished).substr(0, 1 << 12);
  std::filesystem::remove(unfinished);
  write_bytes(unfinished, head);
  std::filesystem::resize_file(unfinished, static_cast<std::uintmax_t>(size));
  ASSERT_LT(space().first, size);
  ASSERT_EQ(building(folder / "a.vgi", soup, options_of(4, 4), early), "cancelled");
  EXPECT_GE(space().first, size);
  EXPECT_EQ(building(folder / "a.vgi", soup, options_of(4, 4)), "built");
  EXPECT_EQ(read_bytes(folder / "a.vgi"), saved_bytes(soup, options_of(4, 4)));
}

TEST(BuildFile, OneProcessAtATime) {
  const TemporaryFolder folder;
  const auto unfinished = folder / "a.vgi.unfinished";
  write_bytes(unfinished, "");
  const int other = ::open(unfinished.c_str(), O_RDWR);
  ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(building(folder / "a.vgi", test::icosphere(2), options_of(2, 2)),
            "The index file " + unfinished.string() +
                " is being written by another process; wait for it or name another file.");
  ::close(other);
  EXPECT_EQ(building(folder / "a.vgi", test::icosphere(2), options_of(2, 2)), "built");
}

}  // namespace
}  // namespace vorogeo
