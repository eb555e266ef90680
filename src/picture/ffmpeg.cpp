// GIF and MP4 by the program ffmpeg: frames go to its standard input, and what it makes into a file without a name, so
// that nothing stays behind whatever happens.

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "encode.hpp"

namespace quadmatch::picture {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, Close>;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

Error failure(std::string_view reason) {
  return {ErrorCode::CannotWrite, fmt::format("ffmpeg did not make the animation: {}", reason)};
}

std::vector<std::string> command_of(const MatchDrawing& drawing, const Raster& first, Film film, int output) {
  std::vector<std::string> words{"ffmpeg", "-v", "error", "-nostats", "-y", "-f", "rawvideo", "-pixel_format", "rgb24"};
  const auto add = [&words](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
  add({"-video_size", fmt::format("{}x{}", first.width, first.height)});
  add({"-framerate", fmt::format("1000/{}", frame_milliseconds(drawing)), "-i", "pipe:0"});
  // The same bytes every time: one thread, and no version or date in the file.
  add({"-threads", "1", "-filter_threads", "1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata",
       "-1"});
  if (film == Film::Gif) {
    add({"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none", "-loop", "0", "-f", "gif"});
  } else {
    // Players want even sizes and this order of colours.
    add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-preset", "medium", "-crf", "18",
         "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4"});
  }
  add({fmt::format("/dev/fd/{}", output)});
  return words;
}

/// Start a program; 0, or the reason why not.
int start(std::vector<std::string> words, int input, int messages, pid_t& process) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
  const int reason = ::posix_spawnp(&process, pointers.front(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return reason;
}

/// Send all of a frame, as long as anybody listens.
bool send_all(int socket, const Raster& raster) {
  const std::uint8_t* bytes = raster.rgb.data();
  std::size_t left = raster.rgb.size();
  while (left > 0) {
    const ssize_t sent = ::send(socket, bytes, left, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes += sent;
    left -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// All frames; the last as often as it takes to stand longer.
bool send_frames(int socket, const MatchDrawing& drawing) {
  const std::size_t count = drawing.frame_count();
  const std::uint32_t step = frame_milliseconds(drawing);
  for (std::size_t k = 0; k < count; ++k) {
    const Raster raster = drawing.frame(k);
    const std::uint32_t times = k + 1 < count ? 1 : (kLastMilliseconds + step - 1) / step;
    for (std::uint32_t time = 0; time < times; ++time) {
      if (!send_all(socket, raster)) return false;
    }
  }
  return true;
}

/// All that another process wrote.
std::string content_of(int descriptor) {
  std::string content;
  std::array<char, 65536> part = {};
  for (off_t at = 0;;) {
    const ssize_t size = ::pread(descriptor, part.data(), part.size(), at);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return content;
    content.append(part.data(), static_cast<std::size_t>(size));
    at += size;
  }
}

/// The last line of what it said.
std::string complaint_of(int messages) {
  std::string text = content_of(messages);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t line = text.rfind('\n');
  if (text.empty()) return "it did not say why";
  return line == std::string::npos ? text : text.substr(line + 1);
}

int wait_for(pid_t process) {
  int status = -1;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {}
  return status;
}

}  // namespace

bool has_ffmpeg() {
  const char* const path = std::getenv("PATH");
  std::string_view folders = path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const std::string program = fmt::format("{}/ffmpeg", folders.substr(0, end));
    if (::access(program.c_str(), X_OK) == 0) return true;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return false;
}

Expected<std::string> by_ffmpeg(const MatchDrawing& drawing, Film film) {
  const TemporaryFile made(std::tmpfile());
  const TemporaryFile messages(std::tmpfile());
  std::array<int, 2> ends = {-1, -1};
  if (!made || !messages || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return Unexpected(failure("there is no room for temporary files"));
  }
  Descriptor ours(ends[0]), theirs(ends[1]);
  pid_t process = 0;
  const std::vector<std::string> command = command_of(drawing, drawing.frame(0), film, ::fileno(made.get()));
  if (start(command, theirs.number(), ::fileno(messages.get()), process) != 0) {
    return Unexpected(failure("it could not be started; is it installed?"));
  }
  theirs.close();
  const bool sent = send_frames(ours.number(), drawing);
  ours.close();
  if (wait_for(process) != 0 || !sent) return Unexpected(failure(complaint_of(::fileno(messages.get()))));
  std::string bytes = content_of(::fileno(made.get()));
  if (bytes.empty()) return Unexpected(failure("it made an empty file"));
  return bytes;
}

}  // namespace quadmatch::picture
