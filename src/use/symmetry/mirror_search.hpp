#pragma once
/// All mirrors of one component: where it is symmetric in several ways, which of them is meant, and how many there are.

#include <cstdint>
#include <optional>
#include <vector>

#include <quadmatch/analysis/spoke_colours.hpp>
#include <quadmatch/mesh/components.hpp>
#include <quadmatch/use/symmetry.hpp>

#include "mirror_map.hpp"

namespace quadmatch::use {

/// A mirror that was grown from one germ.
struct Mirror {
  Germ germ;
  std::uint32_t faces = 0;
  bool whole = false;             ///< all of the component, with nothing in its way
  std::uint32_t line_length = 0;  ///< half-edges and faces on the centre line
  double misfit = 0;              ///< how lengths of edges differ from their partners', in the middle, as a logarithm
  std::optional<MirrorPlane> plane;
};

struct MirrorsOfComponent {
  /// Different ones, the one to be taken first.
  std::vector<Mirror> mirrors;
  /// There may be others, since not all places were tried.
  bool maybe_more = false;
};

class MirrorSearch {
 public:
  /// @param edge  mean_edge(mesh); 0 where positions are not to be looked at
  MirrorSearch(const Mesh& mesh, const PerFan<VertexCode>& codes, const Components& components, double edge);

  /// First the exact mirrors: a place of the rarest look is laid on each that looks the same. Where there is none, the
  /// component was edited, and places that still look alike are tried, from those that see far to those that see
  /// little.
  /// @par Cost  O(#spokes log #spokes) of the mesh once; a bounded number of growths over the component.
  [[nodiscard]] MirrorsOfComponent mirrors_of(std::uint32_t component);

 private:
  struct Coloured {
    Colour colour;
    HalfedgeId start;  ///< first edge of the spoke; in the mirror image the half-edge that lies opposite
    bool backward;
  };

  void colour_spokes();
  [[nodiscard]] std::vector<Coloured> spokes_in(std::uint32_t component, std::uint32_t round, bool opposite) const;
  [[nodiscard]] std::vector<Germ> exact_germs(std::uint32_t component);
  [[nodiscard]] std::vector<Germ> likely_germs(std::uint32_t component) const;
  void try_germs(const std::vector<Germ>& germs, std::uint32_t component, bool whole_only, MirrorsOfComponent& found);
  void nearest_plane_first(std::vector<Germ>& germs) const;
  [[nodiscard]] std::optional<Mirror> grown(Germ germ, std::uint32_t component, bool whole_only);
  [[nodiscard]] double misfit_of_map() const;
  [[nodiscard]] double length(HalfedgeId h) const;

  const Mesh& mesh_;
  const PerFan<VertexCode>& codes_;
  const Components& components_;
  const double edge_;
  const Mesh turned_;
  PerFan<VertexCode> turned_codes_;
  ArcGraph spokes_, turned_spokes_;
  SpokeColours colours_, turned_colours_;
  MirrorMap map_;
  std::vector<std::uint64_t> signatures_;  // of the mirrors found
  std::size_t spent_ = 0;
};

}  // namespace quadmatch::use
