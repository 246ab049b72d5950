#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solver/choice.hpp"
#include "solver/degree_of_freedom.hpp"
#include "solver/gravity.hpp"
#include "solver/section_plane.hpp"
#include "solver/surface_mesh.hpp"

namespace seiche {

/// Everything that the physics of a run depends on, in SI units. Who fills it in (a scene file, a test) sees to the
/// ranges; `Simulation` checks only what concerns several members at once.
struct Parameters {
  Preset preset = Preset::stabilised;
  Gravity gravity;

  struct Fluid {
    double density = 1000;    ///< rho [kg/m^3]
    double viscosity = 1e-6;  ///< nu, kinematic [m^2/s]
    double depth = 0.2;       ///< still level above the lowest point of the tank [m]
    double column = 0;        ///< length of the liquid from the left wall [m]; 0: the whole tank (a dam break sets it)
    /// Liquid in one chamber of the tank.
    struct Seed {
      double x = 0, y = 0, z = 0;  ///< a point in it [m]
      double depth = 0;            ///< its still level above the lowest point of the tank [m]
    };
    std::vector<Seed> seeds{};  ///< none: all that lies below the level is liquid
    double wave_amplitude = 0;  ///< of a standing wave that the liquid starts in, its surface flat [m]; 0: none
    int wave_mode = 1;          ///< half waves of it along the tank
  } fluid;

  /// Inner measures [m]; those that its shape doesn't have are 0.
  struct Tank {
    TankShape shape = TankShape::box;
    double length = 0.6;     ///< box: along x; membrane: along z (0: the run is 2-D); cylinder: of the shell
    double height = 0.4;     ///< box, membrane: along y
    double width = 0;        ///< box, prism: along z; 0: the run is 2-D
    double breadth = 0;      ///< membrane: along x
    double radius = 0;       ///< cylinder, sphere
    Axis axis = Axis::y;     ///< cylinder: along which it lies or stands
    Head ends = Head::flat;  ///< cylinder
    std::array<double, 2> lower_chamfer{}, upper_chamfer{};  ///< membrane: what each takes off along x and along y
    std::vector<std::array<double, 2>> points{};             ///< prism: (x, y); revolve: (height, radius)
    SurfaceMesh mesh{};                                      ///< mesh: triangles
    std::optional<SectionPlane> section{};                   ///< the run is 2-D, in this plane of a 3-D tank
    bool closed = true;                                      ///< box: with a roof

    /// A thin wall within it: a line in 2-D; in 3-D, or where a section is taken, a rectangle or a disc; or upright
    /// across the tank, up from its lowest point. What tells the others is empty or 0.
    struct Baffle {
      std::vector<std::array<double, 2>> points{};   ///< of the line that it follows
      double thickness = 0;                          ///< 0: none
      double x = 0, height = 0;                      ///< of one across the tank
      std::vector<std::array<double, 3>> corners{};  ///< of a rectangle: three, or all four
      std::array<double, 3> centre{}, normal{1, 0, 0};
      double radius = 0;                           ///< of a disc
      std::vector<std::array<double, 4>> holes{};  ///< (x, y, z, radius)
    };
    std::vector<Baffle> baffles{};

    /// A flat ring within a 3-D tank.
    struct Ring {
      std::array<double, 3> centre{}, normal{0, 1, 0};
      double inner = 0, outer = 0;  ///< radii; outer = 0: up to the wall
      double thickness = 0;         ///< 0: none
    };
    std::vector<Ring> rings{};

    bool is_body() const;  ///< whether it is 3-D as long as no section is taken
  } tank;

  /// One term of a motion: amplitude sin(2 pi frequency t + phase).
  struct Harmonic {
    DegreeOfFreedom of = DegreeOfFreedom::surge;
    double amplitude = 0;  ///< [m]; of a rotation [degrees]
    double frequency = 0;  ///< [Hz]
    double phase = 0;      ///< [degrees]
  };

  /// A motion as samples of equal count; an empty one stays 0.
  struct TimeSeries {
    std::vector<double> time;                                              ///< [s], ascending
    std::array<std::vector<double>, number_of_degrees_of_freedom> values;  ///< [m]; of a rotation [degrees]

    std::vector<double>& operator[](DegreeOfFreedom f) { return values[static_cast<std::size_t>(f)]; }
    const std::vector<double>& operator[](DegreeOfFreedom f) const { return values[static_cast<std::size_t>(f)]; }
  };

  struct Motion {
    MotionType type = MotionType::none;
    Harmonic harmonic{};  ///< what moves it if the type is `harmonic`
    std::vector<Harmonic> harmonics{};
    double ramp = 0;     ///< the motion grows from nothing over this time [s]
    std::string file{};  ///< CSV of the series; the program reads it into `series`
    TimeSeries series{};
    double pivot_x = 0, pivot_y = 0, pivot_z = 0;  ///< point that the tank turns about, in the tank's frame [m]
    Start start = Start::impulsive;
    MotionAxes axes = MotionAxes::tank;
    TankX tank_x = TankX::none;  ///< of a ship's axes
    RotationOrder rotation_order = RotationOrder::zyx;
    double from = 0;    ///< time of the series at which the run begins [s]
    bool hold = false;  ///< before the first sample of the series and after its last the tank stands still
    double cutoff = 0;  ///< the series is smoothed above this frequency [Hz]; 0: it isn't

    /// What scenes call its type: that of one harmonic by what it moves.
    std::string_view type_name() const { return type == MotionType::harmonic ? name(harmonic.of) : name(type); }
  } motion;

  /// A pressure sensor on a wall.
  struct PressureSensor {
    std::string name;            ///< as in "left_bottom": column "p_left_bottom [Pa]"
    double x = 0, y = 0, z = 0;  ///< [m]
    double side = 0;             ///< of the area that it reads, a square centred on the point [m]; 0: the point
    PressureReading reading = PressureReading::mean;
  };

  /// A wave gauge: how far beyond still level the surface crosses a line.
  struct WaveGauge {
    std::string name;                   ///< as in "left": column "eta_left [m]"
    double x = 0, z = 0, y = 0;         ///< a point of the line [m]; y counts where it has a direction
    std::array<double, 3> direction{};  ///< of the line; 0: up, against gravity
    Crossing crossing = Crossing::highest;
  };

  /// Force and moment of the liquid on a part of the wall.
  struct LoadSensor {
    std::string name;               ///< as in "floor": column "force_x_floor [N]"
    std::string on = "tank";        ///< "tank", or a patch of its wall, as in "floor" or "baffle_1"
    std::array<double, 3> about{};  ///< the point of the tank that moments are about [m]
    LoadAxes axes = LoadAxes::tank;
  };

  struct Sensors {
    std::vector<PressureSensor> pressure;  ///< none: one at the left bottom corner
    std::vector<WaveGauge> gauge;          ///< none: one at the left wall, one at the right
    std::vector<LoadSensor> load;
    bool force = true;   ///< on the walls, and moment about the pivot
    bool energy = true;  ///< kinetic and potential
    bool volume = true;  ///< of the liquid, and its centre of mass
  } sensors;

  struct Particles {
    double spacing = 0.005;  ///< l0 [m]
  } particles;

  /// Radii are in units of l0.
  struct Method {
    std::string kernel = "KF3";     ///< KF1 .. KF5, Table 1
    double kf2_alpha = 3.0;         ///< alpha of KF2
    double radius_density = 2.6;    ///< r_e of the number density and the divergence
    double radius_gradient = 2.6;   ///< r_e of the gradient
    double radius_laplacian = 2.6;  ///< r_e of the Laplacian
    /// beta of equation (11), midway between the shares of n0 that the two topmost layers of a lattice have, 0.67 and
    /// 0.98 with KF3 in 2-D: disorder takes neither of them across.
    double surface_beta = 0.82;
    Order order = Order::project_first;
    SourceTerm source = SourceTerm::mixed;
    GradientModel gradient = GradientModel::corrected;
    SurfaceTest surface = SurfaceTest::density_and_count;
    SeparationModel separation = SeparationModel::collide;
    double separation_distance = 0.8;  ///< pairs nearer than this are separated [l0]
    /// Rate of particle shifting [sqrt(g H)/l0]; 0: none. A wave 20 particles deep fades by it as by a viscosity of
    /// 2e-5 m^2/s, at a rate of 1 as by 4e-4; at 0.3 it grows.
    double shift = 0.5;
    ViscousModel viscous = ViscousModel::strain_rate;
    WallModel wall_model = WallModel::ghosts;
    WallSlip wall = WallSlip::free;
  } method;

  struct Pressure {
    SolverName solver = SolverName::amg;
    double tolerance = 1e-4;  ///< relative residual at which an iterative solver stops
    int max_iterations = 2000;
  } pressure;

  struct Time {
    double end = 10;       ///< [s]
    double courant = 0.2;  ///< alpha of equation (18); half of it changes nothing but the run time
    double step = 0;       ///< of every step [s]; 0: by the rule of equation (18)
  } time;

  int threads = 0;  ///< OpenMP threads; 0: one per core

  int dimension() const { return tank.is_body() && !tank.section ? 3 : 2; }
};

inline bool Parameters::Tank::is_body() const {
  switch (shape) {
    case TankShape::box:
    case TankShape::prism:
      return width > 0;
    case TankShape::membrane:
      return length > 0;
    case TankShape::cylinder:
    case TankShape::sphere:
    case TankShape::revolve:
    case TankShape::mesh:
      break;
  }
  return true;
}

}  // namespace seiche
