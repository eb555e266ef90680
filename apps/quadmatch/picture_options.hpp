#pragma once
/// --image FILE and --animation FILE: pictures a verb writes for documents, tickets and logs (picture/picture.hpp).

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <quadmatch/picture/picture.hpp>

namespace quadmatch::cli {

struct PictureWishes {
  std::string image;      ///< empty: none
  std::string animation;  ///< empty: none
  std::string size;       ///< "1280x640"; empty: that
  std::string view;       ///< empty: home

  [[nodiscard]] bool any() const { return !image.empty() || !animation.empty(); }
  /// The names of what is written.
  [[nodiscard]] std::vector<std::string> files() const;
};

/// Declare the options. @param grows  there is a growth to show, so that --animation is one of them.
void add_picture_options(CLI::App& verb, PictureWishes& wishes, bool grows);

/// Can the pictures be drawn and written, if any are asked for? Complains about what is in the way before work begins.
/// @param outputs  other files that are written; empty names and `-` are passed over.
[[nodiscard]] bool pictures_fit(const PictureWishes& wishes, const std::vector<std::string>& inputs,
                                const std::vector<std::string>& outputs);

/// Draw and write what was asked for; complains where that fails.
[[nodiscard]] bool write_pictures(const PictureWishes& wishes, const MeshFile& source, const MeshFile& target,
                                  const Match& match);

}  // namespace quadmatch::cli
