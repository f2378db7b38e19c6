# Makes one C++ source of the devices' files.
# usage: cmake "-DFILES=a.toml;b.toml" -DOUT=known_devices.cpp -P embed_devices.cmake
set(rows "")
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${file}" text)
  string(APPEND rows "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE "${OUT}" "// Written by embed_devices.cmake.
#include \"write/known_devices.hpp\"

#include <array>

namespace orograph {

std::span<const KnownDevice> known_devices() {
  static constexpr KnownDevice devices[] = {
${rows}  };
  return devices;
}

} // namespace orograph
")
