// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/made_scenes.hpp"

namespace orograph {

namespace {

std::string polyhedron_text(const std::string& faces) {
  return "[part.it]\nshape = 'polyhedron'\nvertices = [[0,0,0], [9,0,0], [0,9,0], [0,0,9]]\n"
         "faces = " +
         faces + "\n[[place]]\npart = 'it'\nat = [200, 200]\n";
}

} // namespace

std::string scene_text(const std::string& place) {
  return "[part.box]\nshape = 'box'\nsize = [20, 20, 30]\n"
         "[part.mast]\nshape = 'wires'\nvertices = [[0,0,0], [0,0,60]]\nlines = [[0,1]]\n\n\n"
         "[[place]]\n" +
         place + "\n";
}

void make_scenes(const MadeFolder& folder) {
  const auto write = [&](const std::string& name, const std::string& place) {
    folder.write(name, scene_text(place));
  };
  write("hut.toml", "part = 'box'\nat = [200, 200]");
  write("off.toml", "part = 'box'\nat = [900, 200]");
  write("gap.toml", "part = 'box'\nat = [175, 225]");
  write("lonlat.toml", "part = 'box'\nlonlat = [10.02, 46.02]");
  write("swapped.toml", "part = 'box'\nlonlat = [46.02, 10.02]");
  write("swapped-at.toml", "part = 'box'\nat = [46.02, 10.02]");
  write("unknown-key.toml", "part = 'box'\nat = [200, 200]\nheigth = 3");
  write("no-part.toml", "part = 'bix'\nat = [200, 200]");
  write("singular.toml", "part = 'box'\nat = [200, 200]\nmap = [{ scale = [1, 0, 1] }]");
  folder.write("circle.toml", "[part.a]\nuses = [{ part = 'b' }]\n[part.b]\nuses = [{ part = 'a' "
                              "}]\n[[place]]\npart = 'a'\nat = [200, 200]\n");
  folder.write("open.toml", polyhedron_text("[[0,2,1], [0,1,3], [1,2,3]]"));
  folder.write("inside-out.toml", polyhedron_text("[[0,1,2], [0,3,1], [1,3,2], [0,2,3]]"));
  folder.write("tetrahedron.off", "OFF\n4 4 0\n0 0 0\n90 0 0\n0 90 0\n0 0 90\n"
                                  "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  folder.write("with-file.toml", "[part.it]\nshape = 'polyhedron'\nfile = 'tetrahedron.off'\n"
                                 "[[place]]\npart = 'it'\nat = [200, 200]\n");
}

} // namespace orograph
