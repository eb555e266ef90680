// The JSON of a match file. This is the one source of the layer that includes the JSON library: it reads by events, so
// that a million pairs never become a million small arrays, and it escapes strings.

#include "match_parser.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "line_scanner.hpp"

namespace quadmatch::io {
namespace {

constexpr std::uint64_t kMostIndex = 0xfffffffe;

/// Walks over the bytes for the JSON library and lets its listener see how far it is.
class TrackedIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TrackedIterator(const char* here, const char** seen) : here_(here), seen_(seen) {}
  reference operator*() const { return *here_; }
  TrackedIterator& operator++() {
    *seen_ = ++here_;
    return *this;
  }
  bool operator==(const TrackedIterator& other) const { return here_ == other.here_; }
  bool operator!=(const TrackedIterator& other) const { return here_ != other.here_; }

 private:
  const char* here_;
  const char** seen_;
};

/// Where in the file the reader stands.
enum class Place { Outside, File, Side, Settings, Regions, Region, Evidence, Waves, Pairs, Pair, Vertices, VertexPair };

/// Listens to the JSON library and fills a MatchFile. Each event returns false to stop the reading, with the reason in
/// `error`; its line is that of the last byte seen.
class MatchListener {
 public:
  using Json = nlohmann::json;

  MatchListener(MatchFile& file, std::string_view bytes, const char* const& seen)
      : file_(file), bytes_(bytes), seen_(seen) {}

  std::optional<Error> error;

  bool start_object(std::size_t);
  bool end_object();
  bool start_array(std::size_t);
  bool end_array();
  bool key(std::string& name) {
    key_ = name;
    return true;
  }

  bool number_unsigned(std::uint64_t number);
  bool number_integer(std::int64_t number) {
    return number >= 0 ? number_unsigned(static_cast<std::uint64_t>(number)) : no_index(std::to_string(number));
  }
  bool number_float(double, const std::string& digits) { return no_index(digits); }
  bool string(std::string& text);
  bool boolean(bool value);
  bool null() { return skipping() || wrong("null"); }
  bool binary(Json::binary_t&) { return false; }  // JSON text has none
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception&);

  /// What must have been in the file, and was not.
  [[nodiscard]] const char* missing_field() const;

 private:
  /// Inside a value whose field we do not know, or about to take the value of one.
  [[nodiscard]] bool skipping() const;
  [[nodiscard]] bool enter(Place place) {
    places_.push_back(place);
    return true;
  }
  [[nodiscard]] Place place() const { return places_.empty() ? Place::Outside : places_.back(); }
  [[nodiscard]] bool enter_object();
  [[nodiscard]] bool enter_array();
  [[nodiscard]] bool leave_pair();
  [[nodiscard]] bool fail(ErrorCode code, std::string message);
  [[nodiscard]] bool wrong(std::string_view what);
  [[nodiscard]] bool no_index(const std::string& digits);
  /// "region 0, pair 3" where that is known, else the name of the field.
  [[nodiscard]] std::string whereabouts() const;

  MatchFile& file_;
  std::string_view bytes_;
  const char* const& seen_;
  std::vector<Place> places_;
  std::string key_;
  /// Objects and arrays open inside a value that is passed over.
  std::size_t skipped_depth_ = 0;
  MatchSide* side_ = nullptr;
  std::array<std::uint32_t, 3> numbers_{};
  std::size_t number_count_ = 0;
  bool has_format_ = false, has_source_ = false, has_target_ = false, has_regions_ = false, has_vertices_ = false;
};

bool MatchListener::fail(ErrorCode code, std::string message) {
  // The library looks one byte beyond a number before it reports it.
  const std::size_t looked_at = static_cast<std::size_t>(seen_ - bytes_.data());
  const std::string_view before = bytes_.substr(0, looked_at == 0 ? 0 : looked_at - 1);
  const std::ptrdiff_t line = 1 + std::count(before.begin(), before.end(), '\n');
  error = Error{code, std::move(message), "", static_cast<std::uint64_t>(line)};
  return false;
}

std::string MatchListener::whereabouts() const {
  const std::size_t region = file_.match.regions.size() - 1;  // only used inside one
  switch (place()) {
    case Place::Outside:
      return "the file";
    case Place::Regions:
      return "'regions'";
    case Place::Region:
    case Place::Evidence:
    case Place::Waves:
    case Place::Pairs:
      return fmt::format("region {}, {}", region, in_quotes(key_));
    case Place::Pair:
      return fmt::format("region {}, pair {}", region, file_.match.regions.back().faces.size());
    case Place::Vertices:
      return "'vertices'";
    case Place::VertexPair:
      return fmt::format("vertices, pair {}", file_.match.vertices.size());
    default:
      return in_quotes(key_);
  }
}

bool MatchListener::wrong(std::string_view what) {
  return fail(ErrorCode::Syntax,
              fmt::format("{}: {} does not belong here in a match file; {}", whereabouts(), what, kRematch));
}

bool MatchListener::no_index(const std::string& digits) {
  if (skipping()) return true;
  return fail(ErrorCode::BadNumber, fmt::format("{}: {} is not a whole number from 0 to {}; {}", whereabouts(),
                                                in_quotes(digits), kMostIndex, kRematch));
}

bool MatchListener::skipping() const {
  if (skipped_depth_ > 0) return true;
  switch (place()) {
    case Place::File:
      return key_ != "format" && key_ != "source" && key_ != "target" && key_ != "regions" && key_ != "vertices" &&
             key_ != "settings" && key_ != "complete";
    case Place::Side:
      return key_ != "path" && key_ != "vertices" && key_ != "faces";
    case Place::Region:
      return key_ != "orientation" && key_ != "faces" && key_ != "evidence" && key_ != "waves" && key_ != "ways" &&
             key_ != "ambiguous";
    case Place::Evidence:
      return key_ != "agreeing" && key_ != "source_extraordinary" && key_ != "target_extraordinary";
    default:
      return false;
  }
}

bool MatchListener::start_object(std::size_t) {
  // A setting may be of any kind in files of others; ours are strings, and the rest is passed over.
  if (skipping() || place() == Place::Settings) {
    ++skipped_depth_;
    return true;
  }
  return enter_object();
}

bool MatchListener::enter_object() {
  switch (place()) {
    case Place::Outside:
      return enter(Place::File);
    case Place::Regions:
      file_.match.regions.emplace_back();
      return enter(Place::Region);
    case Place::Region:
      return key_ == "evidence" ? enter(Place::Evidence) : wrong("an object");
    case Place::File:
      break;
    default:
      return wrong("an object");
  }
  if (key_ == "settings") return enter(Place::Settings);
  if (key_ != "source" && key_ != "target") return wrong("an object");
  const bool source = key_ == "source";
  side_ = source ? &file_.source : &file_.target;
  (source ? has_source_ : has_target_) = true;
  return enter(Place::Side);
}

bool MatchListener::end_object() {
  if (skipped_depth_ > 0) {
    --skipped_depth_;
  } else {
    places_.pop_back();
  }
  return true;
}

bool MatchListener::start_array(std::size_t) {
  if (skipping() || place() == Place::Settings) {
    ++skipped_depth_;
    return true;
  }
  return enter_array();
}

bool MatchListener::enter_array() {
  number_count_ = 0;
  switch (place()) {
    case Place::Pairs:
      return enter(Place::Pair);
    case Place::Vertices:
      return enter(Place::VertexPair);
    case Place::Region:
      if (key_ == "faces") return enter(Place::Pairs);
      return key_ == "waves" ? enter(Place::Waves) : wrong("an array");
    case Place::File:
      break;
    default:
      return wrong("an array");
  }
  if (key_ == "regions") {
    has_regions_ = true;
    return enter(Place::Regions);
  }
  if (key_ != "vertices") return wrong("an array");
  has_vertices_ = true;
  return enter(Place::Vertices);
}

bool MatchListener::end_array() {
  if (skipped_depth_ > 0) {
    --skipped_depth_;
    return true;
  }
  if ((place() == Place::Pair || place() == Place::VertexPair) && !leave_pair()) return false;
  places_.pop_back();
  return true;
}

bool MatchListener::leave_pair() {
  const std::size_t needed = place() == Place::Pair ? 3 : 2;
  if (number_count_ != needed) {
    return fail(ErrorCode::Syntax,
                fmt::format("{} has {} numbers instead of {}; {}", whereabouts(), number_count_, needed, kRematch));
  }
  if (place() == Place::Pair) {
    file_.match.regions.back().faces.push_back({FaceId(numbers_[0]), FaceId(numbers_[1]), numbers_[2]});
  } else {
    file_.match.vertices.push_back({VertexId(numbers_[0]), VertexId(numbers_[1])});
  }
  return true;
}

bool MatchListener::number_unsigned(std::uint64_t number) {
  if (skipping() || place() == Place::Settings) return true;
  if (number > kMostIndex) return no_index(std::to_string(number));
  const std::uint32_t index = static_cast<std::uint32_t>(number);
  switch (place()) {
    case Place::Pair:
    case Place::VertexPair:
      if (number_count_ < numbers_.size()) numbers_[number_count_] = index;
      ++number_count_;
      return true;
    case Place::Waves:
      file_.match.regions.back().waves.push_back(index);
      return true;
    case Place::Evidence: {
      Evidence& evidence = file_.match.regions.back().evidence;
      (key_ == "agreeing"               ? evidence.agreeing
       : key_ == "source_extraordinary" ? evidence.source_extraordinary
                                        : evidence.target_extraordinary) = index;
      return true;
    }
    case Place::Region:
      if (key_ != "ways") return wrong("a number");
      file_.match.regions.back().ways = index;
      return true;
    case Place::Side:
      if (key_ == "path") return wrong("a number");
      (key_ == "vertices" ? side_->vertices : side_->faces) = index;
      return true;
    default:
      return wrong("a number");
  }
}

bool MatchListener::string(std::string& text) {
  if (place() == Place::Settings && skipped_depth_ == 0) {
    file_.settings.emplace_back(key_, text);
    return true;
  }
  if (skipping()) return true;
  if (place() == Place::Side && key_ == "path") {
    side_->path = text;
    return true;
  }
  if (place() == Place::Region && key_ == "orientation") {
    if (text != "preserving" && text != "reversing") {
      return fail(ErrorCode::Syntax, fmt::format("{}: {} is no orientation; write preserving or reversing",
                                                 whereabouts(), in_quotes(text)));
    }
    file_.match.regions.back().orientation = text == "reversing" ? Orientation::Reversing : Orientation::Preserving;
    return true;
  }
  if (place() == Place::File && key_ == "format") {
    has_format_ = text == kMatchFormat;
    return has_format_ || fail(ErrorCode::Syntax, fmt::format("the format is {}, but this program reads '{}'; {}",
                                                              in_quotes(text), kMatchFormat, kRematch));
  }
  return wrong("a text");
}

bool MatchListener::boolean(bool value) {
  if (skipping() || place() == Place::Settings) return true;
  if (place() == Place::Region && key_ == "ambiguous") {
    file_.match.regions.back().ambiguous = value;
    return true;
  }
  if (place() != Place::File || key_ != "complete") return wrong(value ? "true" : "false");
  file_.match.complete = value;
  return true;
}

bool MatchListener::parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception&) {
  if (position > bytes_.size()) {  // it has read the end itself
    return fail(ErrorCode::Truncated, fmt::format("the match file ends too early; {}", kRematch));
  }
  return fail(ErrorCode::Syntax, fmt::format("this is not JSON at {}; {}", in_quotes(token), kRematch));
}

const char* MatchListener::missing_field() const {
  if (!has_format_) return "format";
  if (!has_source_) return "source";
  if (!has_target_) return "target";
  if (!has_regions_) return "regions";
  return has_vertices_ ? nullptr : "vertices";
}

}  // namespace

Expected<MatchFile> parse_match_json(std::string_view bytes) {
  MatchFile file;
  const char* seen = bytes.data();
  MatchListener listener(file, bytes, seen);
  const TrackedIterator begin(bytes.data(), &seen);
  const TrackedIterator end(bytes.data() + bytes.size(), &seen);
  if (!nlohmann::json::sax_parse(begin, end, &listener)) {
    return Unexpected(listener.error.value_or(Error{ErrorCode::Syntax, fmt::format("this is not JSON; {}", kRematch)}));
  }
  if (const char* const field = listener.missing_field()) {
    return Unexpected(Error{ErrorCode::Syntax, fmt::format("the field '{}' is missing; {}", field, kRematch)});
  }
  return file;
}

std::string json_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace quadmatch::io
