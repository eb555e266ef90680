#include "picture_options.hpp"

#include <charconv>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "console.hpp"
#include "inputs.hpp"

namespace quadmatch::cli {
namespace {

constexpr std::uint32_t kLeast = 16;
constexpr std::uint32_t kMost = 8192;

const std::map<std::string, PictureView> kViews{{"home", PictureView::Home},   {"front", PictureView::Front},
                                                {"back", PictureView::Back},   {"left", PictureView::Left},
                                                {"right", PictureView::Right}, {"above", PictureView::Above},
                                                {"below", PictureView::Below}};

/// "1280x640"; nothing where it reads otherwise or is out of range.
std::optional<PictureOptions> parse_size(const std::string& text) {
  PictureOptions options;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, options.height);
  if (height.ec != std::errc() || height.ptr != end) return std::nullopt;
  const auto in_range = [](std::uint32_t pixels) { return pixels >= kLeast && pixels <= kMost; };
  if (!in_range(options.width) || !in_range(options.height)) return std::nullopt;
  return options;
}

std::optional<PictureOptions> options_of(const PictureWishes& wishes) {
  std::optional<PictureOptions> options = wishes.size.empty() ? PictureOptions{} : parse_size(wishes.size);
  if (options && !wishes.view.empty()) options->view = kViews.at(wishes.view);
  return options;
}

/// Is a name free for one option's file?
bool name_fits(const char* option, const std::string& path, const std::vector<std::string>& inputs,
               const std::vector<std::string>& outputs) {
  if (path.empty()) return true;
  if (path == "-") {
    complain(fmt::format("{} needs the name of a file; - is for standard output, which has the figures", option));
    return false;
  }
  for (const std::string& other : outputs) {
    if (other.empty() || other == "-" || !same_file(path, other)) continue;
    complain(
        fmt::format("{}: {} and another option name the same file; choose another name for one of them", path, option));
    return false;
  }
  return paths_fit(inputs, path, option);
}

bool able(const Expected<void>& answer) {
  if (!answer) complain(answer.error());
  return answer.has_value();
}

}  // namespace

std::vector<std::string> PictureWishes::files() const {
  std::vector<std::string> names;
  for (const std::string& name : {image, animation}) {
    if (!name.empty()) names.push_back(name);
  }
  return names;
}

void add_picture_options(CLI::App& verb, PictureWishes& wishes, bool grows) {
  verb.add_option("--image", wishes.image,
                  "Picture to write (PNG): both meshes side by side, red where a face has no partner")
      ->type_name("FILE");
  if (grows) {
    verb.add_option("--animation", wishes.animation,
                    "Film of the growth to write, wave by wave, and then the picture: .webp, or .gif and .mp4 by the "
                    "program ffmpeg")
        ->type_name("FILE");
  }
  verb.add_option("--image-size", wishes.size, "Pixels of the whole picture (default: 1280x640)")->type_name("WxH");
  verb.add_option("--image-view", wishes.view,
                  "From where: home, as a report begins (default), front, back, left, right, above or below")
      ->check(CLI::IsMember(kViews).description(""))
      ->type_name("NAME");
}

bool pictures_fit(const PictureWishes& wishes, const std::vector<std::string>& inputs,
                  const std::vector<std::string>& outputs) {
  if (!wishes.any()) {
    if (wishes.size.empty() && wishes.view.empty()) return true;
    complain(fmt::format("{} is about a picture, and none is asked for; add --image FILE",
                         wishes.size.empty() ? "--image-view" : "--image-size"));
    return false;
  }
  if (!options_of(wishes)) {
    complain(fmt::format("--image-size {}: a size is a width and a height in pixels from {} to {}, such as 1280x640",
                         wishes.size, kLeast, kMost));
    return false;
  }
  std::vector<std::string> others = outputs;
  if (!name_fits("--image", wishes.image, inputs, others)) return false;
  others.push_back(wishes.image);
  if (!name_fits("--animation", wishes.animation, inputs, others)) return false;
  return (wishes.image.empty() || able(can_write_image(wishes.image))) &&
         (wishes.animation.empty() || able(can_write_animation(wishes.animation)));
}

bool write_pictures(const PictureWishes& wishes, const MeshFile& source, const MeshFile& target, const Match& match) {
  if (!wishes.any()) return true;
  Expected<MatchDrawing> drawing = MatchDrawing::make(source, target, match, *options_of(wishes));
  if (!drawing) {
    drawing.error().path = display_name(drawing.error().path);
    complain(drawing.error());
    return false;
  }
  return (wishes.image.empty() || able(write_image(wishes.image, *drawing))) &&
         (wishes.animation.empty() || able(write_animation(wishes.animation, *drawing)));
}

}  // namespace quadmatch::cli
