// SPDX-License-Identifier: GPL-3.0-or-later
// The extension module behind the Python package `orograph`: the only file that knows pybind11. The
// package's own functions stand in front of these and say what they take and give.
#include "cli/command_line.hpp"
#include "cli/finish_drawing.hpp"
#include "cli/options/help.hpp"
#include "cli/options/options.hpp"
#include "cli/options/suggest_option.hpp"
#include "cli/report/run_report.hpp"
#include "cli/version.hpp"
#include "dem/read/length_units.hpp"
#include "write/format_text.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <future>
#include <limits>

#include "python/python_words.hpp"
#include "python/views.hpp"

namespace py = pybind11;

namespace orograph {
namespace {

// Of the exception class, for as long as the interpreter is there.
PyObject* error_class = nullptr;

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& error) {
    const py::object python =
        py::reinterpret_borrow<py::object>(error_class)(in_python(error.what()));
    python.attr("wrong") = in_python(error.wrong());
    python.attr("right") = in_python(error.right());
    PyErr_SetObject(error_class, python.ptr());
  }
}

// Runs `work` on a thread of its own, without the interpreter's lock; meanwhile this thread looks
// for Ctrl-C and tells `progress`, so that no Python code runs on any other. Where one of them
// raises, the work is stopped, and what was raised goes on.
template <class Work>
auto while_listening(const Work& work, const py::object& progress) {
  constexpr std::chrono::milliseconds kBetweenLooks{10}; // a stop itself takes some 10 more
  std::stop_source stop;
  std::atomic<double> share{0};
  Control control;
  control.stop = stop.get_token();
  if (!progress.is_none())
    control.progress = [&](double done) { share.store(done, std::memory_order_relaxed); };
  auto result = std::async(std::launch::async, [&] { return work(control); });
  const auto is_done = [&] {
    const py::gil_scoped_release unlocked;
    return result.wait_for(kBetweenLooks) == std::future_status::ready;
  };
  try {
    for (double told = 0; !is_done();) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      const double now = share.load(std::memory_order_relaxed);
      if (now > told) progress(told = now);
    }
  } catch (...) {
    stop.request_stop();
    const py::gil_scoped_release unlocked;
    result.wait();
    throw;
  }
  auto value = result.get();
  if (!progress.is_none()) progress(1.0);
  return value;
}

// Keeps a Python object alive for what has no interpreter's lock when it lets go.
std::shared_ptr<const void> kept_alive(py::object object) {
  return {object.release().ptr(), [](PyObject* kept) {
            if (Py_IsInitialized() == 0) return; // all is gone with the process
            const py::gil_scoped_acquire locked;
            Py_DECREF(kept);
          }};
}

double metres_of(const std::string& unit) {
  if (const auto known = length_unit(unit)) return known->metres;
  throw UsageError(fmt::format("height_unit '{}' can't be used", unit),
                   "give m, ft, us-ft, km, dm, cm or mm");
}

template <class Value>
std::span<const Value> view_of(const py::array& array) {
  return {static_cast<const Value*>(array.data()), static_cast<std::size_t>(array.size())};
}

// REQUIRES two dimensions, float32 or float64 of this machine, rows one behind the other.
std::shared_ptr<Views> views_of_heights(const py::array& heights,
                                        const std::array<double, 6>& transform,
                                        const std::string& crs, std::optional<double> nodata,
                                        const std::string& height_unit, const std::string& name) {
  GridInput input;
  constexpr py::ssize_t kMost = std::numeric_limits<int>::max();
  if (heights.shape(0) > kMost || heights.shape(1) > kMost)
    throw UsageError(fmt::format("z has {} x {} heights", heights.shape(0), heights.shape(1)),
                     fmt::format("give at most {} of each", kMost));
  input.rows = static_cast<int>(heights.shape(0));
  input.columns = static_cast<int>(heights.shape(1));
  if (heights.itemsize() == sizeof(float))
    input.heights = view_of<float>(heights);
  else
    input.heights = view_of<double>(heights);
  input.owner = kept_alive(heights);
  input.geotransform = transform;
  input.crs = crs;
  input.nodata = nodata;
  input.height_unit_m = metres_of(height_unit);
  input.name = name;
  const py::gil_scoped_release unlocked;
  return std::make_shared<Views>(NamedTerrain{Terrain::of(input), {name}});
}

using Doubles = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::uint32_t, py::array::c_style>;

// REQUIRES arrays of three columns.
std::shared_ptr<Views> views_of_triangles(const Doubles& points, const Indices& triangles,
                                          const std::string& crs, const std::string& height_unit,
                                          bool repair, const std::string& name) {
  TinInput input;
  for (py::ssize_t i = 0; i < points.shape(0); ++i)
    input.points.push_back({points.at(i, 0), points.at(i, 1), points.at(i, 2)});
  for (py::ssize_t i = 0; i < triangles.shape(0); ++i)
    input.triangles.push_back({triangles.at(i, 0), triangles.at(i, 1), triangles.at(i, 2)});
  input.crs = crs;
  input.height_unit_m = metres_of(height_unit);
  input.repair = repair;
  input.name = name;
  const py::gil_scoped_release unlocked;
  return std::make_shared<Views>(NamedTerrain{Terrain::of(input), {name}});
}

// The array owns the values.
template <class Value>
py::array array_of(std::vector<Value> values, std::vector<py::ssize_t> shape) {
  auto kept = std::make_unique<std::vector<Value>>(std::move(values));
  const Value* data = kept->data();
  const py::capsule owner(kept.release(),
                          [](void* vector) { delete static_cast<std::vector<Value>*>(vector); });
  return py::array(std::move(shape), data, owner);
}
template <class Value>
py::array column_of(std::vector<Value> values) {
  const auto count = static_cast<py::ssize_t>(values.size());
  return array_of(std::move(values), {count});
}
template <class Point>
py::array points_of(const std::vector<Point>& points) {
  constexpr std::size_t kCoordinates = sizeof(Point) / sizeof(double);
  py::array_t<double> array({points.size(), kCoordinates});
  if (!points.empty())
    std::memcpy(array.mutable_data(), points.data(), points.size() * sizeof(Point));
  return array;
}

py::dict strokes_of(const Drawn& drawn) {
  FlatStrokes flat;
  {
    const py::gil_scoped_release unlocked;
    flat = flat_strokes(drawn.map.drawing);
  }
  py::dict all;
  all["coords"] = points_of(flat.page_mm);
  all["ground"] = flat.map.empty() ? py::object(py::none()) : points_of(flat.map);
  all["offsets"] = column_of(std::move(flat.offsets));
  all["layer"] = column_of(std::move(flat.layer));
  all["profile"] = column_of(std::move(flat.profile));
  all["level"] = column_of(std::move(flat.level));
  all["feature"] = column_of(std::move(flat.feature));
  all["depth"] = column_of(std::move(flat.depth_m));
  all["width_mm"] = column_of(std::move(flat.width_mm));
  all["darkness"] = column_of(std::move(flat.darkness));
  return all;
}

py::list layers_of(const Drawn& drawn) {
  py::list all;
  for (const Layer& layer : drawn.map.drawing.layers) {
    py::list features;
    for (const Attributes& attributes : layer.features) {
      py::dict feature;
      for (const Attribute& attribute : attributes)
        feature[py::str(attribute.name)] = py::cast(attribute.value);
      features.append(feature);
    }
    all.append(py::make_tuple(layer.name, hex_colour(layer), layer.pen_width_mm, layer.is_hidden,
                              layer.strokes.size(), features));
  }
  return all;
}

// What isn't known of a place is NaN.
py::dict columns_of(const std::vector<PlaceSight>& sights) {
  const auto column = [&](const auto& value, bool of_ground) {
    std::vector<double> values;
    for (const PlaceSight& sight : sights) {
      const bool has_none =
          of_ground && (sight.state == PlaceState::gap || sight.state == PlaceState::outside);
      values.push_back(has_none ? std::numeric_limits<double>::quiet_NaN() : value(sight));
    }
    return column_of(std::move(values));
  };
  py::list states;
  for (const PlaceSight& sight : sights) states.append(name_of(sight.state));
  py::dict all;
  all["state"] = states;
  all["hidden_m"] = column([](const PlaceSight& of) { return of.hidden_m; }, true);
  all["hidden_deg"] = column([](const PlaceSight& of) { return of.hidden_deg; }, true);
  all["azimuth_deg"] = column([](const PlaceSight& of) { return of.bearing.azimuth_deg; }, false);
  all["altitude_deg"] = column([](const PlaceSight& of) { return of.bearing.altitude_deg; }, true);
  all["distance_m"] = column([](const PlaceSight& of) { return of.bearing.distance_m; }, false);
  all["height"] = column([](const PlaceSight& of) { return of.height; }, true);
  return all;
}

py::dict columns_of(const std::vector<Skyline::Direction>& directions) {
  const auto column = [&](const auto& value) {
    std::vector<double> values;
    for (const auto& [azimuth_deg, place] : directions)
      values.push_back(place ? value(*place) : std::numeric_limits<double>::quiet_NaN());
    return column_of(std::move(values));
  };
  const auto lonlat = [](const SkylinePlace& of) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return of.lonlat.value_or(Vec2{kUnknown, kUnknown});
  };
  std::vector<double> azimuths_deg;
  py::list at_border;
  for (const auto& [azimuth_deg, place] : directions) {
    azimuths_deg.push_back(azimuth_deg);
    at_border.append(place && place->at_border);
  }
  py::dict all;
  all["azimuth_deg"] = column_of(std::move(azimuths_deg));
  all["altitude_deg"] = column([](const SkylinePlace& of) { return of.bearing.altitude_deg; });
  all["distance_m"] = column([](const SkylinePlace& of) { return of.bearing.distance_m; });
  all["longitude"] = column([&](const SkylinePlace& of) { return lonlat(of).x; });
  all["latitude"] = column([&](const SkylinePlace& of) { return lonlat(of).y; });
  all["x"] = column([](const SkylinePlace& of) { return of.map.x; });
  all["y"] = column([](const SkylinePlace& of) { return of.map.y; });
  all["height"] = column([](const SkylinePlace& of) { return of.height; });
  all["at_border"] = at_border;
  return all;
}

// REQUIRES an array of two columns.
std::vector<Vec2> places_of(const Doubles& points) {
  std::vector<Vec2> places;
  for (py::ssize_t i = 0; i < points.shape(0); ++i)
    places.push_back({points.at(i, 0), points.at(i, 1)});
  return places;
}

py::dict skyline_of(Views& views, const NamedValues& options, const py::object& progress) {
  Skyline skyline = while_listening(
      [&](const Control& control) { return views.skyline(options, control); }, progress);
  py::dict all = columns_of(skyline.directions);
  const auto& far = skyline.most_distant;
  if (far) skyline.directions = {{far->bearing.azimuth_deg, far}};
  all["most_distant"] = far ? py::object(columns_of(skyline.directions)) : py::object(py::none());
  return all;
}

std::string usage_of(const std::string& function) {
  RenderSettings render;
  VisibleSettings visible;
  InfoSettings info;
  Command reading = info_command(info);
  reading.name = "read";
  std::erase_if(reading.options, [](const Option& option) {
    return option.is_positional() || option.name == "--help"; // read has a docstring
  });
  if (function == "visible") return usage_json(sights_command(visible));
  if (function == "horizon") return usage_json(skyline_command(visible));
  return usage_json(function == "read" ? reading : drawing_command(render));
}

int run_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const py::gil_scoped_release released;
  return run_command_line(static_cast<int>(words.size()), argv.data());
}

} // namespace
} // namespace orograph

PYBIND11_MODULE(_orograph, m) {
  using namespace orograph;
  m.attr("__version__") = std::string(kVersion);
  error_class = PyErr_NewExceptionWithDoc(
      "orograph.Error",
      "What is asked for can't be done: `wrong` says what is wrong, `right` what would be right, "
      "the text is both.",
      PyExc_ValueError, nullptr);
  m.attr("Error") = py::reinterpret_borrow<py::object>(error_class);
  py::register_exception_translator(translate);

  m.def("usage", usage_of);
  m.def("in_python", in_python);
  m.def("run_command", run_command);

  py::class_<Drawn, std::shared_ptr<Drawn>>(m, "Drawn")
      .def("strokes", strokes_of)
      .def("layers", layers_of)
      .def_property_readonly("page_mm",
                             [](const Drawn& drawn) {
                               const Page& page = drawn.map.drawing.page;
                               return std::pair(page.width_mm, page.height_mm);
                             })
      .def_property_readonly("title", [](const Drawn& drawn) { return drawn.map.drawing.title; })
      .def_property_readonly("crs_wkt",
                             [](const Drawn& drawn) { return drawn.map.drawing.crs_wkt; })
      .def_property_readonly(
          "format",
          [](const Drawn& drawn) {
            return format_names()[static_cast<std::size_t>(drawn.settings.write.format)];
          })
      .def("is_drawn_for",
           [](const Drawn& drawn, const std::string& format) {
             return draws_alike(drawn.settings.write.format, format_of_name(format));
           })
      .def(
          "report",
          [](const Drawn& drawn) {
            const std::vector<Drawing> pages =
                sheets_and_overview(drawn.map.drawing, drawn.settings);
            return report_text(
                run_report(drawn.map, drawn.settings,
                           std::span(pages).first(pages.empty() ? 0 : pages.size() - 1)));
          },
          py::call_guard<py::gil_scoped_release>())
      .def(
          "svg",
          [](const Drawn& drawn) {
            return text_of_drawing(drawn.map.drawing, {.format = Format::svg});
          },
          py::call_guard<py::gil_scoped_release>());

  py::class_<Views, std::shared_ptr<Views>>(m, "Views")
      .def_property_readonly("crs_wkt",
                             [](const Views& views) { return views.terrain().terrain.crs_wkt(); })
      .def_property_readonly("name",
                             [](const Views& views) { return views.terrain().terrain.name(); })
      .def_property_readonly("notes",
                             [](const Views& views) { return views.terrain().terrain.notes(); })
      .def("another", [](const Views& views) { return std::make_shared<Views>(views.terrain()); })
      .def("draw",
           [](Views& views, const NamedValues& options, const py::object& progress) {
             return while_listening(
                 [&](const Control& control) {
                   return std::make_shared<Drawn>(views.draw(options, control));
                 },
                 progress);
           })
      .def("visible",
           [](Views& views, const Doubles& points, bool lonlat, const NamedValues& options,
              const py::object& progress) {
             const std::vector<Vec2> places = places_of(points);
             return columns_of(while_listening(
                 [&](const Control& control) {
                   return views.sights(options, places, lonlat, control);
                 },
                 progress));
           })
      .def("horizon", skyline_of)
      .def("save", &Views::save, py::call_guard<py::gil_scoped_release>());

  m.def("read", [](const std::vector<std::string>& paths, const NamedValues& options) {
    return while_listening(
        [&](const Control& control) {
          return std::make_shared<Views>(read_terrain_files(paths, options, control));
        },
        py::none());
  });
  m.def("terrain", views_of_heights);
  m.def("tin", views_of_triangles);
}
