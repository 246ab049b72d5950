#pragma once
#include <string>

namespace seiche {

/// Everything that the physics of a run depends on, in SI units. Who fills it in (a scene file, a test) sees to the
/// ranges; `Simulation` checks only what concerns several members at once.
struct Parameters {
  std::string preset = "stabilised";
  double gravity = 9.81;  ///< [m/s^2], along -y

  struct Fluid {
    double density = 1000;    ///< rho [kg/m^3]
    double viscosity = 1e-6;  ///< nu, kinematic [m^2/s]
    double depth = 0.2;       ///< still level above the floor [m]
    double column = 0;        ///< length of the liquid from the left wall [m]; 0: the whole tank (a dam break sets it)
  } fluid;

  struct Tank {
    double length = 0.6;  ///< inner, along x [m]
    double height = 0.4;  ///< inner, along y [m]
    double width = 0;     ///< inner, along z [m]; 0: the run is 2-D
    bool closed = true;   ///< with a roof
  } tank;

  struct Motion {
    std::string type = "none";  ///< none | surge: x(t) = amplitude sin(2 pi frequency t)
    double amplitude = 0;       ///< [m]
    double frequency = 0;       ///< [Hz]
    std::string start =
        "impulsive";  ///< impulsive: water at rest in the lab | smooth: water moves with the tank at t = 0
  } motion;

  struct Particles {
    double spacing = 0.005;  ///< l0 [m]
  } particles;

  /// Each choice goes by name. Radii are in units of l0.
  struct Method {
    std::string kernel = "KF3";                 ///< KF1 .. KF5, Table 1
    double kf2_alpha = 3.0;                     ///< alpha of KF2
    double radius_density = 2.6;                ///< r_e of the number density and the divergence
    double radius_gradient = 2.6;               ///< r_e of the gradient
    double radius_laplacian = 2.6;              ///< r_e of the Laplacian
    double surface_beta = 0.97;                 ///< beta of equation (11)
    std::string order = "project-first";        ///< project-first | move-first (the paper's)
    std::string source = "mixed";               ///< mixed | density (equation 10)
    std::string gradient = "corrected";         ///< corrected | minimum | plain (equation 4)
    std::string surface = "density-and-count";  ///< density-and-count | density (equation 11)
    std::string separation = "collide";         ///< collide | part (the additional modification) | none
    double separation_distance = 0.8;           ///< pairs nearer than this are separated [l0]
    double shift = 0.05;                        ///< strength of particle shifting [-]; 0: none
    std::string wall = "free-slip";             ///< free-slip | no-slip: what walls do to the viscous term
  } method;

  struct Pressure {
    std::string solver = "iccg";  ///< iccg | sor | cholmod
    double tolerance = 1e-4;      ///< relative residual at which an iterative solver stops
    int max_iterations = 2000;
  } pressure;

  struct Time {
    double end = 10;       ///< [s]
    double courant = 0.2;  ///< alpha of equation (18); half of it changes nothing but the run time
  } time;

  int threads = 0;  ///< OpenMP threads; 0: one per core

  int dimension() const { return tank.width > 0 ? 3 : 2; }
};

}  // namespace seiche
