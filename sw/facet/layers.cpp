#include "sw/facet/layers.h"

#include "sw/facet/above.h"
#include "sw/facet/bounds.h"
#include "sw/facet/caps.h"
#include "sw/facet/crowds.h"
#include "sw/facet/objects.h"
#include "sw/facet/opposed.h"
#include "sw/facet/traced.h"

namespace rc2::facet {
namespace {

class LayerBuilder {
 public:
  LayerBuilder(const scene::Scene& scene, int n, int fraction_bits)
      : n_(n),
        one_(std::int64_t{1} << fraction_bits),
        set_(build_facets(scene, n, fraction_bits, Rule::armoured, traced_)) {}

  FacetSet build() {
    end_batch(false);
    Shells shells = find_shells(traced_);
    set_.counts.objects_capped = cap_holes(traced_, shells);
    mark_crowded(shells);
    const std::vector<bool> is_thin = find_thin(shells.open);
    add_shown();
    add_guard(is_thin);
    for (const Pieces& shell : shells.closed) mark_body(shell, rays::Body::room);
    add_inside(find_objects(traced_, shells.closed));
    set_.counts.objects_open = static_cast<std::int64_t>(shells.open.size());
    return std::move(set_);
  }

 private:
  void mark_crowded(const Shells& shells) {
    std::vector<const Pieces*> all;
    for (const Pieces& shell : shells.closed) all.push_back(&shell);
    for (const OpenShell& shell : shells.open) all.push_back(&shell.pieces);
    const std::vector<bool> is_crowded = find_crowded(traced_, all, one_);
    for (std::size_t i = 0; i < is_crowded.size(); ++i) {
      if (!is_crowded[i] || !traced_.pieces[i].facet) continue;
      const std::uint32_t facet = *traced_.pieces[i].facet;
      packets_.heads[facet].surface = Surface::crowd;
      ++set_.counts.crowded;
    }
  }

  // Facets behind which there may be less than a step of armour. Marks those of sheets.
  std::vector<bool> find_thin(const std::vector<OpenShell>& shells) {
    std::vector<bool> is_thin(set_.facets.size());
    for (const std::uint32_t i : find_opposed(packets_.heads)) is_thin[i] = true;
    for (const OpenShell& shell : shells) {
      for (const std::uint32_t i : shell.pieces) {
        const std::optional<std::uint32_t> facet = traced_.pieces[i].facet;
        if (!facet || packets_.heads[*facet].surface == Surface::crowd) continue;
        packets_.heads[*facet].surface = Surface::sheet;
        is_thin[*facet] = true;
      }
    }
    return is_thin;
  }

  void add_shown() {
    packets_.heads.reserve(2 * packets_.heads.size());
    packets_.sides.reserve(2 * packets_.sides.size());
    const Grid grid{n_, one_, Rule::naive};
    for (const Traced::Piece& piece : traced_.pieces) {
      if (!piece.facet) continue;
      append_packet(piece.border, piece.normal, *piece.facet, grid, packets_);
      packets_.heads.back().layer = Layer::shown;
    }
    end_batch(false);
  }

  void add_guard(const std::vector<bool>& is_thin) {
    for (const Traced::Piece& piece : traced_.pieces) {
      if (!piece.facet || !is_thin[*piece.facet]) continue;
      append_guard(piece.border, piece.normal, *piece.facet, packets_.heads[*piece.facet].surface,
                   n_, one_, packets_);
    }
    end_batch(false);
  }

  void mark_body(const Pieces& shell, rays::Body body) {
    for (const std::uint32_t i : shell) {
      const std::optional<std::uint32_t> facet = traced_.pieces[i].facet;
      if (facet) set_.facets[*facet].body = body;
    }
  }

  void add_inside(const Objects& objects) {
    auto nameless = static_cast<std::uint32_t>(set_.facets.size());
    for (const Pieces& solid : objects.solids) {
      mark_body(solid, rays::Body::solid);
      for (const std::uint32_t i : solid) {
        const Traced::Piece& piece = traced_.pieces[i];
        const std::uint32_t number = piece.facet ? *piece.facet : nameless++;
        append_above(piece.border, piece.normal, number, n_, one_, packets_);
      }
      end_batch(true);
    }
    set_.counts.objects_closed = static_cast<std::int64_t>(objects.solids.size());
    set_.counts.rooms = objects.rooms;
  }

  void end_batch(bool ends_object) {
    const auto end = static_cast<std::uint32_t>(packets_.heads.size());
    if (end != first_) packets_.batches.push_back({first_, end - first_, ends_object});
    first_ = end;
  }

  int n_;
  std::int64_t one_;
  Traced traced_;
  FacetSet set_;
  PacketStream& packets_ = set_.packets;
  std::uint32_t first_ = 0;  // of the batch
};

}  // namespace

FacetSet build_layers(const scene::Scene& scene, int n, int fraction_bits) {
  return LayerBuilder(scene, n, fraction_bits).build();
}

}  // namespace rc2::facet
