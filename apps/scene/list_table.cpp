#include "apps/scene/lists.hpp"

namespace seiche::apps {
namespace {

std::string get_moved(const Scene& s, std::size_t row) {
  return std::string(name(s.parameters.motion.harmonics[row].of));
}

void set_moved(Scene& s, std::size_t row, std::string_view text) {
  for (const DegreeOfFreedomRow& known : degrees_of_freedom)
    if (known.name == text) s.parameters.motion.harmonics[row].of = known.value;
}

Choices movable() {
  Choices names;
  for (const DegreeOfFreedomRow& known : degrees_of_freedom) names.push_back(known.name);
  return names;
}

// The access to an enum of a list's tables by its values' names.
template <auto member>
ChosenInRow chosen() {
  using E = std::remove_cvref_t<decltype(member(std::declval<Scene&>(), 0))>;
  return {[](const Scene& s, std::size_t k) { return std::string(name(member(s, k))); },
          [](Scene& s, std::size_t k, std::string_view text) { member(s, k) = value_named<E>(text); }};
}

}  // namespace

// clang-format off: one key a line reads as the table that it is
#define ROWS(rows) [](const Scene& s) { return s.rows.size(); }, [](Scene& s, std::size_t n) { s.rows.assign(n, {}); }
#define AT(rows, member) (+[](Scene& s, std::size_t k) -> decltype((s.rows[k].member)) { return s.rows[k].member; })
#define CHOICE(rows, member)                                                \
  chosen < [](auto& s, std::size_t k) -> auto& { return s.rows[k].member; } \
  > (), names<decltype(Scene().rows[0].member)>()
const std::vector<List>& lists() {
  static const std::vector<List> table{
      {"fluid",
       "seed",
       "liquid in one chamber of the tank: what lies below its level and is open to that point; none: all that lies "
       "below the level of [fluid]",
       ROWS(parameters.fluid.seeds),
       {
           {"x", "m", AT(parameters.fluid.seeds, x), Range{-huge, huge}, ""},
           {"y", "m", AT(parameters.fluid.seeds, y), Range{-huge, huge}, ""},
           {"z", "m", AT(parameters.fluid.seeds, z), Range{-huge, huge}, ""},
           {"depth", "m", AT(parameters.fluid.seeds, depth), Range{0, huge},
            "its still level above the lowest point of the tank; 0: that of [fluid]"},
       }},
      {"motion",
       "harmonic",
       "a term amplitude sin(2 pi frequency t + phase) of motion.type = \"harmonics\"",
       ROWS(parameters.motion.harmonics),
       {
           {"of", "", ChosenInRow{get_moved, set_moved}, movable(),
            "what it moves, along or about an axis of motion.axes"},
           {"amplitude", "m; of a rotation: degrees", AT(parameters.motion.harmonics, amplitude), amplitudes, ""},
           {"frequency", "Hz", AT(parameters.motion.harmonics, frequency), Range{0, 100}, ""},
           {"phase", "degrees", AT(parameters.motion.harmonics, phase), Range{-360, 360}, "at t = 0"},
       }},
      {"tank",
       "baffle",
       "a thin wall within the tank that liquid flows round and over: one of points, x with height, corners, or centre "
       "with "
       "radius",
       ROWS(parameters.tank.baffles),
       {
           {"points", "m", AT(parameters.tank.baffles, points), Pairs{{-huge, huge}},
            "2-D: (x, y) of the line that it follows"},
           {"x", "m", AT(parameters.tank.baffles, x), Range{-huge, huge}, "of an upright one across the tank"},
           {"height", "m", AT(parameters.tank.baffles, height), Range{0, huge},
            "of that one's top, above the tank's lowest point"},
           {"corners", "m", AT(parameters.tank.baffles, corners), Tuples{{-huge, huge}, 3},
            "3-D: (x, y, z) of a rectangle's corners, three in their order or all four"},
           {"centre", "m", AT(parameters.tank.baffles, centre), Tuple{{-huge, huge}, 3}, "3-D: (x, y, z) of a disc"},
           {"normal", "", AT(parameters.tank.baffles, normal), Tuple{{-huge, huge}, 3}, "square to that disc"},
           {"radius", "m", AT(parameters.tank.baffles, radius), Range{0, huge}, "of that disc"},
           {"holes", "m", AT(parameters.tank.baffles, holes), Tuples{{-huge, huge}, 4},
            "3-D: (x, y, z, radius) of round holes through it"},
           {"thickness", "m", AT(parameters.tank.baffles, thickness), Range{0, huge}, "half on each side; 0: none"},
       }},
      {"tank",
       "ring",
       "a flat ring within a 3-D tank, such as a ring baffle of an upright one; a 2-D run has what its section cuts of "
       "it",
       ROWS(parameters.tank.rings),
       {
           {"centre", "m", AT(parameters.tank.rings, centre), Tuple{{-huge, huge}, 3}, "(x, y, z)", true},
           {"normal", "", AT(parameters.tank.rings, normal), Tuple{{-huge, huge}, 3}, "its axis"},
           {"inner", "m", AT(parameters.tank.rings, inner), Range{0, huge, true}, "radius of its opening", true},
           {"outer", "m", AT(parameters.tank.rings, outer), Range{0, huge}, "radius; 0: up to the wall"},
           {"thickness", "m", AT(parameters.tank.rings, thickness), Range{0, huge}, "half on each side; 0: none"},
       }},
      {"sensors",
       "pressure",
       "a pressure sensor, on the nearest wall if that is within l0/2, or inside the tank; none: one at the left "
       "bottom corner of a box, at the lowest point of another tank",
       ROWS(parameters.sensors.pressure),
       {
           {"name", "", AT(parameters.sensors.pressure, name), Name{},
            "as in left_bottom: column \"p_left_bottom [Pa]\"", true},
           {"x", "m", AT(parameters.sensors.pressure, x), Range{-huge, huge}, ""},
           {"y", "m", AT(parameters.sensors.pressure, y), Range{-huge, huge}, ""},
           {"z", "m", AT(parameters.sensors.pressure, z), Range{-huge, huge}, ""},
           {"from", "m", RowKey::from, Vector{{-huge, huge}},
            "in place of x, y and z: a row of sensors NAME_1, NAME_2, ... that begins there"},
           {"to", "m", RowKey::to, Vector{{-huge, huge}}, "where that row ends"},
           {"count", "", RowKey::count, Range{2, 1000}, "of its sensors, evenly apart"},
           {"side", "m", AT(parameters.sensors.pressure, side), Range{0, huge},
            "of the square that it reads, centred on the point; 0: the point"},
           {"reading", "", CHOICE(parameters.sensors.pressure, reading),
            "what it makes of the square: column \"p_NAME [Pa]\" or \"p_max_NAME [Pa]\""},
       }},
      {"sensors",
       "gauge",
       "a wave gauge, a line along which the surface is found; none: one at the left wall and one at the right, in "
       "tanks that are no boxes a tenth of the waterline from its ends",
       ROWS(parameters.sensors.gauge),
       {
           {"name", "", AT(parameters.sensors.gauge, name), Name{}, "as in left: column \"eta_left [m]\"", true},
           {"x", "m", AT(parameters.sensors.gauge, x), Range{-huge, huge}, ""},
           {"y", "m", AT(parameters.sensors.gauge, y), Range{-huge, huge}, "of a point on a line with a direction"},
           {"z", "m", AT(parameters.sensors.gauge, z), Range{-huge, huge}, ""},
           {"direction", "", AT(parameters.sensors.gauge, direction), Vector{{-huge, huge}},
            "of the line through that point, as far as it goes within the tank; 0: up, against gravity"},
           {"crossing", "", CHOICE(parameters.sensors.gauge, crossing),
            "highest: the end of the topmost liquid on the line; lowest: of that which begins at its lower end"},
           {"from", "m", RowKey::from, Vector{{-huge, huge}},
            "in place of x, y and z: a row of sensors NAME_1, NAME_2, ... that begins there"},
           {"to", "m", RowKey::to, Vector{{-huge, huge}}, "where that row ends"},
           {"count", "", RowKey::count, Range{2, 1000}, "of its sensors, evenly apart"},
       }},
      {"sensors",
       "load",
       "force and moment of the liquid on a part of the wall",
       ROWS(parameters.sensors.load),
       {
           {"name", "", AT(parameters.sensors.load, name), Name{}, "as in floor: columns \"force_x_floor [N]\", ...",
            true},
           {"on", "", AT(parameters.sensors.load, on), Text{},
            "tank: all of the wall; or a patch of it, as in floor or baffle"},
           {"about", "m", AT(parameters.sensors.load, about), Vector{{-huge, huge}},
            "the point of the tank that moments are about"},
           {"axes", "", CHOICE(parameters.sensors.load, axes), "tank: those of the tank; lab: those of the lab"},
       }},
      {"look",
       "reference",
       "a series drawn over a sensor's curve, for comparison",
       ROWS(look.references),
       {
           {"of", "", AT(look.references, of), Text{}, "the sensor without its unit, as in eta_left", true},
           {"label", "", AT(look.references, label), Text{}, "what the picture calls it; empty: the file's name"},
           {"file", "", AT(look.references, file), Text{},
            "CSV with a column t or t [s], its path from the scene's folder", true},
           {"column", "", AT(look.references, column), Text{}, "of the file; empty: named as the sensor"},
           {"from", "s", AT(look.references, from), Range{0, 1e5}, "what comes before it isn't shown"},
       }},
  };
  return table;
}
#undef CHOICE
#undef AT
#undef ROWS
// clang-format on

}  // namespace seiche::apps
