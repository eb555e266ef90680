// One attribute after the other onto a copy of the target, then the order, then the records that hold from face to
// face.

#include <quadmatch/use/transfer.hpp>

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/verify/verify.hpp>

#include "../data/carried_lines.hpp"
#include "../data/numbering.hpp"
#include "../data/scalar_types.hpp"
#include "../data/texture_lists.hpp"
#include "corner_data.hpp"
#include "correspondence.hpp"
#include "element_data.hpp"
#include "face_records.hpp"

namespace quadmatch {
namespace use {
namespace {

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_wanted(const Property& property, const Carry& carry) {
  const std::string_view name = property.name;
  if (is_one_of(name, {"red", "green", "blue", "alpha"})) return carry.colours;
  if (property.domain == Domain::Vertex) {
    if (is_one_of(name, {"nx", "ny", "nz"})) return carry.normals;
    if (is_one_of(name, {"s", "t", "u", "v", "texture_u", "texture_v"})) return carry.texture_coordinates;
  }
  if (property.domain == Domain::Face && name == "texcoord") return carry.texture_coordinates;
  return carry.properties && property.domain != Domain::Further;
}

class Transfer {
 public:
  Transfer(const MeshFile& source, const MeshFile& target, const TransferOptions& options, const Correspondence& from,
           TransferReport& report)
      : source_(source), target_(target), options_(options), from_(from), report_(report), result_(target) {}

  Expected<MeshFile> run() {
    lift_texture_list();
    carry_texture_coordinates();
    carry_normals();
    carry_properties();
    if (options_.carry.positions) {
      if (Expected<void> moved = move_vertices(); !moved) return Unexpected(moved.error());
    }
    return in_order();
  }

 private:
  /// A list of PLY's becomes data of corners while corners are turned and filled, and a list again at the end.
  void lift_texture_list() {
    const Property* const theirs = find_texture_list(source_);
    const Property* const own = find_texture_list(target_);
    if (const Property* const list = own != nullptr ? own : theirs) {
      list_like_ = Property{list->name, list->domain, list->type, list->count_type, {}, {}};
      if (own != nullptr && theirs != nullptr) list_like_->type = holding_both(own->type, theirs->type);
    }
    if (own == nullptr) return;
    result_.texture_coordinates = texture_coordinates_of(target_);
    result_.properties.erase(result_.properties.begin() + (own - target_.properties.data()));
  }

  TransferredAttribute& report_on(std::string name, Domain domain) {
    return report_.attributes.emplace_back(TransferredAttribute{std::move(name), domain});
  }

  void carry_texture_coordinates() {
    const std::optional<IndexedAttribute> theirs = texture_coordinates_of(source_);
    if (!options_.carry.texture_coordinates || !theirs) return;
    const IndexedAttribute* const own = result_.texture_coordinates ? &*result_.texture_coordinates : nullptr;
    CarriedCorners carried = carry_corners(target_.mesh, *theirs, own, from_, options_.fill,
                                           report_on("texture coordinates", Domain::Corner));
    const auto vertex = [](std::uint32_t v) { return v; };
    const auto entry = [&](std::uint32_t i) {
      return i < carried.own_entries.size() ? carried.own_entries[i] : IndexedAttribute::kNoIndex;
    };
    for (CarriedRecord& line : result_.carried) line.text = renumbered_line(line.text, vertex, entry);
    result_.texture_coordinates = std::move(carried.attribute);
  }

  void carry_normals() {
    if (!options_.carry.normals || !source_.normals) return;
    const IndexedAttribute* const own = result_.normals ? &*result_.normals : nullptr;
    CarriedCorners carried =
        carry_corners(target_.mesh, *source_.normals, own, from_, options_.fill, report_on("normals", Domain::Corner));
    result_.normals = std::move(carried.attribute);
  }

  const ElementMap& map_of(Domain domain) {
    std::optional<ElementMap>& map = domain == Domain::Vertex ? vertices_ : domain == Domain::Face ? faces_ : corners_;
    if (!map) {
      map = domain == Domain::Vertex ? vertex_map(target_.mesh, from_, options_.fill)
            : domain == Domain::Face ? face_map(target_.mesh, from_, options_.fill)
                                     : corner_map(target_.mesh, from_, options_.fill);
    }
    return *map;
  }

  void carry_properties() {
    const Property* const texture_list = find_texture_list(source_);
    for (const Property& theirs : source_.properties) {
      if (&theirs == texture_list || !is_wanted(theirs, options_.carry)) continue;
      const auto own = std::find_if(result_.properties.begin(), result_.properties.end(), [&](const Property& p) {
        return p.name == theirs.name && p.domain == theirs.domain;
      });
      const bool has_own = own != result_.properties.end();
      Property carried = carry_property(target_.mesh, theirs, has_own ? &*own : nullptr, map_of(theirs.domain),
                                        options_.fill, report_on(theirs.name, theirs.domain));
      if (has_own) {
        *own = std::move(carried);
      } else {
        result_.properties.push_back(std::move(carried));
      }
    }
  }

  Expected<void> move_vertices() {
    PolygonSoup soup;
    soup.vertex_count = target_.mesh.vertex_count();
    soup.positions = carry_positions(source_.mesh, target_.mesh, map_of(Domain::Vertex), options_.fill,
                                     report_on("positions", Domain::Vertex));
    soup.corners.assign(target_.mesh.corners().begin(), target_.mesh.corners().end());
    if (!target_.mesh.all_quads()) {
      for (std::uint32_t f = 0; f < target_.mesh.face_count(); ++f) {
        soup.face_starts.push_back(target_.mesh.first(FaceId(f)).value);
      }
      soup.face_starts.push_back(target_.mesh.halfedge_count());
    }
    Expected<Mesh> moved = Mesh::build(std::move(soup));
    if (!moved) return Unexpected(moved.error());
    result_.mesh = *std::move(moved);
    result_.position_type = holding_both(source_.position_type, target_.position_type);
    return {};
  }

  Expected<MeshFile> in_order() {
    const Numbering numbering =
        options_.order ? like_source(source_.mesh, target_.mesh, from_) : as_it_is(target_.mesh);
    std::vector<FaceRecord> records =
        carry_face_records(source_, target_, map_of(Domain::Face), numbering.faces, options_, report_.attributes);
    carry_libraries();
    if (options_.order) {
      Expected<MeshFile> ordered = renumbered(std::move(result_), numbering);
      if (!ordered) return ordered;
      result_ = *std::move(ordered);
    }
    result_.face_records = std::move(records);
    // Lines stand before the records of the face below them: they belong to the object that ends there.
    for (CarriedRecord& line : result_.carried) {
      const auto below =
          std::lower_bound(result_.face_records.begin(), result_.face_records.end(), line.before_face,
                           [](const FaceRecord& record, std::uint32_t face) { return record.first_face < face; });
      line.before_record = static_cast<std::uint32_t>(below - result_.face_records.begin());
    }
    if (list_like_ && result_.texture_coordinates) {
      result_.properties.push_back(texture_list_of(result_.mesh, *result_.texture_coordinates, *list_like_));
    }
    return std::move(result_);
  }

  /// The source's where its materials are, and the target's where it keeps some.
  void carry_libraries() {
    const auto materials = std::find_if(report_.attributes.begin(), report_.attributes.end(),
                                        [](const TransferredAttribute& entry) { return entry.name == "usemtl"; });
    if (materials == report_.attributes.end()) return;
    std::vector<std::string> libraries = source_.material_libraries;
    for (const std::string& own : target_.material_libraries) {
      const bool listed = std::find(libraries.begin(), libraries.end(), own) != libraries.end();
      if (materials->kept > 0 && !listed) libraries.push_back(own);
    }
    result_.material_libraries = std::move(libraries);
  }

  const MeshFile& source_;
  const MeshFile& target_;
  const TransferOptions& options_;
  const Correspondence& from_;
  TransferReport& report_;
  MeshFile result_;
  std::optional<ElementMap> vertices_, faces_, corners_;
  std::optional<Property> list_like_;
};

/// Is there anything to do?
Expected<void> check_wishes(const MeshFile& source, const TransferOptions& options) {
  const Carry& carry = options.carry;
  if (carry.positions && source.mesh.positions().empty()) {
    return Unexpected(Error{ErrorCode::BadArgument, "it has no positions to carry; leave positions out", source.path});
  }
  const auto record_wanted = [&](const FaceRecord& record) {
    return (carry.groups && is_one_of(record.keyword, {"o", "g"})) || (carry.materials && record.keyword == "usemtl") ||
           (carry.smoothing && record.keyword == "s");
  };
  const bool any = carry.positions || options.order || (carry.texture_coordinates && source.texture_coordinates) ||
                   (carry.normals && source.normals) ||
                   std::any_of(source.properties.begin(), source.properties.end(),
                               [&](const Property& property) { return is_wanted(property, carry); }) ||
                   std::any_of(source.face_records.begin(), source.face_records.end(), record_wanted);
  if (any) return {};
  return Unexpected(Error{ErrorCode::BadArgument,
                          "it has none of the data that are to be carried; ask for what it has, or for its order",
                          source.path});
}

}  // namespace
}  // namespace use

Expected<Transferred> transfer(const MeshFile& source, const MeshFile& target, const Match& match,
                               const TransferOptions& options) {
  const Verdict verdict = verify(source.mesh, target.mesh, match, 1);
  if (!verdict.sound()) {
    return Unexpected(Error{
        ErrorCode::MatchDoesNotFit,
        fmt::format("the match is not sound for these meshes: {}; match them again", verdict.faults.front().message)});
  }
  if (Expected<void> fine = use::check_wishes(source, options); !fine) return Unexpected(fine.error());

  TransferReport report;
  const use::Correspondence from = use::correspond(source.mesh, target.mesh, match, options, report);
  Expected<MeshFile> file = use::Transfer(source, target, options, from, report).run();
  if (!file) return Unexpected(file.error());
  return Transferred{*std::move(file), std::move(report)};
}

}  // namespace quadmatch
