#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "apps/scene/options.hpp"
#include "render/check_look.hpp"
#include "render/curves.hpp"
#include "render/picture.hpp"
#include "solver/operators/kernels.hpp"

namespace seiche::apps {
namespace {

Choices kernels() {
  Choices names;
  for (const auto& kernel : solver::kernel_table(1.0)) names.push_back(solver::name(kernel));
  return names;
}

// The access to an enum of the scene by its values' names.
template <auto member>
Chosen chosen() {
  using E = std::remove_cvref_t<decltype(member(std::declval<Scene&>()))>;
  std::vector<std::string_view> meanings;
  for (const Choice<E>& row : ChoiceTable<E>::rows) meanings.push_back(row.help);
  return {[](const Scene& s) { return std::string(name(member(s))); },
          [](Scene& s, std::string_view text) { member(s) = value_named<E>(text); }, meanings};
}

// The type of a motion: one harmonic is known by the degree of freedom that it moves.
Choices motion_types() {
  Choices all{name(MotionType::none)};
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) all.push_back(row.name);
  all.insert(all.end(), {name(MotionType::harmonics), name(MotionType::file)});
  return all;
}

void set_motion_type(Scene& s, std::string_view text) {
  Parameters::Motion& motion = s.parameters.motion;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (row.name == text) motion.type = MotionType::harmonic, motion.harmonic.of = row.value;
  for (const Choice<MotionType>& row : ChoiceTable<MotionType>::rows)
    if (row.name == text) motion.type = row.value;
}

Chosen motion_type() {
  std::vector<std::string_view> meanings;
  for (const std::string_view type : motion_types()) {
    for (const DegreeOfFreedomRow& row : degrees_of_freedom)
      if (row.name == type) meanings.push_back(row.help);
    for (const Choice<MotionType>& row : ChoiceTable<MotionType>::rows)
      if (row.name == type) meanings.push_back(row.help);
  }
  return {[](const Scene& s) { return std::string(s.parameters.motion.type_name()); }, set_motion_type, meanings};
}

std::string get_size(const Scene& s) { return fmt::format("{}x{}", s.look.width, s.look.height); }

void set_size(Scene& s, const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto [x, first] = std::from_chars(text.data(), end, width);
  if (first != std::errc{} || x == end || *x != 'x') throw std::invalid_argument(text);
  const auto [last, second] = std::from_chars(x + 1, end, height);
  if (second != std::errc{} || last != end) throw std::invalid_argument(text);
  render::check_picture_size(width, height);
  std::tie(s.look.width, s.look.height) = std::tuple(width, height);
}

std::string get_range(const Scene& s) { return render::text_of(s.look.range); }

void set_range(Scene& s, const std::string& text) { s.look.range = render::parse_range(text); }

std::string get_curves(const Scene& s) { return render::text_of(s.look.curves); }

void set_curves(Scene& s, const std::string& text) { s.look.curves = render::parse_curves(text); }

const std::string sizes =
    fmt::format("width x height from {0}x{0} to {1}x{1}, as in 1280x720", render::least_size, render::greatest_size);
template <std::size_t kind>
bool& wanted(Scene& s) {
  return s.output.wanted[static_cast<OutputKind>(kind)];
}

// A key for each kind of output, true or false, but for the movie's, which is its format.
template <std::size_t... kinds>
std::vector<Option> output_keys(const Option& movie, std::index_sequence<kinds...>) {
  std::vector<Option> keys;
  for (const Option::Access& access : {Option::Access(&wanted<kinds>)...}) {
    const OutputRow& row = output_rows()[keys.size()];
    keys.push_back(row.kind == OutputKind::movie ? movie : Option{"output", row.key, "", access, {}, row.help});
  }
  return keys;
}

std::string get_section(const Scene& s) {
  return s.parameters.tank.section ? text_of(*s.parameters.tank.section) : "none";
}

void set_section(Scene& s, const std::string& text) {
  s.parameters.tank.section = text == "none" ? std::nullopt : std::optional(parse_section(text));
}

std::string get_unit(const Scene& s) { return s.given.unit ? std::string(name(*s.given.unit)) : "none"; }

void set_unit(Scene& s, std::string_view text) {
  s.given.unit = text == "none" ? std::nullopt : std::optional(value_named<LengthUnit>(text));
}

Choices units() {
  Choices all{"none"};
  for (const Choice<LengthUnit>& row : ChoiceTable<LengthUnit>::rows) all.push_back(row.name);
  return all;
}

Chosen unit() {
  std::vector<std::string_view> meanings{"there is no mesh"};
  for (const Choice<LengthUnit>& row : ChoiceTable<LengthUnit>::rows) meanings.push_back(row.help);
  return {get_unit, set_unit, meanings};
}

template <auto sides>
Several chamfer() {
  return {[](const Scene& s) {
            const auto [x, y] = s.parameters.tank.*sides;
            return x == y ? Numbers{x} : Numbers{x, y};
          },
          [](Scene& s, const Numbers& numbers) {
            s.parameters.tank.*sides = {numbers.front(), numbers.back()};
          }};
}

Numbers get_gravity(const Scene& s) {
  const Gravity& g = s.parameters.gravity;
  return g.is_upright() ? Numbers{g.size()} : Numbers{g[0], g[1], g[2]};
}

void set_gravity(Scene& s, const Numbers& numbers) {
  s.parameters.gravity =
      numbers.size() == 1 ? Gravity(numbers[0]) : Gravity(std::array{numbers[0], numbers[1], numbers[2]});
}

const Written section{get_section, set_section, "none, or a plane as in x=0 or z=0.1"};
const Written size{get_size, set_size, sizes};
const Written range{get_range, set_range, "scene, frame, run, or min,max as in -100,3000, in the quantity's unit"};
const Written curves{get_curves, set_curves, "auto, none, or up to 3 sensors, as in eta_left, p_left_bottom"};

// clang-format off: one key a line reads as the table that it is
#define AT(member) (+[](Scene& s) -> decltype((s.member)) { return s.member; })
#define CHOICE(member)                               \
  chosen < [](auto& s) -> auto& { return s.member; } \
  > (), names<decltype(Scene().member)>()
std::vector<Option> make_options() {
  std::vector<Option> table{
      {"", "preset", "", CHOICE(parameters.preset), "scheme that [method], pressure.solver and courant start from"},
      {"", "gravity", "m/s^2", Several{get_gravity, set_gravity},
       OneOr{{0, greatest_gravity}, 3, Range{-greatest_gravity, greatest_gravity}},
       "along -y, 0: none; or its parts along x, y and z of the tank: a tank that leans starts with a level surface"},

      {"fluid", "density", "kg/m^3", AT(parameters.fluid.density), Range{0, 1e5, true}, "rho"},
      {"fluid", "viscosity", "m^2/s", AT(parameters.fluid.viscosity), Range{0, 1}, "nu, kinematic"},
      {"fluid", "depth", "m", AT(parameters.fluid.depth), Range{0, huge, true},
       "still level above the tank's lowest point; or give fill, fill_height or volume"},
      {"fluid", "fill", "", AT(given.fill), Range{0, 1}, "share of the tank's volume that is liquid; 0: not given"},
      {"fluid", "fill_height", "", AT(given.fill_height), Range{0, 1},
       "still level above the tank's lowest point, over the tank's height; 0: not given"},
      {"fluid", "volume", "m^3, in 2-D m^2", AT(given.volume), Range{0, 1e9}, "of the liquid; 0: not given"},
      {"fluid", "column", "m", AT(parameters.fluid.column), Range{0, huge},
       "length of the liquid from the left wall, for a dam break; 0: the whole tank"},
      {"fluid", "wave_amplitude", "m", AT(parameters.fluid.wave_amplitude), amplitudes,
       "of a standing wave that the liquid starts in, its surface flat; 0: none"},
      {"fluid", "wave_mode", "", AT(parameters.fluid.wave_mode), Range{1, 1000}, "half waves of it along the tank"},

      {"tank", "shape", "", CHOICE(parameters.tank.shape), "what the measures below make; inner ones, all of them"},
      {"tank", "length", "m", AT(parameters.tank.length), Range{0, huge},
       "box: along x; membrane: along z, 0: the run is 2-D; cylinder: of its shell"},
      {"tank", "height", "m", AT(parameters.tank.height), Range{0, huge}, "box, membrane: along y"},
      {"tank", "width", "m", AT(parameters.tank.width), Range{0, huge}, "box, prism: along z; 0: the run is 2-D"},
      {"tank", "breadth", "m", AT(parameters.tank.breadth), Range{0, huge}, "membrane: along x"},
      {"tank", "lower_chamfer", "m", chamfer<&Parameters::Tank::lower_chamfer>(), OneOr{{0, huge}, 2},
       "membrane: along x and y, or one for both"},
      {"tank", "upper_chamfer", "m", chamfer<&Parameters::Tank::upper_chamfer>(), OneOr{{0, huge}, 2},
       "membrane: along x and y, or one for both"},
      {"tank", "radius", "m", AT(parameters.tank.radius), Range{0, huge}, "cylinder, sphere"},
      {"tank", "axis", "", CHOICE(parameters.tank.axis), "cylinder: how it lies or stands"},
      {"tank", "ends", "", CHOICE(parameters.tank.ends), "cylinder: beyond its shell"},
      {"tank", "points", "m", AT(parameters.tank.points), Pairs{{-huge, huge}},
       "prism: its corners (x, y); revolve: its profile (height, radius)"},
      {"tank", "file", "", AT(given.file), Text{},
       "mesh: STL, text or binary; prism, revolve: CSV of the points, columns x [m], y [m] or z [m], r [m] (or in cm, "
       "mm); its path from the scene's folder"},
      {"tank", "unit", "", unit(), units(), "mesh: what its file's numbers are in"},
      {"tank", "section", "", section, {}, "a 2-D run in that plane of a 3-D tank"},
      {"tank", "closed", "", AT(parameters.tank.closed), {}, "box: with a roof"},

      {"motion", "type", "", motion_type(), motion_types(),
       "one degree of freedom: amplitude sin(2 pi frequency t + phase)"},
      {"motion", "amplitude", "m; of a rotation: degrees", AT(parameters.motion.harmonic.amplitude), amplitudes,
       "of the tank's displacement"},
      {"motion", "frequency", "Hz", AT(parameters.motion.harmonic.frequency), Range{0, 100},
       "of the tank's displacement"},
      {"motion", "phase", "degrees", AT(parameters.motion.harmonic.phase), Range{-360, 360},
       "of the tank's displacement at t = 0"},
      {"motion", "ramp", "s", AT(parameters.motion.ramp), Range{0, 1e5},
       "the motion grows from nothing over this time"},
      {"motion", "file", "", AT(parameters.motion.file), Text{},
       "CSV of t [s] and surge [m], roll [deg], ... or their accelerations, an OpenFOAM table or a DualSPHysics path; "
       "its "
       "path from the scene's folder"},
      {"motion", "columns", "", AT(given.columns), Text{},
       "of the file, those that are followed, as in \"sway, roll\"; empty: all. Of a file without titles the names of "
       "its "
       "columns, as in \"t, roll\""},
      {"motion", "from", "s", AT(parameters.motion.from), Range{-1e5, 1e5}, "the file's time at which the run begins"},
      {"motion",
       "hold",
       "",
       AT(parameters.motion.hold),
       {},
       "before the file's first sample and after its last the tank stands still there"},
      {"motion", "cutoff", "Hz", AT(parameters.motion.cutoff), Range{0, 1e5},
       "the file is smoothed: what is as fast as this keeps half its amplitude, what is half as fast 94 %; 0: it "
       "isn't"},
      {"motion", "axes", "", CHOICE(parameters.motion.axes), "that the six degrees of freedom belong to"},
      {"motion", "tank_x", "", CHOICE(parameters.motion.tank_x), "ship axes: where the tank's x points"},
      {"motion", "rotation_order", "", CHOICE(parameters.motion.rotation_order),
       "of several rotations, each about the axis as those before have turned it"},
      {"motion", "pivot_x", "m", AT(parameters.motion.pivot_x), Range{-huge, huge},
       "of the point that the tank turns about, in its frame; it may lie outside"},
      {"motion", "pivot_y", "m", AT(parameters.motion.pivot_y), Range{-huge, huge}, "the same"},
      {"motion", "pivot_z", "m", AT(parameters.motion.pivot_z), Range{-huge, huge}, "the same, of a 3-D tank"},
      {"motion", "start", "", CHOICE(parameters.motion.start),
       "at t = 0 the liquid is at rest in the lab, or moves with the tank"},

      {"sensors", "force", "", AT(parameters.sensors.force), {}, "force on the walls, and moment about the pivot"},
      {"sensors", "energy", "", AT(parameters.sensors.energy), {}, "kinetic and potential energy of the liquid"},
      {"sensors",
       "volume",
       "",
       AT(parameters.sensors.volume),
       {},
       "volume and centre of mass of the liquid, in 3-D its swirl"},

      {"particles", "spacing", "m", AT(parameters.particles.spacing), Range{0, 10, true},
       "l0, between particles at rest"},

      {"method", "kernel", "", AT(parameters.method.kernel), kernels(), "weight function of Table 1"},
      {"method", "kf2_alpha", "", AT(parameters.method.kf2_alpha), Range{0, 100, true}, "alpha of KF2"},
      {"method", "radius_density", "l0", AT(parameters.method.radius_density), Range{1, 10, true},
       "r_e of the number density and the divergence"},
      {"method", "radius_gradient", "l0", AT(parameters.method.radius_gradient), Range{1, 10, true},
       "r_e of the gradient"},
      {"method", "radius_laplacian", "l0", AT(parameters.method.radius_laplacian), Range{1, 10, true},
       "r_e of the Laplacian"},
      {"method", "surface_beta", "", AT(parameters.method.surface_beta), Range{0, 1, true},
       "beta of equation (11): free surface where n < beta n0"},
      {"method", "order", "", CHOICE(parameters.method.order), "when particles move"},
      {"method", "source", "", CHOICE(parameters.method.source), "right-hand side of the pressure equation"},
      {"method", "gradient", "", CHOICE(parameters.method.gradient), "pressure gradient"},
      {"method", "surface", "", CHOICE(parameters.method.surface), "test for the free surface"},
      {"method", "separation", "", CHOICE(parameters.method.separation), "what happens to pairs that come too near"},
      {"method", "separation_distance", "l0", AT(parameters.method.separation_distance), Range{0, 1},
       "pairs nearer than this are separated"},
      {"method", "shift", "sqrt(g H)/l0", AT(parameters.method.shift), Range{0, 2},
       "rate of particle shifting; 0: none"},
      {"method", "viscous", "", CHOICE(parameters.method.viscous), "form of the viscous term"},
      {"method", "wall_model", "", CHOICE(parameters.method.wall_model),
       "what bounds the liquid in the pressure equation"},
      {"method", "wall", "", CHOICE(parameters.method.wall), "what walls do to the viscous term"},

      {"pressure", "solver", "", CHOICE(parameters.pressure.solver),
       "of the pressure equation; amg with preset stabilised, iccg with paper"},
      {"pressure", "tolerance", "", AT(parameters.pressure.tolerance), Range{0, 0.1, true},
       "relative residual at which an iterative solver stops"},
      {"pressure", "max_iterations", "", AT(parameters.pressure.max_iterations), Range{1, 1e6},
       "more in one step end the run"},

      {"time", "end", "s", AT(parameters.time.end), Range{0, 1e5, true}, "simulated time"},
      {"time", "courant", "", AT(parameters.time.courant), Range{0, 1, true},
       "alpha of equation (18): a step is alpha l0 / v_max at most"},
      {"time", "step", "s", AT(parameters.time.step), Range{0, 1},
       "of every step, which must fall on every frame and on the end; 0: by equation (18)"},

      {"output", "probe_rate", "Hz", AT(output.probe_rate), Range{0, 1e6, true},
       "sensor readings per simulated second"},
      {"output", "frame_rate", "Hz", AT(output.frame_rate), Range{0, 1e4, true}, "frames per simulated second"},
      {"output", "size", "pixels", size, {}, "of pictures and movie"},

      {"look", "quantity", "", CHOICE(look.quantity), "that particles are coloured by"},
      {"look", "colour_map", "", CHOICE(look.colour_map), "of a quantity that is a number"},
      {"look", "background", "", CHOICE(look.background), "of the picture"},
      {"look", "style", "", CHOICE(look.style), "how particles are drawn"},
      {"look", "view", "", CHOICE(look.view), "what stands still in the picture"},
      {"look",
       "range",
       "",
       range,
       {},
       "of the colours: one from the scene, each frame's own, or the whole run's (drawn after it)"},
      {"look", "curves", "", curves, {}, "readings drawn under the picture"},
      {"look", "arrows", "", AT(look.show_arrows), {}, "show velocities relative to the tank as arrows; 2-D only"},
      {"look", "walls", "", AT(look.show_walls), {}, "show wall particles"},
      {"look", "surface", "", AT(look.show_surface), {}, "mark free-surface particles; style smooth: draw the surface"},
      {"look", "surface_line", "", AT(look.show_surface_line), {}, "draw the surface instead of marks; 2-D only"},
      {"look", "tank", "", AT(look.show_tank), {}, "show the tank's outline"},
      {"look", "bar", "", AT(look.show_bar), {}, "show the scalar bar"},
      {"look", "clock", "", AT(look.show_clock), {}, "show the simulated time"},
      {"look", "caption", "", AT(look.show_caption), {}, "show scene, kernel and spacing"},
      {"look", "ruler", "", AT(look.show_ruler), {}, "show a ruler in metres"},
  };
  const Option movie{"output", "movie", "", CHOICE(output.movie), output_row(OutputKind::movie).help};
  const auto keys = output_keys(movie, std::make_index_sequence<output_kinds>());
  table.insert(std::ranges::find(table, "output", &Option::section), keys.begin(), keys.end());
  return table;
}
#undef AT
#undef CHOICE
// clang-format on

}  // namespace

const std::vector<Option>& options() {
  static const std::vector<Option> table = make_options();
  return table;
}

}  // namespace seiche::apps
