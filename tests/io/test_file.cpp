// Files on disk: what cannot be read says why, and what cannot be written leaves the old file alone.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <quadmatch/io/file.hpp>

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
namespace fs = std::filesystem;

namespace {

/// A folder of its own for a test, removed afterwards.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("quadmatch-test-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }

  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  fs::path path_;
};

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_plainly(const std::string& path, std::string_view text) { std::ofstream(path, std::ios::binary) << text; }

std::string refusal(const Expected<void>& result) {
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().code == ErrorCode::CannotWrite);
  return result.error().message;
}

}  // namespace

TEST_CASE("a file is read whole, with line feeds behind it") {
  const Folder folder;
  const std::string bytes("a\0b\r\n", 5);
  write_plainly(folder / "x", bytes);
  const Expected<FileBytes> file = read_file(folder / "x");
  REQUIRE(file.has_value());
  CHECK(file->view() == bytes);
  CHECK(std::string_view(file->end(), FileBytes::kPadding) == std::string(FileBytes::kPadding, '\n'));
  write_plainly(folder / "empty", "");
  CHECK(read_file(folder / "empty")->size() == 0);
}

TEST_CASE("a large file that does not tell its size is read whole") {
  const Folder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const std::string text(3'000'000, 'x');
  const pid_t writer = ::fork();
  if (writer == 0) {
    write_plainly(pipe, text);
    ::_exit(0);
  }
  const Expected<FileBytes> file = read_file(pipe);
  REQUIRE(file.has_value());
  CHECK(file->view() == text);
}

TEST_CASE("what cannot be read says why") {
  const Folder folder;
  const auto complaint_about = [](const std::string& path) {
    const Expected<MeshFile> file = read_mesh(path);
    REQUIRE_FALSE(file.has_value());
    CHECK(file.error().code == ErrorCode::CannotRead);
    CHECK(file.error().path == path);
    return file.error().message;
  };
  CHECK(complaint_about(folder / "none.obj") == "there is no such file; check the name and the folder");
  CHECK(complaint_about(folder / "none/none.obj") == "there is no such file; check the name and the folder");
  fs::create_directory(folder / "folder.obj");
  CHECK(complaint_about(folder / "folder.obj") == "this is a folder; name a file in it");
  CHECK(complaint_about("") == "there is no such file; check the name and the folder");
  const Expected<MatchFile> match = read_match(folder / "none.json");
  REQUIRE_FALSE(match.has_value());
  CHECK(match.error().code == ErrorCode::CannotRead);
}

TEST_CASE("a mesh goes through a file of every format") {
  const Folder folder;
  const MeshFile original = parsed(kFullObj, Format::Obj);
  for (const char* const name : {"a.obj", "a.ply", "a.off", "a.usda", "a.OBJ"}) {
    CAPTURE(name);
    REQUIRE(write_mesh(folder / name, original).has_value());
    const Expected<MeshFile> again = read_mesh(folder / name);
    REQUIRE(again.has_value());
    check_same_mesh(original.mesh, again->mesh);
    CHECK(again->path == folder / name);
  }
  const Expected<void> unknown = write_mesh(folder / "a.stl", original);
  REQUIRE_FALSE(unknown.has_value());
  CHECK(unknown.error().code == ErrorCode::UnknownFormat);
  CHECK_FALSE(fs::exists(folder / "a.stl"));
}

TEST_CASE("a match goes through a file") {
  const Folder folder;
  const Expected<MatchFile> match = parse_match(kMatch, "match");
  REQUIRE(match.has_value());
  REQUIRE(write_match(folder / "m.json", *match).has_value());
  const Expected<MatchFile> again = read_match(folder / "m.json");
  REQUIRE(again.has_value());
  CHECK(again->match.matched_faces() == 2);
}

TEST_CASE("replacing a file keeps its mode and leaves nothing beside it") {
  const Folder folder;
  const std::string path = folder / "x";
  write_plainly(path, "old");
  fs::permissions(path, fs::perms(0640));
  REQUIRE(replace_file(path, "new").has_value());
  CHECK(content(path) == "new");
  CHECK(fs::status(path).permissions() == fs::perms(0640));
  CHECK(folder.entries() == 1);
}

TEST_CASE("a symbolic link stays, and what it leads to is replaced") {
  const Folder folder;
  fs::create_directory(folder / "elsewhere");
  write_plainly(folder / "elsewhere/real", "old");
  fs::create_symlink("elsewhere/real", folder / "link");
  fs::create_symlink("link", folder / "link to link");
  REQUIRE(replace_file(folder / "link to link", "new").has_value());
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(content(folder / "elsewhere/real") == "new");
  fs::create_symlink("elsewhere/made", folder / "dangling");
  REQUIRE(replace_file(folder / "dangling", "made").has_value());
  CHECK(content(folder / "elsewhere/made") == "made");
  CHECK(fs::is_symlink(folder / "dangling"));
}

TEST_CASE("what cannot be written leaves everything as it was") {
  const Folder folder;
  write_plainly(folder / "file", "old");
  CHECK(refusal(replace_file(folder / "file/below", "new")) ==
        "there is no such folder; create it or choose another place");
  CHECK(refusal(replace_file(folder / "none/file", "new")) ==
        "there is no such folder; create it or choose another place");
  fs::create_directory(folder / "folder");
  CHECK(refusal(replace_file(folder / "folder", "new")) == "this is a folder; name a file in it");
  CHECK(content(folder / "file") == "old");
  CHECK(folder.entries() == 2);
}

TEST_CASE("a full disk is reported and the temporary file is gone") {
  if (::access("/dev/full", W_OK) != 0) return;
  CHECK(refusal(replace_file("/dev/full", "new")) ==
        "the file cannot be written (No space left on device); make room or choose another place");
}

TEST_CASE("a file-size limit in the middle of writing leaves the old file whole") {
  const Folder folder;
  const std::string path = folder / "x";
  write_plainly(path, "old");
  // In a child, since the limit would stay.
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN);
    ::_exit(replace_file(path, std::string(5000, 'n')).has_value() ? 1 : 0);
  }
  int status = -1;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(content(path) == "old");
  CHECK(folder.entries() == 1);
}
