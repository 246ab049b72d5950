#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/frame.hpp"
#include "solver/particles/baffles.hpp"
#include "solver/particles/face.hpp"
#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// The particles, as a structure of arrays in cell order.
template <int D>
struct State {
  Vecs<D> position;       ///< in the tank's frame [m]
  Vecs<D> velocity;       ///< relative to the tank [m/s]
  Vecs<D> normal;         ///< out of the tank, for wall and dummy particles; zero in corners and for fluid
  std::vector<int> edge;  ///< of wall and dummy particles beside an edge where the wall is convex: in `edges`; else -1
  Scalars pressure;       ///< gauge [Pa]; the next solve starts from it
  std::vector<Kind> kind;
  Scalars density;                         ///< number density n_i when the surface was last found
  std::vector<std::uint8_t> surface;       ///< 1 at the free surface, where the pressure is given
  std::vector<std::uint8_t> near_surface;  ///< 1 for it and its neighbours
  std::vector<std::uint32_t> id;
  Scalars volume;  ///< what a wall particle or dummy stands for [l0^D]; 1 for fluid
  Scalars wet;     ///< weight as a neighbour: of walls the volume beside liquid, 0 where they are dry; 1 for fluid
  std::vector<int> behind;  ///< face of a baffle whose solid it stands for; -1 for all others

  std::shared_ptr<const Baffles<D>> baffles;  ///< null where the tank has none
  std::vector<std::vector<Face<D>>> edges;    ///< faces that meet at each edge where the wall is convex
  Vecs<D> listed_position;                    ///< where each particle was when the neighbour list was made
  double time = 0;                            ///< [s]
  long step = 0;

  std::size_t size() const { return position.size(); }

  /// The wall's normal as liquid at r meets wall particle or dummy j.
  Vec<D> normal_from(const Vec<D>& r, int j) const {
    return edge[j] < 0 ? normal[j] : entered_face(edges[edge[j]], r, position[j]);
  }

  /// Whether j stands for the solid of a baffle's side, and not for what lies behind the tank's wall there, too.
  bool in_baffle(int j) const {
    return behind[j] >= 0 && normal[j] == baffles->faces()[behind[j]].normal_at(position[j]);
  }

  void add(const Vec<D>& r, Kind k, const Vec<D>& n, double v = 1);

  /// Keeps particles order[0], order[1], ... in that order and drops the others.
  void reorder(const std::vector<int>& order);

 private:
  Vecs<D> vectors_;
  Scalars scalars_;
  std::vector<Kind> kinds_;
  std::vector<std::uint8_t> bytes_;
  std::vector<int> edges_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace seiche::solver
