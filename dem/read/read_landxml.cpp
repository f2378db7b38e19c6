// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulated surfaces from LandXML, through pugixml.
#include "dem/read/crs_frame.hpp"
#include "dem/read/length_units.hpp"
#include "dem/read/map_shapes.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <unordered_map>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

// As written in a LandXML file; empty where it isn't.
struct LandxmlPlace {
  std::string linear_unit;    ///< Units/*/@linearUnit
  std::string elevation_unit; ///< Units/*/@elevationUnit
  std::string epsg_code, wkt; ///< CoordinateSystem/@epsgCode, @ogcWktCode
};

LengthUnit unit_of(const std::string& written, const std::string& path) {
  const auto unit = length_unit(written);
  if (!unit)
    throw Error(fmt::format("{}: lengths in '{}' can't be brought to metres", path, written),
                "LandXML has meter, foot, USSurveyFoot, kilometer, centimeter, millimeter, inch "
                "and mile");
  return *unit;
}

// "feet" says no more than that the linear unit's foot is meant; it is the schema's default.
void set_height(const std::string& written, MapShapes& shapes) {
  const bool in_feet = std::abs(shapes.map.unit_m - 0.3048) < 1e-5;
  if (written.empty() || (written == "feet" && in_feet)) {
    shapes.map.height_unit_m = shapes.map.unit_m;
    shapes.map.height_unit_name = shapes.map.unit_name;
    return;
  }
  const LengthUnit unit = unit_of(written, shapes.path);
  shapes.map.height_unit_m = unit.metres;
  shapes.map.height_unit_name = unit.name;
}

Crs named_crs(const LandxmlPlace& place) {
  Crs crs;
  std::string code = place.epsg_code;
  if (code.starts_with("EPSG:")) code.erase(0, 5);
  if (!code.empty() && code.find_first_not_of("0123456789") == std::string::npos)
    crs = crs_from_text("EPSG:" + code);
  if (!crs && !place.wkt.empty()) crs = crs_from_text(place.wkt);
  return crs;
}

// Sets `shapes.map`, after the points are read. Throws Error for a unit that isn't known and a CRS
// in degrees.
void set_landxml_frame(const LandxmlPlace& place, MapShapes& shapes) {
  const GdalMessages messages;
  MapFrame& map = shapes.map;
  if (!place.linear_unit.empty()) {
    const LengthUnit unit = unit_of(place.linear_unit, shapes.path);
    map.unit_m = unit.metres;
    map.unit_name = unit.name;
    shapes.units_known = true;
  }
  const Crs crs = named_crs(place);
  if (!crs && !(place.epsg_code.empty() && place.wkt.empty()))
    shapes.notes.push_back(fmt::format(
        "The file's CRS isn't known (epsgCode '{}'): it is left out.", place.epsg_code));
  if (tells_place(crs.get())) {
    MapFrame of_crs;
    const Vec3 centre = shapes.points.empty() ? Vec3{} : shapes.points.front();
    set_crs(of_crs, *crs, shapes.path, FileKind::other, {centre.x, centre.y});
    // Programs mistake the two feet for each other, a matter of 2 mm a kilometre.
    const bool agree = std::abs(of_crs.unit_m / map.unit_m - 1) < 1e-5;
    if (!shapes.units_known || agree) {
      map = of_crs;
      shapes.units_known = true;
    } else {
      shapes.notes.push_back(fmt::format("The file's CRS, {}, is in {} but its coordinates are in "
                                         "{}: the CRS is left out.",
                                         of_crs.crs_name, of_crs.unit_name, map.unit_name));
    }
  }
  set_height(place.elevation_unit, shapes);
}

// Namespaces may have a prefix.
bool is(const pugi::xml_node& node, std::string_view name) {
  std::string_view own = node.name();
  if (const std::size_t colon = own.find(':'); colon != std::string_view::npos)
    own.remove_prefix(colon + 1);
  return own == name;
}

pugi::xml_node child(const pugi::xml_node& node, std::string_view name) {
  return node.find_child([&](const pugi::xml_node& n) { return is(n, name); });
}

Vec3 point_of(const pugi::xml_node& p, const std::string& path) {
  std::string_view text = p.text().get();
  const auto northing = number_of<double>(next_word(text)),
             easting = number_of<double>(next_word(text));
  const auto elevation = number_of<double>(next_word(text));
  const bool finite = northing && easting && elevation && std::isfinite(*northing) &&
                      std::isfinite(*easting) && std::isfinite(*elevation);
  if (!finite || !next_word(text).empty())
    throw Error(fmt::format("{}: point {} is '{:.60}'", path, p.attribute("id").value(),
                            std::string_view(p.text().get())),
                "it must be three numbers: northing, easting, elevation");
  return {*easting, *northing, *elevation};
}

// Points by what they are called.
using Ids = std::unordered_map<std::string_view, std::uint32_t>;

Ids points_in(const pugi::xml_node& definition, MapShapes& shapes) {
  Ids ids;
  for (const pugi::xml_node& points : definition.children()) {
    if (!is(points, "Pnts")) continue;
    for (const pugi::xml_node& p : points.children()) {
      if (!is(p, "P")) continue;
      const std::string_view id = p.attribute("id").value();
      if (!ids.emplace(id, static_cast<std::uint32_t>(shapes.points.size())).second)
        throw Error(fmt::format("{}: two points have the id '{}'", shapes.path, id),
                    "each point of a surface has its own");
      shapes.points.push_back(point_of(p, shapes.path));
    }
  }
  return ids;
}

std::array<std::uint32_t, 3> corners_of(const pugi::xml_node& face, std::size_t number_of_face,
                                        const Ids& ids, const std::string& path) {
  std::string_view text = face.text().get();
  std::array<std::uint32_t, 3> corners{};
  std::size_t count = 0;
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text), ++count) {
    if (count >= 3) continue;
    const auto point = ids.find(word);
    if (point == ids.end())
      throw Error(fmt::format("{}: face {} names the point '{:.40}'", path, number_of_face, word),
                  "the surface has no such point");
    corners[count] = point->second;
  }
  if (count != 3)
    throw Error(fmt::format("{}: face {} has {} corners", path, number_of_face, count),
                "a TIN's faces have three");
  return corners;
}

void read_faces(const pugi::xml_node& definition, const Ids& ids, MapShapes& shapes) {
  std::size_t number_of_face = 0, invisible = 0;
  for (const pugi::xml_node& faces : definition.children()) {
    if (!is(faces, "Faces")) continue;
    for (const pugi::xml_node& face : faces.children()) {
      if (!is(face, "F")) continue;
      ++number_of_face;
      if (face.attribute("i").as_int() == 1) {
        ++invisible;
        continue;
      }
      shapes.triangles.push_back(corners_of(face, number_of_face, ids, shapes.path));
    }
  }
  if (shapes.triangles.empty())
    throw Error(fmt::format("{}: the surface has no visible faces", shapes.path),
                "export it with its triangles, not only with the data that it was made from");
  if (invisible > 0)
    shapes.notes.push_back(fmt::format("{} faces marked as invisible are left out.", invisible));
}

pugi::xml_node surface_of(const pugi::xml_node& root, const std::string& path,
                          const std::string& wanted) {
  std::vector<pugi::xml_node> surfaces;
  std::vector<std::string> names;
  for (const pugi::xml_node& group : root.children())
    for (const pugi::xml_node& surface : group.children())
      if (is(group, "Surfaces") && is(surface, "Surface")) {
        surfaces.push_back(surface);
        names.emplace_back(surface.attribute("name").value());
      }
  if (surfaces.empty())
    throw Error(fmt::format("{} holds no surface", path), "export a surface with its triangles");
  const auto count = std::count(names.begin(), names.end(), wanted);
  if (wanted.empty() && surfaces.size() == 1) return surfaces.front();
  const std::string list = fmt::format("'{}'", fmt::join(names, "', '"));
  if (wanted.empty())
    throw Error(fmt::format("{} holds {} surfaces: {}", path, surfaces.size(), list),
                "name one with `layer`");
  if (count != 1)
    throw Error(fmt::format("{} holds {} surfaces '{}'", path,
                            count == 0 ? "no" : std::to_string(count), wanted),
                fmt::format("its surfaces are {}", list));
  return surfaces[static_cast<std::size_t>(std::find(names.begin(), names.end(), wanted) -
                                           names.begin())];
}

LandxmlPlace place_of(const pugi::xml_node& root) {
  LandxmlPlace place;
  for (const pugi::xml_node& system : child(root, "Units").children()) {
    if (!is(system, "Metric") && !is(system, "Imperial")) continue;
    place.linear_unit = system.attribute("linearUnit").value();
    place.elevation_unit = system.attribute("elevationUnit").value();
  }
  const pugi::xml_node crs = child(root, "CoordinateSystem");
  place.epsg_code = crs.attribute("epsgCode").value();
  place.wkt = crs.attribute("ogcWktCode").value();
  return place;
}

std::size_t line_at(const std::string& path, std::ptrdiff_t offset) {
  std::ifstream file(path, std::ios::binary);
  std::size_t line = 1;
  for (char c = 0; offset > 0 && file.get(c); --offset) line += c == '\n';
  return line;
}

} // namespace

MapShapes read_landxml(const std::string& path, const std::string& surface) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_file(path.c_str());
  if (!parsed)
    throw Error(fmt::format("{} isn't whole XML ({}, line {})", path, parsed.description(),
                            line_at(path, parsed.offset)),
                "export it again");
  const pugi::xml_node root = document.document_element();
  if (!is(root, "LandXML"))
    throw Error(fmt::format("{} isn't LandXML but '{}'", path, root.name()),
                "give a LandXML file, or layers that GDAL reads");

  MapShapes shapes;
  shapes.path = path;
  const pugi::xml_node definition = child(surface_of(root, path, surface), "Definition");
  const std::string_view type = definition.attribute("surfType").value();
  if (!definition || type != "TIN")
    throw Error(definition ? fmt::format("{}: the surface is of type '{}'", path, type)
                           : fmt::format("{}: the surface has no triangles", path),
                "export it as a TIN (Definition surfType=\"TIN\")");
  const Ids ids = points_in(definition, shapes);
  read_faces(definition, ids, shapes);
  set_landxml_frame(place_of(root), shapes);
  return shapes;
}

} // namespace orograph
