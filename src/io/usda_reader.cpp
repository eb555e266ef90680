// Meshes of USD text files: a parser for as much of the grammar as is needed to find them anywhere in the scene.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "formats.hpp"
#include "line_scanner.hpp"
#include "passed_over.hpp"
#include "usda_mesh.hpp"
#include "usda_scanner.hpp"

namespace quadmatch::io {
namespace {

/// Words before the type of an attribute.
bool is_modifier(std::string_view word) {
  constexpr std::string_view kModifiers[] = {"custom", "uniform", "varying", "config", "prepend",
                                             "append", "add",     "delete",  "reorder"};
  return std::find(std::begin(kModifiers), std::end(kModifiers), word) != std::end(kModifiers);
}

bool is_specifier(std::string_view word) { return word == "def" || word == "over" || word == "class"; }

/// Attributes of a mesh that are written by habit, and whose loss is no news.
bool is_habitual(std::string_view attribute) {
  constexpr std::string_view kHabitual[] = {"extent", "subdivisionScheme", "doubleSided", "visibility", "purpose"};
  return std::find(std::begin(kHabitual), std::end(kHabitual), attribute) != std::end(kHabitual);
}

class UsdaReader {
 public:
  UsdaReader(const FileBytes& bytes, const std::string& name) : scanner_(bytes), name_(name), collector_(name) {}
  Expected<MeshFile> read();

 private:
  /// A prim that is open; only meshes gather anything.
  struct Prim {
    bool is_mesh = false;
    UsdaMesh mesh;
  };

  bool read_statement();
  bool open_prim(std::string_view specifier);
  bool close_prim();
  bool read_attribute(std::string_view first_word);
  bool read_attribute_of_mesh(UsdaMesh& mesh, std::string_view type, std::string_view attribute);
  bool read_mesh_value(UsdaMesh& mesh, std::string_view type, std::string_view attribute);
  bool read_first_sample(UsdaMesh& mesh, std::string_view type, std::string_view attribute);
  bool read_primvar(UsdaMesh& mesh, std::string_view type, std::string_view primvar);
  bool read_metadata(std::string* interpolation);
  bool read_integers(std::vector<std::int64_t>& values);
  bool read_tuples(std::uint32_t components, std::vector<double>& values);
  bool skip_value();
  bool fail(ErrorCode code, std::string message) {
    error_ = {code, std::move(message), name_, scanner_.line()};
    return false;
  }
  bool fail_end() {
    const std::string prim =
        open_.empty() ? "its first prim" : fmt::format("prim {}", in_quotes(open_.back().mesh.name));
    return fail(ErrorCode::Truncated, fmt::format("the file ends within {}; export the mesh again", prim));
  }
  bool fail_syntax(const char* expected) {
    if (!scanner_.skip_blanks()) return fail_end();
    return fail(ErrorCode::Syntax,
                fmt::format("there should be {} at {}; {}", expected, in_quotes(scanner_.rest()), kMend));
  }
  bool fail_number() {
    if (!scanner_.skip_blanks()) return fail_end();
    return fail(ErrorCode::BadNumber, fmt::format("{} does not begin with a finite number of its type; {}",
                                                  in_quotes(scanner_.rest()), kMend));
  }

  UsdaScanner scanner_;
  const std::string& name_;
  Error error_;
  std::vector<Prim> open_;
  UsdaCollector collector_;
  bool transformed_ = false;
  bool sampled_ = false;
  PassedOver passed_over_;
};

bool UsdaReader::skip_value() { return scanner_.skip_value() || fail_syntax("a value"); }

/// What stands between parentheses; the interpolation, if asked for.
bool UsdaReader::read_metadata(std::string* interpolation) {
  while (!scanner_.take(')')) {
    const std::string_view word = scanner_.take_word();
    if (word == "interpolation" && interpolation != nullptr && scanner_.take('=')) {
      std::string_view text;
      if (!scanner_.take_string(text)) return fail_syntax("a string");
      *interpolation = text;
    } else if (!scanner_.take('=') && word.empty() && !scanner_.take(',') && !skip_value()) {
      return false;
    }
  }
  return true;
}

bool UsdaReader::open_prim(std::string_view specifier) {
  std::string_view name;
  const std::string_view type = scanner_.take_word();
  const std::uint64_t line = scanner_.line();
  if (!scanner_.take_string(name)) return fail_syntax("the name of a prim in quotes");
  if (scanner_.take('(') && !read_metadata(nullptr)) return false;
  if (!scanner_.take('{')) return fail_syntax("'{'");
  Prim& prim = open_.emplace_back();
  prim.is_mesh = type == "Mesh" && specifier == "def";
  prim.mesh.name = name;
  prim.mesh.points_line = prim.mesh.counts_line = prim.mesh.indices_line = line;
  if (type == "GeomSubset") passed_over_.add("GeomSubset");
  return true;
}

bool UsdaReader::close_prim() {
  if (open_.empty()) return fail_syntax("'def'");
  const Prim prim = std::move(open_.back());
  open_.pop_back();
  if (!prim.is_mesh || collector_.add(prim.mesh)) return true;
  error_ = std::move(collector_.error);
  return false;
}

bool UsdaReader::read_statement() {
  if (scanner_.take('}')) return close_prim();
  const std::string_view word = scanner_.take_word();
  if (word.empty()) return fail_syntax("'def' or an attribute");
  if (is_specifier(word)) return open_prim(word);
  if (word != "variantSet") return read_attribute(word);
  std::string_view name;
  if (!scanner_.take_string(name) || !scanner_.take('=')) return fail_syntax("a variant set");
  passed_over_.add("variantSet");
  return skip_value();
}

/// [modifiers] type name [= value] [(metadata)], or [modifiers] name = value.
bool UsdaReader::read_attribute(std::string_view first_word) {
  std::string_view type = first_word;
  while (is_modifier(type)) type = scanner_.take_word();
  std::string_view attribute = scanner_.take_word();
  if (attribute.empty()) attribute = type;
  if (attribute.empty()) return fail_syntax("an attribute");
  transformed_ = transformed_ || attribute.substr(0, 8) == "xformOp:";
  if (!open_.empty() && open_.back().is_mesh) return read_attribute_of_mesh(open_.back().mesh, type, attribute);
  if (scanner_.take('=') && !skip_value()) return false;
  return !scanner_.take('(') || read_metadata(nullptr);
}

bool UsdaReader::read_attribute_of_mesh(UsdaMesh& mesh, std::string_view type, std::string_view attribute) {
  std::string interpolation;
  if (scanner_.take('=') && !read_mesh_value(mesh, type, attribute)) return false;
  if (scanner_.take('(') && !read_metadata(&interpolation)) return false;
  if (interpolation.empty()) return true;
  if (attribute.substr(0, 9) == "primvars:") attribute.remove_prefix(9);
  for (UsdaPrimvar& primvar : mesh.primvars) {
    if (primvar.name == attribute) primvar.interpolation = interpolation;
  }
  return true;
}

bool UsdaReader::read_mesh_value(UsdaMesh& mesh, std::string_view type, std::string_view attribute) {
  constexpr std::string_view kSamples = ".timeSamples";
  constexpr std::string_view kPrimvars = "primvars:";
  if (scanner_.peek() == 'N') return skip_value();  // None: a value taken back
  if (attribute.size() > kSamples.size() && attribute.substr(attribute.size() - kSamples.size()) == kSamples) {
    return read_first_sample(mesh, type, attribute.substr(0, attribute.size() - kSamples.size()));
  }
  if (attribute == "points") {
    mesh.points_line = scanner_.line();
    return read_tuples(3, mesh.points);
  }
  if (attribute == "faceVertexCounts") {
    mesh.counts_line = scanner_.line();
    return read_integers(mesh.face_vertex_counts);
  }
  if (attribute == "faceVertexIndices") {
    mesh.indices_line = scanner_.line();
    return read_integers(mesh.face_vertex_indices);
  }
  if (attribute == "orientation") {
    std::string_view orientation;
    if (!scanner_.take_string(orientation)) return fail_syntax("a string");
    mesh.left_handed = orientation == "leftHanded";
    return true;
  }
  if (attribute == "normals") return read_primvar(mesh, type, attribute);
  if (attribute.substr(0, kPrimvars.size()) == kPrimvars) {
    return read_primvar(mesh, type, attribute.substr(kPrimvars.size()));
  }
  const bool transform = attribute.substr(0, 7) == "xformOp";  // has a note of its own
  if (!transform && !is_habitual(attribute)) passed_over_.add(attribute);
  return skip_value();
}

/// { time: value, ... }: the first value, where the attribute has none outside of time.
bool UsdaReader::read_first_sample(UsdaMesh& mesh, std::string_view type, std::string_view attribute) {
  if (attribute != "points" || !mesh.points.empty()) {
    passed_over_.add(attribute);
    return skip_value();
  }
  double time = 0;
  if (!scanner_.take('{') || !scanner_.take_real(time) || !scanner_.take(':')) return fail_syntax("a time sample");
  if (!read_mesh_value(mesh, type, attribute)) return false;
  sampled_ = true;
  while (!scanner_.take('}')) {
    if (!scanner_.take(',') && !skip_value()) return false;
  }
  return true;
}

/// Texture coordinates, normals, and the indices of either; others are passed over.
bool UsdaReader::read_primvar(UsdaMesh& mesh, std::string_view type, std::string_view primvar) {
  constexpr std::string_view kIndices = ":indices";
  if (primvar.size() > kIndices.size() && primvar.substr(primvar.size() - kIndices.size()) == kIndices) {
    const std::string_view indexed = primvar.substr(0, primvar.size() - kIndices.size());
    const bool kept = std::any_of(mesh.primvars.begin(), mesh.primvars.end(),
                                  [indexed](const UsdaPrimvar& known) { return known.name == indexed; });
    if (!kept) return skip_value();
    return read_integers(mesh.primvar(indexed).indices.emplace());
  }
  const bool texture = type.substr(0, 9) == "texCoord2" || (primvar == "st" && type.find('2') != type.npos);
  if (!texture && primvar != "normals") {
    passed_over_.add(primvar);
    return skip_value();
  }
  UsdaPrimvar& kept = mesh.primvar(primvar);
  kept.components = texture ? 2 : 3;
  kept.values.clear();
  return read_tuples(kept.components, kept.values);
}

bool UsdaReader::read_integers(std::vector<std::int64_t>& values) {
  values.clear();
  if (!scanner_.take('[')) return fail_syntax("'['");
  while (!scanner_.take(']')) {
    std::int64_t value = 0;
    if (!scanner_.take_integer(value)) return fail_number();
    values.push_back(value);
    if (!scanner_.take(',') && scanner_.peek() != ']') return fail_syntax("',' or ']'");
  }
  return true;
}

bool UsdaReader::read_tuples(std::uint32_t components, std::vector<double>& values) {
  values.clear();
  if (!scanner_.take('[')) return fail_syntax("'['");
  while (!scanner_.take(']')) {
    if (!scanner_.take('(')) return fail_syntax("'('");
    for (std::uint32_t c = 0; c < components; ++c) {
      if (c > 0 && !scanner_.take(',')) return fail_syntax("','");
      if (!scanner_.take_real(values.emplace_back())) return fail_number();
    }
    if (!scanner_.take(')')) return fail_syntax("')'");
    if (!scanner_.take(',') && scanner_.peek() != ']') return fail_syntax("',' or ']'");
  }
  return true;
}

Expected<MeshFile> UsdaReader::read() {
  bool fine = !scanner_.take('(') || read_metadata(nullptr);
  while (fine && scanner_.skip_blanks()) fine = read_statement();
  if (fine && !open_.empty()) fine = fail_end();
  if (!fine) return Unexpected(std::move(error_));

  Expected<MeshFile> file = collector_.finish();
  if (!file) return file;
  file->comments = std::move(scanner_.comments());
  if (transformed_) file->notes.emplace_back("transforms (xformOp) were ignored; points are as each mesh states them");
  if (sampled_) file->notes.emplace_back("of points that move only the first time sample was read");
  passed_over_.append_notes("part", file->notes);
  return file;
}

}  // namespace

Expected<MeshFile> read_usda(const FileBytes& bytes, const std::string& name) {
  const std::string_view text = bytes.view();
  if (text.substr(0, 8) == "PXR-USDC" || text.substr(0, 4) == "PK\x03\x04") {
    return Unexpected(Error{ErrorCode::UnknownFormat, "this is a binary USD file; export it as .usda text", name});
  }
  if (text.substr(0, 5) != "#usda") {
    return Unexpected(Error{ErrorCode::Syntax,
                            "a USD text file begins with '#usda 1.0'; check the name or export the mesh as .usda", name,
                            1});
  }
  return UsdaReader(bytes, name).read();
}

}  // namespace quadmatch::io
