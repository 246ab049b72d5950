#include "render/picture/colour_map.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::render {
namespace {

// Every fifth of the 256 colours (0xRRGGBB) of each map; straight lines between them are within 4/255 of the rest.
using Table = std::array<std::uint32_t, 52>;

// viridis: S. van der Walt, N. Smith, 2015, https://bids.github.io/colormap (CC0)
constexpr Table viridis{0x440154, 0x46085c, 0x471063, 0x481769, 0x481d6f, 0x482475, 0x472a7a, 0x46307e, 0x453781,
                        0x433d84, 0x414287, 0x3f4889, 0x3d4e8a, 0x3a538b, 0x38598c, 0x355e8d, 0x33638d, 0x31688e,
                        0x2e6d8e, 0x2c718e, 0x2a768e, 0x297b8e, 0x27808e, 0x25848e, 0x23898e, 0x218e8d, 0x20928c,
                        0x1f978b, 0x1e9c89, 0x1fa188, 0x21a585, 0x24aa83, 0x28ae80, 0x2eb37c, 0x35b779, 0x3dbc74,
                        0x46c06f, 0x50c46a, 0x5ac864, 0x65cb5e, 0x70cf57, 0x7cd250, 0x89d548, 0x95d840, 0xa2da37,
                        0xb0dd2f, 0xbddf26, 0xcae11f, 0xd8e219, 0xe5e419, 0xf1e51d, 0xfde725};

// cividis: J. R. Nunez, C. R. Anderton, R. S. Renslow, PLOS ONE 13(7) e0199239, 2018, doi:10.1371/journal.pone.0199239
constexpr Table cividis{0x00224e, 0x002656, 0x002a5f, 0x002d68, 0x003070, 0x083370, 0x163770, 0x203a6f, 0x273e6e,
                        0x2e416d, 0x34456c, 0x3a486c, 0x3f4c6c, 0x444f6c, 0x49536c, 0x4e566c, 0x535a6d, 0x575d6d,
                        0x5c616e, 0x60646f, 0x656870, 0x696b71, 0x6d6f72, 0x727274, 0x767676, 0x7a7a78, 0x7e7d78,
                        0x838179, 0x888578, 0x8d8878, 0x928c78, 0x969077, 0x9b9476, 0xa09875, 0xa59c74, 0xaaa073,
                        0xafa471, 0xb5a86f, 0xbaac6d, 0xbfb06b, 0xc4b468, 0xc9b965, 0xcfbd62, 0xd4c15f, 0xdac65b,
                        0xdfca57, 0xe5cf52, 0xead34c, 0xf0d846, 0xf6dd3f, 0xfce236, 0xfee838};

// cool-warm: K. Moreland, Diverging Color Maps for Scientific Visualization, ISVC 2009, doi:10.1007/978-3-642-10520-3_9
constexpr Table cool_warm{0x3b4cc0, 0x4055c8, 0x465ecf, 0x4c66d6, 0x536edd, 0x5977e3, 0x5f7fe8, 0x6687ed, 0x6c8ff1,
                          0x7396f5, 0x7a9df8, 0x81a4fb, 0x88abfd, 0x8fb1fe, 0x96b7ff, 0x9dbdff, 0xa3c2fe, 0xaac7fd,
                          0xb1cbfc, 0xb7cff9, 0xbed2f6, 0xc4d5f3, 0xcad8ef, 0xcfdaea, 0xd5dbe5, 0xdadce0, 0xdfdbd9,
                          0xe4d9d2, 0xe9d5cb, 0xedd2c3, 0xf0cdbb, 0xf2c9b4, 0xf5c4ac, 0xf6bea4, 0xf7b89c, 0xf7b194,
                          0xf7aa8c, 0xf6a385, 0xf59c7d, 0xf39475, 0xf08b6e, 0xed8366, 0xe97a5f, 0xe57058, 0xe16751,
                          0xdc5d4a, 0xd65244, 0xd0473d, 0xca3b37, 0xc32e31, 0xbb1b2c, 0xb40426};

// turbo: A. Mikhailov, Turbo, An Improved Rainbow Colormap for Visualization, Google AI blog, 2019 (Apache-2.0)
constexpr Table turbo{0x30123b, 0x36215f, 0x3b2f80, 0x3f3e9c, 0x424bb5, 0x4559cb, 0x4666dd, 0x4773eb, 0x4680f6,
                      0x458cfd, 0x4099ff, 0x38a5fb, 0x2fb2f4, 0x27bee9, 0x1fc9dd, 0x1ad4d0, 0x18ddc2, 0x1ae4b6,
                      0x22ebaa, 0x2ff19b, 0x3ff68a, 0x52fa7a, 0x65fd69, 0x79fe59, 0x8bff4b, 0x9cfe40, 0xa9fb39,
                      0xb7f735, 0xc3f134, 0xd0ea34, 0xdbe236, 0xe5d938, 0xeecf3a, 0xf5c53a, 0xfaba39, 0xfdae35,
                      0xfea130, 0xfe932a, 0xfc8423, 0xf9751d, 0xf46617, 0xef5811, 0xe84b0c, 0xe14109, 0xd83706,
                      0xce2d04, 0xc32503, 0xb71d02, 0xa91601, 0x9b0f01, 0x8b0902, 0x7a0403};

const Table& table_of(ColourMapName name) {
  switch (name) {
    case ColourMapName::cividis:
      return cividis;
    case ColourMapName::cool_warm:
      return cool_warm;
    case ColourMapName::turbo:
      return turbo;
    case ColourMapName::viridis:
      break;
  }
  return viridis;
}

}  // namespace

ColourMap::ColourMap(ColourMapName name) : table_(table_of(name)) {}

Rgb ColourMap::operator()(double t) const {
  // Written so that a NaN ends at 0.
  const double place = (t > 0 ? std::min(t, 1.0) : 0.0) * static_cast<double>(table_.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), table_.size() - 2);
  const double weight = place - static_cast<double>(first);
  Rgb colour{};
  for (int c = 0; c < 3; ++c) {
    const auto channel = [&](std::uint32_t rgb) { return static_cast<double>((rgb >> (16 - 8 * c)) & 0xff); };
    const double value = (1 - weight) * channel(table_[first]) + weight * channel(table_[first + 1]);
    colour[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(std::lround(value));
  }
  return colour;
}

}  // namespace seiche::render
