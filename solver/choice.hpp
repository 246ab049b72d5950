#pragma once
#include <array>
#include <string>
#include <string_view>

#include "solver/errors.hpp"

// A choice is an enum with a table of its values: what a scene calls each, and what it is. Scene keys, messages and the
// checks of parameters read the table. A new value is one enumerator, one row here and the code that it stands for.
namespace seiche {

template <class E>
struct Choice {
  E value;
  std::string_view name;  ///< in scenes
  std::string_view help;
};

template <class E>
Choice(E, std::string_view, std::string_view) -> Choice<E>;  // clang before 17 needs to be told

/// The scheme that the other choices start from.
enum class Preset { stabilised, paper };
/// When particles move: after or before the pressure solve.
enum class Order { project_first, move_first };
/// What bounds the liquid in the pressure equation.
enum class WallModel { ghosts, particles };
/// What walls do to the viscous term.
enum class WallSlip { free, none };
/// Right-hand side of the pressure equation.
enum class SourceTerm { mixed, density };
enum class GradientModel { corrected, minimum, plain };
/// Test for the free surface.
enum class SurfaceTest { density_and_count, density };
/// Of pairs that come too near.
enum class SeparationModel { collide, part, none };
/// Form of the viscous term.
enum class ViscousModel { strain_rate, laplacian };
enum class SolverName { amg, iccg, sor, cholmod };
/// How the tank's motion is given.
enum class MotionType { none, harmonic, harmonics, file };
/// Whose axes the names of the tank's six degrees of freedom belong to.
enum class MotionAxes { tank, ship };
/// Where the tank's x axis points in a ship.
enum class TankX { none, forward, port };
/// About which axes the tank is turned one after another, each turned with it by those before.
enum class RotationOrder { zyx, xyz };
/// What the liquid does at t = 0.
enum class Start { impulsive, smooth, level };
/// What a pressure sensor makes of the pressures on its area.
enum class PressureReading { mean, maximum };
/// Which end of the liquid on its line a wave gauge reads.
enum class Crossing { highest, lowest };
/// In whose axes, as they are at a time, a load is told.
enum class LoadAxes { tank, lab };
enum class TankShape { box, prism, membrane, cylinder, sphere, revolve, mesh };
enum class Axis { x, y, z };
/// Ends of a cylinder.
enum class Head { flat, hemispherical, elliptical, torispherical };

template <class E>
struct ChoiceTable;

template <>
struct ChoiceTable<Preset> {
  static constexpr std::array rows{Choice{Preset::stabilised, "stabilised", "keeps the pressure smooth"},
                                   Choice{Preset::paper, "paper", "as Pan, Zhang, Lu (2008) have it"}};
};
template <>
struct ChoiceTable<Order> {
  static constexpr std::array rows{Choice{Order::project_first, "project-first", "after the pressure solve"},
                                   Choice{Order::move_first, "move-first", "before it, the paper's"}};
};
template <>
struct ChoiceTable<WallModel> {
  static constexpr std::array rows{
      Choice{WallModel::ghosts, "ghosts", "the pressure goes on behind the wall with the body force's slope"},
      Choice{WallModel::particles, "particles", "wall particles have pressures of their own, the paper's"}};
};
template <>
struct ChoiceTable<WallSlip> {
  static constexpr std::array rows{Choice{WallSlip::free, "free-slip", "no shear at walls"},
                                   Choice{WallSlip::none, "no-slip", "liquid at a wall moves with it"}};
};
template <>
struct ChoiceTable<SourceTerm> {
  static constexpr std::array rows{Choice{SourceTerm::mixed, "mixed", "divergence and excess of particles"},
                                   Choice{SourceTerm::density, "density", "equation (10)"}};
};
template <>
struct ChoiceTable<GradientModel> {
  static constexpr std::array rows{Choice{GradientModel::corrected, "corrected", "exact on linear fields"},
                                   Choice{GradientModel::minimum, "minimum", "Koshizuka, Nobe, Oka 1998"},
                                   Choice{GradientModel::plain, "plain", "equation (4)"}};
};
template <>
struct ChoiceTable<SurfaceTest> {
  static constexpr std::array rows{
      Choice{SurfaceTest::density_and_count, "density-and-count", "of number density and neighbour count"},
      Choice{SurfaceTest::density, "density", "equation (11)"}};
};
template <>
struct ChoiceTable<SeparationModel> {
  static constexpr std::array rows{
      Choice{SeparationModel::collide, "collide", "they lose their velocity of approach"},
      Choice{SeparationModel::part, "part", "they are moved apart, the paper's additional modification"},
      Choice{SeparationModel::none, "none", "nothing"}};
};
template <>
struct ChoiceTable<ViscousModel> {
  static constexpr std::array rows{Choice{ViscousModel::strain_rate, "strain-rate", "divergence of the strain rate"},
                                   Choice{ViscousModel::laplacian, "laplacian", "equation (5)"}};
};
template <>
struct ChoiceTable<SolverName> {
  static constexpr std::array rows{
      Choice{SolverName::amg, "amg", "conjugate gradients with aggregation multigrid"},
      Choice{SolverName::iccg, "iccg", "conjugate gradients with incomplete Cholesky, the paper's"},
      Choice{SolverName::sor, "sor", "successive over-relaxation, the paper's other choice"},
      Choice{SolverName::cholmod, "cholmod", "sparse Cholesky factorisation, exact to rounding"}};
};
template <>
struct ChoiceTable<MotionType> {
  static constexpr std::array rows{Choice{MotionType::none, "none", "the tank is at rest"},
                                   Choice{MotionType::harmonic, "harmonic", "one of one degree of freedom"},
                                   Choice{MotionType::harmonics, "harmonics", "their sum, of [[motion.harmonic]]"},
                                   Choice{MotionType::file, "file", "a CSV of samples"}};
};
template <>
struct ChoiceTable<MotionAxes> {
  static constexpr std::array rows{
      Choice{MotionAxes::tank, "tank", "x, y upwards, z"},
      Choice{MotionAxes::ship, "ship", "forward, to port, up, as tank_x puts them into the tank"}};
};
template <>
struct ChoiceTable<TankX> {
  static constexpr std::array rows{Choice{TankX::none, "none", "not told"},
                                   Choice{TankX::forward, "forward", "z then points to starboard"},
                                   Choice{TankX::port, "port", "z then points forward"}};
};
template <>
struct ChoiceTable<RotationOrder> {
  static constexpr std::array rows{
      Choice{RotationOrder::zyx, "zyx", "z, then y, then x; of a ship yaw, then pitch, then roll"},
      Choice{RotationOrder::xyz, "xyz", "x, then y, then z, as OpenFOAM's tables have it"}};
};
template <>
struct ChoiceTable<Start> {
  static constexpr std::array rows{
      Choice{Start::impulsive, "impulsive", "at rest in the lab"},
      Choice{Start::smooth, "smooth", "moves with the tank"},
      Choice{Start::level, "level", "moves with the tank, its surface level under the gravity that acts in it"}};
};
template <>
struct ChoiceTable<PressureReading> {
  static constexpr std::array rows{Choice{PressureReading::mean, "mean", "of the area"},
                                   Choice{PressureReading::maximum, "maximum", "of the area, its edge included"}};
};

template <>
struct ChoiceTable<Crossing> {
  static constexpr std::array rows{
      Choice{Crossing::highest, "highest", "the end of the topmost liquid on the line"},
      Choice{Crossing::lowest, "lowest", "the end of the liquid that begins where the line does"}};
};
template <>
struct ChoiceTable<LoadAxes> {
  static constexpr std::array rows{Choice{LoadAxes::tank, "tank", "turn with the tank"},
                                   Choice{LoadAxes::lab, "lab", "stand still"}};
};

template <>
struct ChoiceTable<TankShape> {
  static constexpr std::array rows{
      Choice{TankShape::box, "box", "length, height, width; its corner is the origin"},
      Choice{TankShape::prism, "prism", "a polygon of points, along z by width"},
      Choice{TankShape::membrane, "membrane", "breadth and height with chamfers, along z by length"},
      Choice{TankShape::cylinder, "cylinder", "radius and length along an axis, with ends"},
      Choice{TankShape::sphere, "sphere", "radius"},
      Choice{TankShape::revolve, "revolve", "points (height, radius) about the vertical"},
      Choice{TankShape::mesh, "mesh", "an STL file's triangles"}};
};
template <>
struct ChoiceTable<Axis> {
  static constexpr std::array rows{Choice{Axis::x, "x", "lying, along x"}, Choice{Axis::y, "y", "upright"},
                                   Choice{Axis::z, "z", "lying, along z"}};
};
template <>
struct ChoiceTable<Head> {
  static constexpr std::array rows{
      Choice{Head::flat, "flat", "discs"}, Choice{Head::hemispherical, "hemispherical", "half spheres"},
      Choice{Head::elliptical, "elliptical", "2:1, half the radius high"},
      Choice{Head::torispherical, "torispherical", "crown radius the diameter, knuckle radius a tenth of it"}};
};

/// What scenes call it.
template <class E>
constexpr std::string_view name(E value) {
  for (const Choice<E>& row : ChoiceTable<E>::rows)
    if (row.value == value) return row.name;
  return {};
}

/// The value that scenes call so. Throws BadParameters for another name.
template <class E>
E value_named(std::string_view wanted) {
  std::string all;
  for (const Choice<E>& row : ChoiceTable<E>::rows) {
    if (row.name == wanted) return row.value;
    all.append(all.empty() ? "" : ", ").append(row.name);
  }
  throw BadParameters("'" + std::string(wanted) + "' is none of " + all);
}

}  // namespace seiche
