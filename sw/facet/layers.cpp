#include "sw/facet/layers.h"

#include "sw/facet/above.h"
#include "sw/facet/bounds.h"
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
    const std::vector<std::uint32_t> opposed = find_opposed(packets_.heads);
    add_shown();
    add_thin(opposed);
    add_inside();
    return std::move(set_);
  }

 private:
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

  void add_thin(const std::vector<std::uint32_t>& opposed) {
    for (const std::uint32_t i : opposed) {
      PacketHead head = packets_.heads[i];
      head.layer = Layer::thin;
      packets_.heads.push_back(head);
    }
    end_batch(false);
  }

  void add_inside() {
    const Objects objects = find_objects(traced_);
    auto nameless = static_cast<std::uint32_t>(set_.facets.size());
    for (const Pieces& solid : objects.solids) {
      for (const std::uint32_t i : solid) {
        const Traced::Piece& piece = traced_.pieces[i];
        const std::uint32_t number = piece.facet ? *piece.facet : nameless++;
        append_above(piece.border, piece.normal, number, n_, one_, packets_);
      }
      end_batch(true);
    }
    set_.counts.objects_closed = static_cast<std::int64_t>(objects.solids.size());
    set_.counts.rooms = objects.rooms;
    set_.counts.objects_open = objects.open;
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
